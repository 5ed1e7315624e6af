// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/joint_refinement.h"

#include "fathom/base/input_error.h"
#include "fathom/joint_refinement/search/failed_assumption.h"
#include "fathom/joint_refinement/search/fit_from.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

void RequireUsable(const JointInput& input, const JointOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(fmt::format("The options of the joint refinement cannot be used: {}",
                                 fmt::join(problems, "; ")));
  }
  if (input.segments.empty()) throw InputError("The joint refinement needs at least one run.");
  for (const CameraSegment& segment : input.segments) {
    const size_t n = segment.time.size();
    if (n < 10 || segment.detections.size() != n || segment.world_from_body.size() != n) {
      throw InputError(
          fmt::format("A run has {} frames, {} lists of detections and {} poses, expected at least "
                      "10 of each and as many of one as of the other.",
                      n,
                      segment.detections.size(),
                      segment.world_from_body.size()));
    }
    for (const auto& detections : segment.detections) {
      for (const Detection& detection : detections) {
        const Marker* const marker = input.map.Find(detection.tag_id);
        if (marker != nullptr && marker->is_surveyed) continue;
        throw InputError(
            fmt::format("A detection at {} s is of tag {}, expected a surveyed one of the map.",
                        detection.time,
                        detection.tag_id));
      }
    }
  }
}

}  // namespace

JointSummary FitJoint(const JointInput& input, const JointOptions& options) {
  RequireUsable(input, options);
  JointSummary summary = FitFrom(input, options, StartPoses::kTracked);
  if (summary.IsUsable() && summary.settled) return summary;
  // A distant marker seen face on hardly tells its tilt, and the frames' own poses are off by more
  // than the search can put right.
  JointSummary other = FitFrom(input, options, StartPoses::kHeldStill);
  if (other.IsUsable() && (other.settled || !summary.IsUsable())) return other;
  if (summary.converged) return summary;
  const bool reached_setup = summary.reached_setup || other.reached_setup;
  if (const std::string why = FailedAssumption(input, options, reached_setup); !why.empty()) {
    summary.message += " " + why;
  }
  return summary;
}

}  // namespace fathom
