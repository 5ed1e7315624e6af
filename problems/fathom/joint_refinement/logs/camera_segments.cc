// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/logs/camera_segments.h"

#include "fathom/signal/split_at_gaps.h"

#include <algorithm>

namespace fathom {
namespace {

CameraSegment SegmentIn(const SampleRange& range,
                        std::span<const Detection> detections,
                        const MarkerTrack& track) {
  CameraSegment segment;
  for (std::size_t k = range.begin; k < range.end; ++k) {
    const TrackedView& view = track.pnp.views[k];
    segment.time.push_back(view.time);
    segment.world_from_body.push_back(track.world_from_body[k].pose);
    auto& seen = segment.detections.emplace_back();
    for (const int i : view.detections) seen.push_back(detections[i]);
  }
  return segment;
}

// Silences between the frames that may be refined; none counts before the first of them.
int CountSilences(std::span<const SampleRange> ranges) {
  auto range = std::ranges::find(ranges, false, &SampleRange::is_held_out);
  if (range != ranges.end()) ++range;
  return static_cast<int>(
      std::count_if(range, ranges.end(), [](const SampleRange& r) { return r.is_after_gap; }));
}

}  // namespace

CameraSegments CutIntoSegments(std::span<const Detection> detections,
                               const MarkerTrack& track,
                               double start,
                               std::span<const TimeInterval> held_out) {
  std::vector<double> time;
  for (std::size_t k = 0; k < track.world_from_body.size(); ++k) {
    time.push_back(track.pnp.views[k].time);
  }
  const auto first = std::lower_bound(time.begin(), time.end(), start) - time.begin();
  std::vector<SampleRange> ranges = SplitAtGaps(time, held_out, first);
  CameraSegments cut;
  cut.num_early = static_cast<int>(first);
  cut.num_silences = CountSilences(ranges);
  std::erase_if(ranges, [&](const SampleRange& range) {
    if (range.is_held_out) cut.num_held_out += static_cast<int>(range.size());
    return range.is_held_out;
  });
  const LongRanges kept = WithoutShort(ranges, CameraSegments::kFewestFrames);
  cut.num_short_segments = static_cast<int>(kept.num_short);
  cut.num_in_short_segments = static_cast<int>(kept.num_samples_in_short);
  for (const SampleRange& range : kept.ranges) {
    cut.segments.push_back(SegmentIn(range, detections, track));
  }
  return cut;
}

}  // namespace fathom
