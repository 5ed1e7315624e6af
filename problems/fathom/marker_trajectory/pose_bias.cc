// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/pose_bias.h"

#include "fathom/marker_trajectory/bundle/corner_residual.h"

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
          double corner_noise) {
    for (const int id : tag_ids) {
      const Marker* const marker = map.Find(id);
      CHECK(marker != nullptr) << "tag " << id << " is not in the map";
      for (const Eigen::Vector3d& corner : CornersInTag(marker->size)) {
        residuals_.push_back({.camera = &camera,
                              .world_from_camera = &world_from_camera,
                              .world_from_tag = &marker->world_from_tag,
                              .corner_in_tag = corner,
                              .pixel = Eigen::Vector2d::Zero(),
                              .corner_sigma = corner_noise});
      }
    }
  }

  // Where they are drawn, over the noise. Nothing if one is behind the camera.
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

// Pose i without most of its own noise, by the poses about it.
Pose SmoothedPose(std::span<const StampedPose> track, std::size_t i) {
  constexpr double kReach = 1.0;      // [s]
  constexpr double kFarthest = 10.0;  // standard deviations of a turn
  double n = 0.0, t = 0.0, tt = 0.0;
  PoseIncrement sum = PoseIncrement::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  const auto is_near = [&](std::size_t k) {
    return std::abs(track[k].time - track[i].time) <= kReach;
  };
  std::size_t begin = i;
  while (begin > 0 && is_near(begin - 1)) --begin;
  for (std::size_t k = begin; k < track.size() && is_near(k); ++k) {
    const PoseIncrement step = StepBetween(track[i].pose, track[k].pose);
    const Eigen::Vector3d turn = step.tail<3>();
    const Eigen::Matrix3d covariance = track[i].covariance.bottomRightCorner<3, 3>() +
                                       track[k].covariance.bottomRightCorner<3, 3>();
    if (turn.dot(covariance.ldlt().solve(turn)) > kFarthest * kFarthest) continue;
    const double dt = track[k].time - track[i].time;
    n += 1.0, t += dt, tt += dt * dt;
    sum += step;
    moment += dt * step.head<3>();
  }
  PoseIncrement step = sum / n;
  const double spread = n * tt - t * t;
  if (n > 2.0) step.head<3>() = (tt * sum.head<3>() - t * moment) / spread;
  return Moved(track[i].pose, step);
}

}  // namespace

PoseIncrement BiasOfPose(const CameraModel& camera,
                         const MarkerMap& map,
                         std::span<const int> tag_ids,
                         const Pose& world_from_camera,
                         double corner_noise) {
  if (!(corner_noise > 0.0)) return PoseIncrement::Zero();
  const Corners corners(camera, map, tag_ids, world_from_camera, corner_noise);
  const auto jacobian = corners.Jacobian();
  const auto drawn = corners(PoseIncrement(PoseIncrement::Zero()));
  if (!jacobian || !drawn) return PoseIncrement::Zero();
  // With J' J = L L', C = L'^-1 L^-1: its square roots l_k are the columns of L'^-1.
  const Eigen::LLT<PoseCovariance> llt(jacobian->transpose() * *jacobian);
  if (llt.info() != Eigen::Success) return PoseIncrement::Zero();
  const PoseCovariance roots = llt.matrixU().solve(PoseCovariance::Identity());
  Eigen::VectorXd bent = Eigen::VectorXd::Zero(drawn->size());
  constexpr double kStep = 0.05;  // of a standard deviation
  for (int k = 0; k < 6; ++k) {
    const PoseIncrement step = kStep * roots.col(k);
    const auto ahead = corners(step);
    const auto back = corners(PoseIncrement(-step));
    if (!ahead || !back) return PoseIncrement::Zero();
    bent += (*ahead + *back - 2.0 * *drawn) / (kStep * kStep);
  }
  const PoseIncrement bias = -0.5 * llt.solve(jacobian->transpose() * bent);
  if (!bias.allFinite()) return PoseIncrement::Zero();
  constexpr double kLargest = 4.0;
  const double length = (*jacobian * bias).norm();
  return bias / std::cbrt(1.0 + std::pow(length / kLargest, 3));
}

void RemoveBias(const CameraModel& camera,
                const MarkerMap& map,
                std::span<const std::vector<int>> tag_ids,
                double corner_noise,
                std::vector<StampedPose>* track) {
  CHECK_EQ(tag_ids.size(), track->size());
  const std::vector<StampedPose> found = *track;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Pose smoothed = SmoothedPose(found, i);
    const PoseIncrement bias = BiasOfPose(camera, map, tag_ids[i], smoothed, corner_noise);
    (*track)[i].pose = Moved(found[i].pose, -bias);
  }
}

}  // namespace fathom
