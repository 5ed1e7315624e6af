// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/lost_motion.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kSharePerVariance = 1.5;  // by Monte Carlo, with the poses' own covariances
constexpr double kShareWorthAWord = 0.002;
constexpr double kFramesWorthAWord = 0.1;  // share of frames that lose so much

// The variance of a pose's tilt against the only marker it rests on, both axes together [rad^2];
// 0 if it rests on several.
double TiltVariance(std::span<const Detection> detections,
                    const MarkerTrack& track,
                    std::size_t i) {
  const std::vector<int>& used = track.pnp.views[i].detections;
  if (used.size() != 1) return 0.0;
  const Marker* const marker = track.map.Find(detections[used.front()].tag_id);
  if (marker == nullptr) return 0.0;
  const StampedPose& camera = track.world_from_camera[i];
  const Eigen::Vector3d sight =
      (camera.pose.Inverse() * marker->world_from_tag.translation).normalized();
  const Eigen::Matrix3d turn = camera.covariance.bottomRightCorner<3, 3>();
  return turn.trace() - sight.dot(turn * sight);
}

}  // namespace

LostMotion LostMotionOf(std::span<const Detection> detections, const MarkerTrack& track) {
  LostMotion lost;
  for (std::size_t i = 0; i < track.world_from_camera.size(); ++i) {
    const double variance = TiltVariance(detections, track, i);
    if (!(kSharePerVariance * variance > kShareWorthAWord)) continue;
    lost.tilt_variance += variance;
    ++lost.num_poses;
  }
  if (lost.num_poses > 0) lost.tilt_variance /= lost.num_poses;
  lost.share = kSharePerVariance * lost.tilt_variance;
  return lost;
}

std::string RemarkOnLostMotion(std::span<const Detection> detections, const MarkerTrack& track) {
  const LostMotion lost = LostMotionOf(detections, track);
  const auto num_poses = static_cast<double>(track.world_from_camera.size());
  if (lost.num_poses == 0 || lost.num_poses < kFramesWorthAWord * num_poses) return "";
  return fmt::format(
      "{} poses rest on a single marker whose tilt they know to {:.2g} rad: noise of the tilt "
      "shortens the distance. The correction leaves up to {:.1f} % of the motion towards the "
      "marker. The remaining noise is skewed, and corner sigma and standard deviations are too "
      "small. Several markers, a marker seen at an angle, or the joint refinement avoid this.",
      lost.num_poses,
      std::sqrt(lost.tilt_variance / 2.0),
      100.0 * lost.share);
}

}  // namespace fathom
