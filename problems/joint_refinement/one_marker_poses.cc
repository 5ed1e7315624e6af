// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/one_marker_poses.h"

#include "fathom/base/median.h"
#include "fathom/joint_refinement/joint_refinement.h"
#include "fathom/marker_trajectory/face_on.h"
#include "fathom/marker_trajectory/marker_trajectory.h"
#include "fathom/signal/log_column.h"
#include "fathom/vision/camera_rig.h"
#include "fathom/vision/detections_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLongestGap = 30.0;       // [s], as SignalsOptions::longest_gap
constexpr std::size_t kFewestFrames = 10;  // of a run

std::vector<CameraRun> RunsOf(const std::vector<Detection>& detections, const MarkerTrack& track) {
  std::vector<CameraRun> runs;
  for (std::size_t k = 0; k < track.world_from_body.size(); ++k) {
    const TrackedView& view = track.pnp.views[k];
    if (runs.empty() || view.time - runs.back().time.back() > kLongestGap) runs.emplace_back();
    CameraRun& run = runs.back();
    run.time.push_back(view.time);
    run.world_from_body.push_back(track.world_from_body[k].pose);
    auto& seen = run.detections.emplace_back();
    for (const int i : view.detections) seen.push_back(detections[i]);
  }
  std::erase_if(runs, [](const CameraRun& run) { return run.time.size() < kFewestFrames; });
  return runs;
}

// Whether the DOF moves the camera towards the markers and away from them, by what its axis and the
// line of sight to a marker have in common, in the median of the detections used.
bool MovesAlongTheSight(Dof dof,
                        const std::vector<Detection>& detections,
                        const MarkerTrack& track) {
  if (IsAngular(dof)) return false;
  constexpr double kCosine = 0.87;  // 30 degrees
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(Index(dof));
  std::vector<double> cosines;
  for (std::size_t k = 0; k < track.world_from_body.size(); ++k) {
    const Eigen::Vector3d camera = track.world_from_camera[k].pose.translation;
    for (const int i : track.pnp.views[k].detections) {
      const Marker* const marker = track.map.Find(detections[i].tag_id);
      if (marker == nullptr) continue;
      const Eigen::Vector3d sight = (marker->world_from_tag.translation - camera).normalized();
      cosines.push_back(std::abs(sight.dot(track.world_from_body[k].pose.rotation * axis)));
    }
  }
  return !cosines.empty() && Median(std::move(cosines)) > kCosine;
}

}  // namespace

void HoldOtherDofs(Dof dof, Log* log) {
  const auto remark = std::find_if(log->remarks.begin(), log->remarks.end(), IsOnLostMotion);
  if (!log->detections || !log->pose || remark == log->remarks.end()) return;
  const CameraRig rig = ReadCameraRig(log->path);
  const std::vector<Detection> detections = DetectionsOf(*log->detections);
  MarkerTrajectoryOptions options;
  options.pose_track.name = FileOf(*log, "detections.csv");
  MarkerTrack track = TrackMarkers(detections, rig.camera, rig.map, rig.body_from_camera, options);
  if (!MovesAlongTheSight(dof, detections, track)) return;
  const std::size_t num_tracked = track.world_from_body.size();
  JointInput input = {.dof = dof,
                      .camera = rig.camera,
                      .map = std::move(track.map),
                      .body_from_camera = rig.body_from_camera,
                      .runs = RunsOf(detections, track)};
  if (input.runs.empty()) return;
  const JointSummary refined = FitJoint(input, {.moves_freely = true});
  if (!refined.IsUsable()) {
    log->remarks.push_back(
        fmt::format("detections.csv: The frames are not refined together: {}", refined.message));
    return;
  }
  std::vector<StampedPose> poses;
  for (std::size_t r = 0; r < input.runs.size(); ++r) {
    for (std::size_t k = 0; k < input.runs[r].time.size(); ++k) {
      poses.push_back({.time = input.runs[r].time[k], .pose = refined.runs[r].world_from_body[k]});
    }
  }
  log->pose = PoseStreamOf(poses);
  *remark = fmt::format(
      "detections.csv: {} of {} poses are refined together, with the DOFs other than {} taken to "
      "be held: frame by frame the noise of the single marker's tilt would take away some of the "
      "motion.",
      poses.size(),
      num_tracked,
      Name(dof));
}

}  // namespace fathom
