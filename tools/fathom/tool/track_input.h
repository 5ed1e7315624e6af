// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_rig.h"
#include "fathom/camera/detection.h"
#include "fathom/detect/detect_tags.h"
#include "fathom/images/frame_source.h"
#include "fathom/log/log.h"
#include "fathom/marker_trajectory/marker_track.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fathom {

// A log that poses are to be made of, with what was found in its images where they are looked at.
struct TrackInput {
  std::filesystem::path folder;
  Log log;
  CameraRig rig;
  std::string name;  // of the file that the detections come from
  std::optional<TagDetections> images;
  std::vector<Detection> detections;

  std::unique_ptr<FrameSource> Frames() const;
};

// The log without detections yet, and without what was said of poses that are made anew now.
// `from_images`: the detections are yet to be made of them. Throws InputError if log or calibration
// cannot be used; one for all files that are missing.
TrackInput ReadTrackInput(const std::filesystem::path& folder, bool from_images);

// No output may take the place of what the log was filmed as: throws InputError, naming the flag.
// `outputs`: flags and files; a file may be empty.
void RequireOtherThanFrames(const TrackInput& input,
                            const std::vector<std::pair<std::string, std::string>>& outputs);

// Frames on another clock than the command's would make a log that no tool reads: throws
// InputError. The clock of detections.csv has been compared by whoever read the log.
void RequireOneClock(const TrackInput& input, const MarkerTrack& track);

}  // namespace fathom
