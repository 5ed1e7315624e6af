// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/fit_from.h"

#include "fathom/joint_refinement/motion/global_columns.h"
#include "fathom/joint_refinement/motion/segment_frame.h"
#include "fathom/joint_refinement/problem/corner_rows.h"
#include "fathom/joint_refinement/problem/linear_joint.h"
#include "fathom/joint_refinement/problem/pose_spread.h"
#include "fathom/joint_refinement/search/joint_caveats.h"
#include "fathom/joint_refinement/search/joint_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

int CountOutliers(const JointData& data,
                  const JointUnknowns& unknowns,
                  double corner_sigma,
                  size_t segment) {
  int count = 0;
  for (size_t k = 0; k < data.segments[segment].detections.size(); ++k) {
    const PoseVector eta = PoseAt(data.segments[segment], unknowns.segments[segment], k);
    for (const Detection& detection : data.segments[segment].detections[k]) {
      CornerRows rows;
      const bool is_ahead = EvaluateCorners(data.setup,
                                            unknowns.setup,
                                            *data.segments[segment].map.Find(detection.tag_id),
                                            detection,
                                            eta,
                                            corner_sigma,
                                            false,
                                            &rows);
      if (!is_ahead || rows.residual.squaredNorm() > data.loss_limit) ++count;
    }
  }
  return count;
}

// By how much the excited coordinate of a frame is off what its own corners say, the other five
// being as they are. As the search leaves it, smoothed over time, it would blur jumps.
double OwnStep(const LinearFrame& frame, const std::array<double, 6>& deviation, int excited) {
  const double information = frame.JdJd(excited, excited);
  if (!(information > 0.0)) return 0.0;
  const double slope =
      frame.Jdr[excited] + frame.JdJd.row(excited).dot(PoseVector::Map(deviation.data()));
  return -slope / information;
}

RefinedSegment RefinedSegmentOf(const JointOptions& options,
                                const JointStart& at,
                                const LinearJoint& linear,
                                const LinearSegment& corners,
                                const Pose& world_from_frame,
                                size_t r) {
  const SegmentUnknowns& own = at.unknowns.segments[r];
  const PredictedMotion& motion = at.data.segments[r].motion;
  const int excited = at.data.excited;
  const auto eta_of = [&](size_t k) {
    PoseVector eta = PoseAt(at.data.segments[r], own, k);
    if (options.moves_freely) eta[excited] += OwnStep(corners.frames[k], own.deviation[k], excited);
    return eta;
  };
  RefinedSegment segment;
  segment.start = {own.start[0], own.start[1]};
  for (int j = 0; j < kNumHeld; ++j) {
    std::copy_n(
        own.response.begin() + j * kResponseTerms, kResponseTerms, segment.response[j].begin());
  }
  segment.clock_offset = own.clock_offset;
  if (options.clock_offset_std > 0.0) {
    segment.clock_offset_std = std::sqrt(linear.covariance(r)(kClockColumn, kClockColumn));
  }
  for (size_t k = 0; k < motion.size(); ++k) {
    segment.world_from_body.push_back(world_from_frame * PoseFromVector(eta_of(k)));
    segment.displacement.push_back(motion.displacement(k));
    segment.velocity.push_back(motion.velocity(k));
  }
  segment.pose_covariance = PoseSpread(linear, r, motion, world_from_frame.rotation, eta_of);
  segment.num_outliers = CountOutliers(at.data, at.unknowns, at.processes.corner_sigma, r);
  return segment;
}

int CountDetections(const JointInput& input) {
  int count = 0;
  for (const CameraSegment& segment : input.segments) {
    for (const auto& detections : segment.detections) count += static_cast<int>(detections.size());
  }
  return count;
}

// The model, and the marker size and mount, with what is known of them.
void TakeOverGlobals(const JointOptions& options,
                     const JointUnknowns& unknowns,
                     const LinearJoint& linear,
                     JointSummary* summary) {
  if (!options.moves_freely) {
    summary->model = unknowns.Motion(0).Model();
    Eigen::Vector4d by_log = Eigen::Vector4d::Ones();
    by_log[kInertia] = summary->model.inertia;
    summary->covariance =
        by_log.asDiagonal() * linear.covariance(0).topLeftCorner<4, 4>() * by_log.asDiagonal();
  }
  summary->size_scale = unknowns.setup.size_scale;
  summary->mount = unknowns.setup.mount;
  const auto std_of = [&](int column) { return std::sqrt(linear.covariance(0)(column, column)); };
  if (options.size_scale_std > 0.0) summary->size_scale_std = std_of(kSizeColumn);
  for (int i = 0; i < 6; ++i) {
    const bool is_free = (i < 3 ? options.mount_position_std : options.mount_angle_std) > 0.0;
    if (is_free) summary->mount_std[i] = std_of(kMountColumns + i);
  }
}

