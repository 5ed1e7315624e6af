// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/face_on.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr const char* kLostMotion = " poses rest on a single marker whose tilt they know to ";
constexpr double kShareWorthAWord = 0.005;
constexpr double kFramesWorthAWord = 0.1;  // share of frames that rest on one marker

struct Tilts {
  int num_frames = 0;     // that rest on one marker
  double variance = 0.0;  // mean over these frames, both axes together [rad^2]
};

Tilts TiltsOf(std::span<const Detection> detections, const MarkerTrack& track) {
  Tilts tilts;
  for (std::size_t i = 0; i < track.world_from_camera.size(); ++i) {
    const std::vector<int>& used = track.pnp.views[i].detections;
    if (used.size() != 1) continue;
    const Marker* marker = track.map.Find(detections[used.front()].tag_id);
    if (marker == nullptr) continue;
    const StampedPose& camera = track.world_from_camera[i];
    const Eigen::Vector3d sight =
        (camera.pose.Inverse() * marker->world_from_tag.translation).normalized();
    const Eigen::Matrix3d turn = camera.covariance.bottomRightCorner<3, 3>();
    tilts.variance += turn.trace() - sight.dot(turn * sight);
    ++tilts.num_frames;
  }
  if (tilts.num_frames > 0) tilts.variance /= tilts.num_frames;
  return tilts;
}

}  // namespace

double LostMotionShare(std::span<const Detection> detections, const MarkerTrack& track) {
  return 15.0 / 4.0 * TiltsOf(detections, track).variance;
}

std::string RemarkOnLostMotion(std::span<const Detection> detections, const MarkerTrack& track) {
  const Tilts tilts = TiltsOf(detections, track);
  const double share = LostMotionShare(detections, track);
  const auto num_poses = static_cast<double>(track.world_from_camera.size());
  if (!(share > kShareWorthAWord) || tilts.num_frames < kFramesWorthAWord * num_poses) return "";
  return fmt::format(
      "{}{}{:.2g} rad: the noise of the tilt "
      "shortens the distance, and motion towards the marker comes out too small by {:.1f} % or "
      "more, inertia and damping along it too large; corner sigma and standard deviations come out "
      "too small. Several markers, one seen at an angle, or the "
      "joint refinement from the corners do not have this.",
      tilts.num_frames,
      kLostMotion,
      std::sqrt(tilts.variance / 2.0),
      100.0 * share);
}

bool IsOnLostMotion(const std::string& remark) {
  return remark.find(kLostMotion) != std::string::npos;
}

}  // namespace fathom
