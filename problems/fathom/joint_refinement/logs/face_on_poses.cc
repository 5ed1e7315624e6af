// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/logs/face_on_poses.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/camera/camera_rig.h"
#include "fathom/camera/detections_file.h"
#include "fathom/joint_refinement/joint_refinement.h"
#include "fathom/joint_refinement/logs/camera_segments.h"
#include "fathom/marker_trajectory/marker_trajectory.h"
#include "fathom/signal/sources/log_column.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

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

// The poses made of all frames together. None where they are better as they are, nor where nothing
// came of it: then `why`.
struct Refined {
  std::vector<StampedPose> poses = {};
  std::size_t num_tracked = 0;  // frames with a pose before
  std::string why = {};
};

// Throws InputError if the calibration is missing or cannot be used.
Refined RefineTogether(Dof dof, const Log& log, const std::function<void(int, int)>& on_round) {
  const CameraRig rig = ReadCameraRig(log.path);
  const std::vector<Detection> detections = DetectionsOf(*log.detections);
  MarkerTrajectoryOptions options;
  options.pose_track.name = FileOf(log, "detections.csv");
  MarkerTrack track = TrackMarkers(detections, rig.camera, rig.map, rig.body_from_camera, options);
  if (!MovesAlongTheSight(dof, detections, track)) return {};
  JointInput input = {.dof = dof,
                      .camera = rig.camera,
                      .map = track.map,
                      .body_from_camera = rig.body_from_camera,
                      .segments = CutIntoSegments(detections, track).segments};
  if (input.segments.empty()) return {};
  const JointSummary summary = FitJoint(input, {.moves_freely = true, .on_round = on_round});
  if (!summary.IsUsable()) return {.why = summary.message};
  Refined refined = {.num_tracked = track.world_from_body.size()};
  for (std::size_t r = 0; r < input.segments.size(); ++r) {
    for (std::size_t k = 0; k < input.segments[r].time.size(); ++k) {
      refined.poses.push_back(
          {.time = input.segments[r].time[k], .pose = summary.segments[r].world_from_body[k]});
    }
  }
  return refined;
}

}  // namespace

void RefineFaceOnPoses(Dof dof, Log* log, const std::function<void(int, int)>& on_round) {
  const auto remark = std::find_if(log->remarks.begin(), log->remarks.end(), [](const Remark& one) {
    return one.kind == RemarkKind::kLostMotion;
  });
  if (!log->detections || !log->pose || remark == log->remarks.end()) return;
  Refined refined;
  try {
    refined = RefineTogether(dof, *log, on_round);
  } catch (const InputError& error) {  // its calibration; the poses there are will do
    refined.why = error.what();
  }
  if (!refined.why.empty()) {
    log->remarks.push_back(
        {RemarkKind::kDetections,
         fmt::format("detections.csv: The frames are not refined together: {}", refined.why)});
  }
  if (refined.poses.empty()) return;
  log->pose = PoseStreamOf(refined.poses);
  *remark = {RemarkKind::kDetections,
             fmt::format("detections.csv: {} of {} poses are refined together, assuming that the "
                         "DOFs other than {} are held. Frame by frame, the noise of the single "
                         "marker's tilt would hide some of the motion.",
                         refined.poses.size(),
                         refined.num_tracked,
                         Name(dof))};
}

}  // namespace fathom
