// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/track/view_pose.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// The poses that may explain one frame; none where nothing was seen.
struct FrameCandidates {
  double time = 0.0;       // [s]
  int num_detections = 0;  // a pose that explains fewer leaves the others out
  std::vector<ViewPose> poses;
};

struct PoseChoiceOptions {
  // Standard deviation of a corner's u and v [px], above 0.
  double corner_sigma = 1.0;

  // What it costs to leave out a frame or a detection, and at most a step between two poses: half
  // of a squared distance in standard deviations. A single frame that jumps away and back is left
  // out (2 * most_step > rejection); a true jump is followed. A frame in which several markers
  // agree costs four times as much, and what its best pose costs on top: it is neither left out for
  // the number of its markers, nor for a jump, since what then jumps is the survey of the markers
  // rather than the corners (4 * rejection > 2 * most_step).
  double rejection = 25.0;
  double most_step = 40.0;
};

// Picks one pose for each frame, or none: those that fit their corners and each other best over the
// whole record; docs/vision.md (6), (7).
//
//   minimise  sum e_i^2 / (2 sigma_i^2)  +  sum min(d_ij^2 / 2, most_step)  +  rejections
//
// sigma_i: the corner sigma, times the noise scale of the frame's best pose.
// d_ij: the step from one chosen pose to the next in standard deviations of both poses' errors and
// of the vehicle's own motion over the time between them, whose speed is estimated from the data.
// By dynamic programming; time grows linearly with the frames. Returns the index of the chosen pose
// of each frame.
//
// A camera that keeps its tilt against the marker has two tracks that are alike smooth; the sum of
// the reprojection errors then decides between them.
std::vector<std::optional<int>> ChoosePoses(std::span<const FrameCandidates> frames,
                                            const PoseChoiceOptions& options);

}  // namespace fathom
