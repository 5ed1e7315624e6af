// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vision/view_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>
#include <opencv2/calib3d.hpp>

namespace fathom {
namespace {

// A point of the world and where it was seen.
struct SeenCorner {
  Eigen::Vector3d x_world;
  Eigen::Vector2d pixel;
};

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

struct RefinedPose {
  Pose world_from_camera;
  PoseCovariance unit_covariance;
};

std::optional<RefinedPose> Refine(const CameraModel& camera,
                                  std::span<const SeenCorner> corners,
                                  Pose pose,
                                  double huber) {
  const ViewResiduals residuals = {camera, pose, corners, huber};
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
  const Pose found = Moved(pose, step);
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

// Squared residuals of a detection's four corners, summed [px^2]; infinite if one is behind.
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

// Both poses of a square seen along these rays, by infinitesimal plane-based pose estimation
// (Collins and Bartoli 2014). OpenCV's corners are ours, in the same order.
std::vector<Pose> SolveByIppe(double size, const std::array<Eigen::Vector2d, 4>& slopes) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pixels;
  for (const Eigen::Vector3d& corner : CornersInTag(size)) {
    points.emplace_back(corner.x(), corner.y(), corner.z());
  }
  for (const Eigen::Vector2d& slope : slopes) pixels.emplace_back(slope.x(), slope.y());
  std::vector<cv::Vec3d> rotations, translations;
  try {
    cv::solvePnPGeneric(points,
                        pixels,
                        cv::Matx33d::eye(),
                        cv::noArray(),
                        rotations,
                        translations,
                        false,
                        cv::SOLVEPNP_IPPE_SQUARE);
  } catch (const cv::Exception&) {
    return {};
  }
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const Eigen::Vector3d phi(rotations[i][0], rotations[i][1], rotations[i][2]);
    const Eigen::Vector3d t(translations[i][0], translations[i][1], translations[i][2]);
    if (!phi.allFinite() || !t.allFinite() || !(t.z() > 0.0)) continue;
    PoseIncrement step;
    step << t, phi;
    poses.push_back(Moved(Pose(), step));
  }
  return poses;
}

std::array<SeenCorner, 4> SeenCornersOf(const Marker& marker, const Detection& detection) {
  const auto corners_in_tag = CornersInTag(marker.size);
  std::array<SeenCorner, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = {marker.world_from_tag * corners_in_tag[i], detection.corners[i]};
  }
  return corners;
}

// Two refined poses are the same minimum if they draw the corners in the same place.
bool IsSameMinimum(const Pose& a, const Pose& b, const PoseCovariance& unit_covariance) {
  constexpr double kSame = 1e-3;  // [px]
  const PoseIncrement step = StepBetween(a, b);
  return step.dot(unit_covariance.ldlt().solve(step)) < kSame * kSame;
}

// A pose that one square of the frame proposes.
struct Candidate {
  Pose world_from_camera;
  int proposer = 0;  // index of the square's detection
};

// Keeps the candidates that fit all detections best, each counting no more than an outlier.
void KeepTheBest(const CameraModel& camera,
                 const std::vector<std::array<SeenCorner, 4>>& seen,
                 double most_square,
                 std::vector<Candidate>* candidates) {
  constexpr std::size_t kMost = 4;
  if (candidates->size() <= kMost) return;
  std::vector<std::pair<double, std::size_t>> scores;
  for (std::size_t k = 0; k < candidates->size(); ++k) {
    double score = 0.0;
    for (const auto& corners : seen) {
      score +=
          std::min(SquaredError(camera, corners, (*candidates)[k].world_from_camera), most_square);
    }
    scores.emplace_back(score, k);
  }
  std::sort(scores.begin(), scores.end());
  std::vector<Candidate> best;
  for (std::size_t k = 0; k < kMost; ++k) best.push_back((*candidates)[scores[k].second]);
  *candidates = std::move(best);
}

}  // namespace

std::vector<Pose> SolveSquare(const CameraModel& camera,
                              double size,
                              const std::array<Eigen::Vector2d, 4>& corners) {
  const double largest_angle = LargestAngle(camera);
  std::array<Eigen::Vector2d, 4> slopes;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto ray = RayOf(camera, corners[i], largest_angle);
    if (!ray || !(ray->z() > 0.0)) return {};
    slopes[i] = ray->head<2>() / ray->z();
  }
  Marker marker;
  marker.size = size;
  Detection detection;
  detection.corners = corners;
  const auto seen = SeenCornersOf(marker, detection);  // the tag frame is the world
  struct Solution {
    Pose camera_from_tag;
    double squared_error;
  };
  std::vector<Solution> solutions;
  std::optional<RefinedPose> first;
  for (const Pose& camera_from_tag : SolveByIppe(size, slopes)) {
    const auto refined =
        Refine(camera, seen, camera_from_tag.Inverse(), std::numeric_limits<double>::infinity());
    if (!refined) continue;
    if (first &&
        IsSameMinimum(
            first->world_from_camera, refined->world_from_camera, first->unit_covariance)) {
      continue;
    }
    if (!first) first = refined;
    solutions.push_back({refined->world_from_camera.Inverse(),
                         SquaredError(camera, seen, refined->world_from_camera)});
  }
  std::stable_sort(solutions.begin(), solutions.end(), [](const Solution& a, const Solution& b) {
    return a.squared_error < b.squared_error;
  });
  std::vector<Pose> poses;
  for (const Solution& solution : solutions) poses.push_back(solution.camera_from_tag);
  return poses;
}

