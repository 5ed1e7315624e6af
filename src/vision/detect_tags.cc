// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vision/detect_tags.h"

#include "fathom/base/input_error.h"
#include "fathom/vision/edge_refinement.h"

#include <fmt/format.h>

namespace fathom {

TagDetections DetectTags(FrameSource& frames,
                         const CameraModel& camera,
                         const MarkerMap& map,
                         const TagDetectorOptions& options,
                         const std::function<void(int done, int expected)>& progress) {
  const double largest_angle = LargestAngle(camera);
  TagDetector detector(map.Families(), options);
  TagDetections result;
  result.num_expected = frames.num_expected();
  for (ImageFrame frame; frames.Next(&frame);) {
    FrameDetections found =
        DetectionsAmong(detector.Detect(frame.image), map, options.max_hamming, frame.time);
    if (options.refine_edges) {
      for (Detection& detection : found.detections) {
        const auto corners = FollowSides(frame.image, camera, largest_angle, detection.corners);
        if (corners) {
          detection.corners = *corners;
        } else {
          ++result.num_not_followed;
        }
      }
    }
    result.frame_times.push_back(frame.time);
    if (found.detections.empty()) ++result.num_frames_without_tags;
    result.detections.insert(
        result.detections.end(), found.detections.begin(), found.detections.end());
    result.unused.insert(result.unused.end(), found.unused.begin(), found.unused.end());
    if (progress) progress(static_cast<int>(result.frame_times.size()), result.num_expected);
  }
  result.num_unreadable = frames.num_unreadable();
  result.unreadable = frames.unreadable();
  if (result.frame_times.empty()) {
    throw InputError(fmt::format(
        "none of {} frames can be read: {}",
        result.num_expected,
        result.unreadable.empty() ? "the video holds none." : result.unreadable.front()));
  }
  return result;
}

}  // namespace fathom
