// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/camera_source.h"

#include "fathom/base/input_error.h"
#include "fathom/camera/camera_rig.h"
#include "fathom/camera/detections_file.h"
#include "fathom/marker_trajectory/marker_trajectory.h"

#include <vector>

#include <fmt/format.h>

namespace fathom {

bool NeedsTracking(const Log& log) { return log.detections && !log.pose; }

void TrackDetections(Log* log) {
  if (!NeedsTracking(*log)) return;
  const CameraRig rig = ReadCameraRig(log->path);
  for (const std::string& remark : rig.remarks) {
    log->remarks.push_back({RemarkKind::kGeneral, remark});
  }
  const std::vector<Detection> detections = DetectionsOf(*log->detections);
  MarkerTrajectoryOptions options;
  options.pose_track.name = (log->path / "detections.csv").string();
  const MarkerTrack track =
      TrackMarkers(detections, rig.camera, rig.map, rig.body_from_camera, options);
  for (const Remark& remark : track.remarks) {
    log->remarks.push_back({remark.kind, "detections.csv: " + remark.text});
  }
  if (track.world_from_body.size() < 2) {
    std::string losses;
    for (const Remark& remark : track.remarks) losses += " " + remark.text;
    throw InputError(
        fmt::format("{}: {} of {} frames with detections gave a pose, expected at least two.{}{}",
                    (log->path / "detections.csv").string(),
                    track.world_from_body.size(),
                    track.pnp.num_frames,
                    track.message.empty() ? "" : " " + track.message,
                    losses));
  }
  log->pose = PoseStreamOf(track.world_from_body);
  log->remarks.push_back(
      {RemarkKind::kDetections,
       fmt::format("detections.csv: {} of {} frames with detections gave a pose (frames without "
                   "a marker are not in the file); corner sigma {:.3g} px.",
                   track.world_from_body.size(),
                   track.pnp.num_frames,
                   track.corner_sigma)});
}

}  // namespace fathom
