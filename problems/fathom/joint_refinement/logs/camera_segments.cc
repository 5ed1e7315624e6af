// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/logs/camera_segments.h"

#include <algorithm>

namespace fathom {

CameraSegments CutIntoSegments(std::span<const Detection> detections,
                               const MarkerTrack& track,
                               double start,
                               std::span<const TimeInterval> held_out) {
  const auto is_held_out = [&](double t) {
    return std::any_of(held_out.begin(), held_out.end(), [t](const TimeInterval& interval) {
      return interval.Contains(t);
    });
  };
  CameraSegments cut;
  std::vector<CameraSegment>& segments = cut.segments;
  bool was_held_out = false;
  double last = 0.0;
  for (std::size_t k = 0; k < track.world_from_body.size(); ++k) {
    const TrackedView& view = track.pnp.views[k];
    if (view.time < start) {
      ++cut.num_early;
      continue;
    }
    const bool is_silent = !segments.empty() && view.time - last > CameraSegments::kLongestGap;
    if (is_silent) ++cut.num_silences;
    last = view.time;
    if (is_held_out(view.time)) {
      ++cut.num_held_out;
      was_held_out = true;
      continue;
    }
    if (segments.empty() || is_silent || was_held_out) segments.emplace_back();
    was_held_out = false;
    CameraSegment& segment = segments.back();
    segment.time.push_back(view.time);
    segment.world_from_body.push_back(track.world_from_body[k].pose);
    auto& seen = segment.detections.emplace_back();
    for (const int i : view.detections) seen.push_back(detections[i]);
  }
  std::erase_if(segments, [&](const CameraSegment& segment) {
    if (segment.time.size() >= CameraSegments::kFewestFrames) return false;
    ++cut.num_short_segments;
    cut.num_in_short_segments += static_cast<int>(segment.time.size());
    return true;
  });
  return cut;
}

}  // namespace fathom