// The joint problem with every segment in a frame of its own.
JointSummary FitInFrames(const JointInput& input,
                         const JointOptions& options,
                         StartPoses start,
                         const std::vector<Pose>& world_from_frame,
                         const std::vector<std::vector<Pose>>& frame_from_body) {
  JointSummary summary;
  summary.num_rounds = summary.num_iterations = 0;
  JointStart at = StartOf(input, options, start, world_from_frame, frame_from_body);
  summary.num_detections = CountDetections(input);
  SearchEnd end;
  if (!SearchJoint(options, &at, &end, &summary)) return summary;
  summary.settled = end.processes_settled && end.likelihood_settled;

  std::vector<LinearSegment> segments;
  if (!Linearise(&at.data, at.unknowns, at.processes.corner_sigma, &segments)) {
    summary.converged = false;
    summary.message = "the corners cannot be projected at the end of the search.";
    return summary;
  }
  const LinearJoint linear(segments,
                           PriorsOf(options, at.unknowns, {}),
                           at.processes,
                           at.data.excited,
                           &end.setup.information);
  for (const int i : end.held_at_zero) summary.on_bound[i] = true;
  summary.determined = linear.is_usable();
  if (!summary.determined) {
    summary.message = "the corners do not determine some unknown.";
    return summary;
  }
  TakeOverGlobals(options, at.unknowns, linear, &summary);
  summary.processes = at.processes;
  for (size_t r = 0; r < input.segments.size(); ++r) {
    summary.segments.push_back(
        RefinedSegmentOf(options, at, linear, segments[r], world_from_frame[r], r));
  }
  summary.caveats = CaveatsOn(input, options, at, end, segments, summary);
  return summary;
}

std::vector<Pose> FramesOf(Dof dof, const std::vector<std::vector<Pose>>& world_from_body) {
  std::vector<Pose> frames;
  for (const std::vector<Pose>& poses : world_from_body)
    frames.push_back(SegmentFrameOf(dof, poses));
  return frames;
}

// The largest angle between the axes of a DOF in two sets of frames [rad].
double LargestTurn(Dof dof, const std::vector<Pose>& some, const std::vector<Pose>& others) {
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(Index(dof) % 3);
  double largest = 0.0;
  for (size_t r = 0; r < some.size(); ++r) {
    const double sine = (some[r].rotation * axis).cross(others[r].rotation * axis).norm();
    largest = std::max(largest, std::asin(std::min(1.0, sine)));
  }
  return largest;
}

}  // namespace

JointSummary FitFrom(const JointInput& input, const JointOptions& options, StartPoses start) {
  // The frames follow from the poses, which the search makes better.
  constexpr int kMostSearches = 3;
  constexpr double kSmallTurn = 0.003;  // [rad]; its cosine is 1 to 5e-6
  JointOptions own = options;
  std::vector<std::vector<Pose>> world_from_body;
  for (const CameraSegment& segment : input.segments)
    world_from_body.push_back(segment.world_from_body);
  bool reached_setup = false;
  for (int search = 1;; ++search) {
    const std::vector<Pose> frames = FramesOf(input.dof, world_from_body);
    std::vector<std::vector<Pose>> frame_from_body = world_from_body;
    for (size_t r = 0; r < frames.size(); ++r) {
      for (Pose& pose : frame_from_body[r]) pose = frames[r].Inverse() * pose;
    }
    JointSummary summary = FitInFrames(input, own, start, frames, frame_from_body);
    reached_setup = summary.reached_setup = reached_setup || summary.reached_setup;
    if (!summary.IsUsable() || search == kMostSearches) return summary;
    for (size_t r = 0; r < frames.size(); ++r) {
      world_from_body[r] = summary.segments[r].world_from_body;
    }
    if (LargestTurn(input.dof, frames, FramesOf(input.dof, world_from_body)) < kSmallTurn) {
      return summary;
    }
    own.initial_guess = summary.model;
    start = StartPoses::kTracked;
  }
}

}  // namespace fathom
