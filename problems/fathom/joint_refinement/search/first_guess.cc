// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/first_guess.h"

#include "fathom/base/median.h"
#include "fathom/output_error/initial_guess.h"
#include "fathom/output_error/output_error.h"
#include "fathom/signal/filters/unwrap.h"
#include "fathom/signal/segment_motion.h"

#include <algorithm>

namespace fathom {
namespace {

constexpr size_t kHalfWindow = 4;  // frames on either side of a median

std::vector<double> RunningMedian(const std::vector<double>& values) {
  std::vector<double> result(values.size());
  for (size_t k = 0; k < values.size(); ++k) {
    // As far to either side as there are frames on both.
    const size_t half = std::min({kHalfWindow, k, values.size() - 1 - k});
    result[k] = Median({values.begin() + static_cast<std::ptrdiff_t>(k - half),
                        values.begin() + static_cast<std::ptrdiff_t>(k + half + 1)});
  }
  return result;
}

}  // namespace

std::vector<PoseVector> SteadyPoses(std::span<const Pose> frame_from_body) {
  const size_t n = frame_from_body.size();
  std::vector<PoseVector> eta(n);
  for (size_t k = 0; k < n; ++k) eta[k] = VectorFromPose(frame_from_body[k]);
  for (int i = 0; i < 6; ++i) {
    std::vector<double> values(n);
    for (size_t k = 0; k < n; ++k) values[k] = eta[k][i];
    if (i >= 3) values = Unwrap(values);
    values = RunningMedian(values);
    for (size_t k = 0; k < n; ++k) eta[k][i] = values[k];
  }
  return eta;
}

UncoupledModel<double> FirstModel(const JointInput& input,
                                  const std::vector<std::vector<PoseVector>>& steady) {
  std::vector<Segment> segments;
  for (size_t r = 0; r < input.segments.size(); ++r) {
    const CameraSegment& segment = input.segments[r];
    Poses poses;
    std::vector<double> position;
    for (size_t k = 0; k < steady[r].size(); ++k) {
      const Pose pose = PoseFromVector(steady[r][k]);
      poses.time.push_back(segment.time[k]);
      poses.position.push_back(pose.translation);
      poses.world_from_body.push_back(pose.rotation);
      position.push_back(steady[r][k][Index(input.dof)]);
    }
    SavitzkyGolayOptions filter;
    const double duration = segment.time.back() - segment.time.front();
    const double step = duration / static_cast<double>(segment.time.size() - 1);
    filter.window = ChooseWindow(
        segment.time, position, filter.order, 8.0 * step, std::min(10.0, 0.2 * duration));
    Motion motion = MotionFromPoses(poses, input.dof, position, segment.command, filter);
    segments.push_back(SegmentOf(std::move(motion), segment.command, filter));
  }
  const OutputErrorSummary fit =
      FitOutputError(segments, {.initial_guess = {}, .output = FittedOutput::kPosition});
  return fit.IsUsable() ? fit.model : ChooseInitialGuess(segments).model;
}

}  // namespace fathom
