// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/placement_from_poses.h"

#include "fathom/track/pose_refinement.h"
#include "fathom/track/view_pose.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace fathom {
namespace {

constexpr double kOutlierSquare = 4.0 * 20.0 * 20.0;  // four corners, rms of 20 px

struct Judgement {
  double misfit = 0.0;  // squared distances of all corners, a frame's at most an outlier's [px^2]
  std::size_t num_fit = 0;  // frames that are no outlier
};

Judgement JudgementOf(const CameraModel& camera,
                      const Marker& marker,
                      const std::vector<const PosedFrame*>& judges) {
  Judgement all;
  for (const PosedFrame* judge : judges) {
    const auto corners = SeenCornersOf(marker, judge->detection);
    const double square = SquaredError(camera, corners, judge->world_from_camera) /
                          (judge->noise_scale * judge->noise_scale);
    all.misfit += std::min(square, kOutlierSquare);
    if (square < kOutlierSquare) ++all.num_fit;
  }
  return all;
}

}  // namespace

std::optional<Pose> PlaceMarkerFromPoses(const CameraModel& camera,
                                         double size,
                                         std::span<const PosedFrame> frames) {
  constexpr std::size_t kMost = 24;
  const std::size_t count = std::min(kMost, frames.size());
  std::vector<const PosedFrame*> some;
  for (std::size_t k = 0; k < count; ++k) some.push_back(&frames[k * frames.size() / count]);
  std::optional<Pose> best;
  double least = std::numeric_limits<double>::infinity();
  for (const PosedFrame* frame : some) {
    for (const Pose& square : SolveSquare(camera, size, frame->detection.corners)) {
      Marker marker;
      marker.size = size;
      marker.world_from_tag = frame->world_from_camera * square;
      const Judgement judgement = JudgementOf(camera, marker, some);
      if (2 * judgement.num_fit < count || judgement.misfit >= least) continue;
      least = judgement.misfit;
      best = marker.world_from_tag;
    }
  }
  return best;
}

}  // namespace fathom