std::vector<ViewPose> SolveView(const CameraModel& camera,
                                const MarkerMap& map,
                                std::span<const Detection> frame,
                                const ViewPoseOptions& options) {
  std::vector<std::vector<Pose>> squares;
  for (const Detection& detection : frame) {
    squares.push_back(SolveSquare(camera, map.Find(detection.tag_id)->size, detection.corners));
  }
  return SolveView(camera, map, frame, squares, options);
}

std::vector<ViewPose> SolveView(const CameraModel& camera,
                                const MarkerMap& map,
                                std::span<const Detection> frame,
                                std::span<const std::vector<Pose>> squares,
                                const ViewPoseOptions& options) {
  std::vector<std::array<SeenCorner, 4>> seen;
  for (const Detection& detection : frame) {
    seen.push_back(SeenCornersOf(*map.Find(detection.tag_id), detection));
  }
  const double gate_square = 4.0 * options.gate * options.gate;
  // One square alone, its tilt known to some degrees, puts those a metre away far off: before all
  // are fitted together nothing within this is an outlier.
  constexpr double kWideGate = 100.0;  // rms [px]
  const double wide_square =
      frame.size() > 1 ? std::max(gate_square, 4.0 * kWideGate * kWideGate) : gate_square;
  const auto explained_by = [&](const Pose& pose, double square) {
    std::vector<int> used;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (SquaredError(camera, seen[i], pose) <= square) used.push_back(static_cast<int>(i));
    }
    return used;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Pose& world_from_tag = map.Find(frame[i].tag_id)->world_from_tag;
    for (const Pose& camera_from_tag : squares[i]) {
      candidates.push_back({world_from_tag * camera_from_tag.Inverse(), static_cast<int>(i)});
    }
  }
  KeepTheBest(camera, seen, wide_square, &candidates);

  std::vector<ViewPose> poses;
  for (const Candidate& candidate : candidates) {
    Pose pose = candidate.world_from_camera;
    std::vector<int> used = explained_by(pose, wide_square);
    std::optional<RefinedPose> refined;
    constexpr int kMostRounds = 5;
    for (int round = 0; round < kMostRounds && !used.empty(); ++round) {
      std::vector<SeenCorner> corners;
      for (const int i : used) corners.insert(corners.end(), seen[i].begin(), seen[i].end());
      // The first fit may hold outliers: none of them may pull more than the gate allows.
      const double huber =
          round == 0 && used.size() > 1 ? std::min(options.huber, options.gate) : options.huber;
      refined = Refine(camera, corners, pose, huber);
      if (!refined) break;
      pose = refined->world_from_camera;
      std::vector<int> next = explained_by(pose, gate_square);
      if (next.empty() && round == 0 && used.size() > 1) {
        pose = candidate.world_from_camera;  // spoilt: from its own square, outwards
        next = {candidate.proposer};
      } else if ((next == used && huber == options.huber) || round + 1 == kMostRounds) {
        break;
      }
      refined.reset();
      used = std::move(next);
    }
    if (!refined || used.empty()) continue;
    ViewPose view;
    view.world_from_camera = refined->world_from_camera;
    view.unit_covariance = refined->unit_covariance;
    view.used = used;
    for (const int i : used) view.squared_error += SquaredError(camera, seen[i], pose);
    view.degrees_of_freedom = 8 * static_cast<int>(used.size()) - 6;
    const bool is_known = std::any_of(poses.begin(), poses.end(), [&](const ViewPose& other) {
      return other.used == view.used &&
             IsSameMinimum(other.world_from_camera, view.world_from_camera, other.unit_covariance);
    });
    if (!is_known) poses.push_back(std::move(view));
  }
  std::stable_sort(poses.begin(), poses.end(), [](const ViewPose& a, const ViewPose& b) {
    if (a.used.size() != b.used.size()) return a.used.size() > b.used.size();
    return a.squared_error < b.squared_error;
  });
  return poses;
}

}  // namespace fathom
