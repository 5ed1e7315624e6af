// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"

#include <span>
#include <string_view>
#include <vector>

namespace fathom {

// Why a detection does not count towards a pose.
enum class Rejection {
  kUnknownId,    // no such tag in the map
  kNotSurveyed,  // its tag's place is not known, and could not be estimated
  kRepeatedId,   // its id stands twice in the frame: neither can be told from the other
  kMirrored,     // its corners run clockwise in the image
  kOffImage,     // a corner lies outside the image, or outside the lens' field
  kNoSquare,     // its corners are not convex or have no area
  kOutlier,      // it contradicts the frame's other detections, or the frames before and after
  kBeyondRight,  // a corner 90 degrees or more off the axis, in a frame without a pose
};
inline constexpr int kNumRejections = 8;

// "unknown id", "not surveyed", ...
std::string_view Name(Rejection rejection);

// A detection that was set aside: its index among all detections.
struct RejectedDetection {
  int index = 0;
  Rejection reason = Rejection::kOutlier;
};

// The detections of one frame that may count, as indices among all detections.
struct ScreenedFrame {
  double time = 0.0;  // [s]
  std::vector<int> detections;
};

struct ScreenedDetections {
  std::vector<ScreenedFrame> frames;  // by time; those without detections too
  std::vector<RejectedDetection> rejected;
};

// Groups detections by frame and sets aside those that cannot count whatever the pose, each with
// its reason. `frame_times`: the stamps of all frames, in order, so that those without tags are
// there; empty if only frames with tags are known. Detections must stand in the order of their
// stamps. `name`: of their file, as in messages.
//
// Throws InputError if most detections are mirrored (their corners are in another order, or the
// images are mirrored) or off the image (the calibration is of another size), if stamps go back, if
// a detection's stamp is none of the frames', or a pixel is not finite.
ScreenedDetections ScreenDetections(std::span<const Detection> detections,
                                    const CameraModel& camera,
                                    const MarkerMap& map,
                                    std::span<const double> frame_times = {},
                                    std::string_view name = "detections");

}  // namespace fathom
