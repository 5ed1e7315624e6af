// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/pose_bias.h"

#include "fathom/marker_trajectory/corner_residual.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include <Eigen/Cholesky>
#include <ceres/jet.h>
#include <glog/logging.h>

namespace fathom {
namespace {

using Jet = ceres::Jet<double, 6>;
template <typename T>
using Vector6 = Eigen::Matrix<T, 6, 1>;
template <typename T>
using VectorX = Eigen::Matrix<T, Eigen::Dynamic, 1>;

// The corners of one frame, as functions of the step away from its pose.
class Corners {
 public:
  Corners(const CameraModel& camera,
          const MarkerMap& map,
          std::span<const int> tag_ids,
          const Pose& world_from_camera,
          double corner_sigma) {
    for (const int id : tag_ids) {
      const Marker* const marker = map.Find(id);
      CHECK(marker != nullptr) << "tag " << id << " is not in the map";
      for (const Eigen::Vector3d& corner : CornersInTag(marker->size)) {
        residuals_.push_back({.camera = &camera,
                              .world_from_camera = &world_from_camera,
                              .world_from_tag = &marker->world_from_tag,
                              .corner_in_tag = corner,
                              .pixel = Eigen::Vector2d::Zero(),
                              .corner_sigma = corner_sigma});
      }
    }
  }

  // Where they are drawn, over corner_sigma. Nothing if one is behind the camera.
  template <typename T>
  std::optional<VectorX<T>> operator()(const Vector6<T>& step) const {
    VectorX<T> drawn(2 * residuals_.size());
    for (std::size_t i = 0; i < residuals_.size(); ++i) {
      if (!residuals_[i](step.data(), drawn.data() + 2 * i)) return std::nullopt;
    }
    return drawn;
  }

  // Of a step of zero: rows as drawn. Nothing if one is behind the camera.
  std::optional<Eigen::MatrixXd> Jacobian() const {
    Vector6<Jet> step;
    for (int k = 0; k < 6; ++k) step[k] = Jet(0.0, k);
    const auto drawn = (*this)(step);
    if (!drawn) return std::nullopt;
    Eigen::MatrixXd jacobian(drawn->size(), 6);
    for (Eigen::Index i = 0; i < drawn->size(); ++i) jacobian.row(i) = (*drawn)[i].v;
    return jacobian;
  }

 private:
  std::vector<CornerResidual> residuals_;
};

// The mean of the poses within a second of pose i.
Pose MeanAround(std::span<const StampedPose> track, std::size_t i) {
  constexpr double kReach = 1.0;  // [s]
  const auto is_near = [&](std::size_t k) {
    return std::abs(track[k].time - track[i].time) <= kReach;
  };
  PoseIncrement sum = PoseIncrement::Zero();
  int count = 0;
  const auto add = [&](std::size_t k) {
    sum += StepBetween(track[i].pose, track[k].pose);
    ++count;
  };
  for (std::size_t k = i; k < track.size() && is_near(k); ++k) add(k);
  for (std::size_t k = i; k > 0 && is_near(k - 1); --k) add(k - 1);
  return Moved(track[i].pose, sum / count);
}

}  // namespace

PoseIncrement BiasOfPose(const CameraModel& camera,
                         const MarkerMap& map,
                         std::span<const int> tag_ids,
                         const Pose& world_from_camera,
                         double corner_sigma) {
  if (!(corner_sigma > 0.0)) return PoseIncrement::Zero();
  const Corners corners(camera, map, tag_ids, world_from_camera, corner_sigma);
  const auto jacobian = corners.Jacobian();
  const auto drawn = corners(PoseIncrement(PoseIncrement::Zero()));
  if (!jacobian || !drawn) return PoseIncrement::Zero();
  // With J' J = L L', C = L'^-1 L^-1: its square roots l_k are the columns of L'^-1.
  const Eigen::LLT<PoseCovariance> llt(jacobian->transpose() * *jacobian);
  if (llt.info() != Eigen::Success) return PoseIncrement::Zero();
  const PoseCovariance roots = llt.matrixU().solve(PoseCovariance::Identity());
  Eigen::VectorXd bent = Eigen::VectorXd::Zero(drawn->size());
  for (int k = 0; k < 6; ++k) {
    const PoseIncrement root = roots.col(k);
    const auto ahead = corners(root);
    const auto back = corners(PoseIncrement(-root));
    if (!ahead || !back) return PoseIncrement::Zero();
    bent += *ahead + *back - 2.0 * *drawn;
  }
  const PoseIncrement bias = -0.5 * llt.solve(jacobian->transpose() * bent);
  constexpr double kLargest = 4.0;
  const double length = (*jacobian * bias).norm();
  return bias / std::cbrt(1.0 + std::pow(length / kLargest, 3));
}

void RemoveBias(const CameraModel& camera,
                const MarkerMap& map,
                std::span<const std::vector<int>> tag_ids,
                double corner_sigma,
                std::vector<StampedPose>* track) {
  CHECK_EQ(tag_ids.size(), track->size());
  const std::vector<StampedPose> found = *track;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Pose mean = MeanAround(found, i);
    const PoseIncrement bias = BiasOfPose(camera, map, tag_ids[i], mean, corner_sigma);
    (*track)[i].pose = Moved(found[i].pose, -bias);
  }
}

}  // namespace fathom
