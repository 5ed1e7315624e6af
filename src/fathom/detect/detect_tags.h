// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/detect/detection_filter.h"
#include "fathom/detect/tag_detector.h"
#include "fathom/images/frame_source.h"

#include <functional>
#include <string>
#include <vector>

namespace fathom {

// What was found in the frames of a log, and what was not.
struct TagDetections {
  std::vector<double> frame_times;    // of every frame that could be read [s]
  std::vector<Detection> detections;  // in the order of the frames, then by id
  std::vector<UnusedSighting> unused;

  int num_expected = 0;    // frames that the log lists, or its video holds or announces
  int num_unreadable = 0;  // of these
  std::vector<std::string> unreadable;

  // What was beside the frames and not read, a sentence each.
  std::vector<std::string> remarks;

  // Of `detections`: with corners as libapriltag has them, since their sides could not be followed.
  int num_not_followed = 0;

  std::vector<double> times_without_tags;      // nothing was seen [s]
  std::vector<double> times_with_unused_only;  // something was, but nothing that is used [s]
};

// Looks for the map's markers in all frames; with options.refine_edges the corners are those of
// FollowSides(), where it finds any. `progress` is told after each frame how many are done,
// of num_expected; it may be empty. Throws InputError as the frames and the detector do, and if no
// frame at all can be read.
TagDetections DetectTags(FrameSource& frames,
                         const CameraModel& camera,
                         const MarkerMap& map,
                         const TagDetectorOptions& options,
                         const std::function<void(int done, int expected)>& progress = {});

// What was not read of the log, how many frames could not be and how many show no tag that is used,
// what was seen and is not used, by reason and tag, and how many corners are less accurate than the
// others; a sentence each, empty if nothing was lost. `map`: that of DetectTags().
std::vector<std::string> RemarksOn(const TagDetections& found, const MarkerMap& map);

}  // namespace fathom
