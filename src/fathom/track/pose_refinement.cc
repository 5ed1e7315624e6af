// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/track/pose_refinement.h"

#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

namespace fathom {
namespace {

// Residuals [px] of all corners for a step away from a pose: 0 where every corner is seen where it
// is drawn. With Huber's loss as a factor on each corner, the sum of squares is the robust cost.
struct ViewResiduals {
  const CameraModel& camera;
  const Pose& world_from_camera;
  std::span<const SeenCorner> corners;
  double huber;

  int NumResiduals() const { return 2 * static_cast<int>(corners.size()); }

  template <typename T>
  bool operator()(const T* step, T* residuals) const {
    using std::sqrt;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Matrix<T, 3, 1> x_world = corners[i].x_world.cast<T>();
      const Eigen::Matrix<T, 3, 1> x_camera =
          InverseTransformNear(world_from_camera, step, x_world);
      Eigen::Matrix<T, 2, 1> residual;
      if (camera.lens != LensModel::kEquidistant && !(x_camera.z() > 1e-9)) {
        // Behind the camera: no step may lead there.
        residual = Eigen::Matrix<T, 2, 1>(T(1e6), T(1e6));
      } else {
        residual = Project(camera, x_camera) - corners[i].pixel.cast<T>();
      }
      const T square = residual.squaredNorm();
      if (square > huber * huber) {
        const T size = sqrt(square);
        residual *= sqrt(huber * (2.0 * size - huber)) / size;
      }
      residuals[2 * i] = residual[0];
      residuals[2 * i + 1] = residual[1];
    }
    return true;
  }
};

using ViewFunction = ceres::TinySolverAutoDiffFunction<ViewResiduals, Eigen::Dynamic, 6>;

}  // namespace

std::array<SeenCorner, 4> SeenCornersOf(const Marker& marker, const Detection& detection) {
  const auto corners_in_tag = CornersInTag(marker.size);
  std::array<SeenCorner, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = {marker.world_from_tag * corners_in_tag[i], detection.corners[i]};
  }
  return corners;
}

std::optional<RefinedPose> RefinePose(const CameraModel& camera,
                                      std::span<const SeenCorner> corners,
                                      const Pose& start,
                                      double huber) {
  const ViewResiduals residuals = {camera, start, corners, huber};
  const ViewFunction function(residuals);
  ceres::TinySolver<ViewFunction> solver;
  solver.options.max_num_iterations = 100;
  solver.options.function_tolerance = 1e-12;
  solver.options.parameter_tolerance = 1e-12;
  solver.options.gradient_tolerance = 1e-9;
  PoseIncrement step = PoseIncrement::Zero();
  solver.Solve(function, &step);
  if (!step.allFinite() || !std::isfinite(solver.summary.final_cost)) return std::nullopt;

  Eigen::VectorXd values(residuals.NumResiduals());
  Eigen::Matrix<double, Eigen::Dynamic, 6> jacobian(residuals.NumResiduals(), 6);
  // The covariance is about the pose that was found: a step of the step.
  const Pose found = Moved(start, step);
  const ViewResiduals at_found = {camera, found, corners, huber};
  step.setZero();
  const ViewFunction function_at_found(at_found);
  function_at_found(step.data(), values.data(), jacobian.data());
  const Eigen::LDLT<PoseCovariance> information(jacobian.transpose() * jacobian);
  if (!values.allFinite() || information.info() != Eigen::Success || !information.isPositive()) {
    return std::nullopt;
  }
  const PoseCovariance covariance = information.solve(PoseCovariance::Identity());
  if (!covariance.allFinite() || !(covariance.diagonal().minCoeff() > 0.0)) return std::nullopt;
  return RefinedPose{found, covariance};
}

double SquaredError(const CameraModel& camera,
                    std::span<const SeenCorner> corners,
                    const Pose& world_from_camera) {
  const Pose camera_from_world = world_from_camera.Inverse();
  double sum = 0.0;
  for (const SeenCorner& corner : corners) {
    const Eigen::Vector3d x_camera = camera_from_world * corner.x_world;
    if (camera.lens != LensModel::kEquidistant && !(x_camera.z() > 0.0)) {
      return std::numeric_limits<double>::infinity();
    }
    sum += (Project(camera, x_camera) - corner.pixel).squaredNorm();
  }
  return sum;
}

}  // namespace fathom
