// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/track/detection_screen.h"
#include "fathom/track/view_pose.h"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// The camera's pose in one frame.
struct TrackedView {
  double time = 0.0;  // [s]
  ViewPose pose;
  std::vector<int> detections;  // those it rests on, as indices among all detections

  // The pose that was chosen is not the one that fits the corners of this frame best: the frames
  // around it contradict that one.
  bool is_flip_resolved = false;

  // Another pose fits the corners of this frame almost as well: the sum of squares differs by less
  // than 9 corner variances.
  bool is_ambiguous = false;
};

// The camera's poses over a record, and what became of every frame and detection.
struct PoseTrack {
  std::vector<TrackedView> views;  // by time; one for each frame with a pose

  // Standard deviation of a corner's u and v in most frames, from the residuals, and its own error
  // [px]. That of one view is so many times its noise scale. NaN without views.
  double corner_sigma = std::numeric_limits<double>::quiet_NaN();
  double corner_sigma_std = std::numeric_limits<double>::quiet_NaN();

  int num_frames = 0;
  int num_frames_without_tags = 0;         // nothing was detected
  std::vector<double> times_without_pose;  // something was, but no pose came of it [s]
  int num_detections = 0;
  std::vector<RejectedDetection> rejected;  // by index
};

struct PoseTrackOptions {
  // The file of the detections or frames, as in messages.
  std::string name = "detections";

  // The stamps of all frames [s], so that those without tags count; empty: not known.
  std::vector<double> frame_times;

  // While the corner sigma is not known yet, detections further off than this are outliers [px].
  double first_gate = 20.0;

  // Where the search for the corner sigma starts [px]; absent: what half of the frames show.
  std::optional<double> first_corner_sigma = {};

  // Then: rms residual of a detection's corners in corner sigmas.
  double gate = 4.0;

  // Residuals of a corner beyond so many corner sigmas count linearly.
  double huber = 3.0;
};

// The camera's poses from its detections, by PnP frame by frame; docs/vision.md. Markers that are
// not surveyed are set aside. Throws InputError as ScreenDetections does.
//
//   corner sigma^2 = sum of squared residuals / noise scale^2 / (2 per corner - 6 per pose)
//
// so that with a single marker each frame tells it with two degrees of freedom. It holds whatever
// the corners do not agree on: noise, but also a wrong lens, marker or survey.
PoseTrack TrackPoses(std::span<const Detection> detections,
                     const CameraModel& camera,
                     const MarkerMap& map,
                     const PoseTrackOptions& options = {});

// The track's result in sentences, one for each kind of loss; empty if nothing was lost.
std::vector<std::string> RemarksOn(const PoseTrack& track, std::span<const Detection> detections);

}  // namespace fathom
