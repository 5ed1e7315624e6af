// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/detect/detect_tags.h"
#include "fathom/log/remark.h"
#include "fathom/marker_trajectory/marker_trajectory.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// What fathom_track has to tell of a track.
struct TrackSummary {
  std::string log;

  // Empty if the detections were read from the log instead of from its frames.
  std::optional<TagDetections> images;

  int num_detections = 0;
  int num_frames = 0;                // with their stamps known: all that could be read
  std::vector<double> corner_error;  // of every used corner to where it is drawn [px], rising

  // What was lost on the way from the frames to the poses, and what was decided, a sentence each.
  std::vector<Remark> remarks;

  // Share of all frames that there should be, so also of the unreadable ones.
  double ShareWithPose(const MarkerTrack& track) const;
};

TrackSummary Summarize(const std::string& log,
                       const std::optional<TagDetections>& images,
                       std::span<const Detection> detections,
                       const CameraModel& camera,
                       const MarkerMap& map,
                       const MarkerTrack& track);

// A few lines for a person.
std::string FormatText(const TrackSummary& summary, const MarkerTrack& track);

// Everything, with each frame and detection that was lost (fathom-track-1, docs/file_formats.md).
std::string FormatJson(const TrackSummary& summary,
                       const MarkerTrack& track,
                       std::span<const Detection> detections);

}  // namespace fathom
