// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/track_overlay.h"

#include "fathom/base/plural.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

// Where the track puts the corners of a marker; nothing where its place is not known.
void AddPredicted(const Detection& detection,
                  const CameraModel& camera,
                  const MarkerMap& map,
                  const Pose& world_from_camera,
                  OverlayFrame* frame) {
  const Marker* marker = map.Find(detection.tag_id);
  if (marker == nullptr || !marker->is_surveyed) return;
  const Pose camera_from_tag = world_from_camera.Inverse() * marker->world_from_tag;
  const auto corners_in_tag = CornersInTag(marker->size);
  std::array<Eigen::Vector2d, 4> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d x_camera = camera_from_tag * corners_in_tag[i];
    if (camera.lens != LensModel::kEquidistant && !(x_camera.z() > 0.0)) return;
    corners[i] = Project(camera, x_camera);
  }
  frame->predicted.push_back(corners);
}

}  // namespace

std::vector<std::string> DrawOverlay(FrameSource& frames,
                                     const CameraModel& camera,
                                     const std::optional<TagDetections>& images,
                                     std::span<const Detection> detections,
                                     const MarkerTrack& track,
                                     OverlayWriter* overlay,
                                     const std::function<void(int done, int expected)>& progress) {
  const int num_frames =
      images ? static_cast<int>(images->frame_times.size()) : frames.num_expected();
  std::map<int, Rejection> rejection_of;
  for (const RejectedDetection& it : track.pnp.rejected) rejection_of[it.index] = it.reason;
  std::size_t next_detection = 0, next_unused = 0, next_pose = 0;
  const auto& poses = track.world_from_camera;
  int index = 0;
  std::vector<double> times_without_frame;  // of detections
  for (ImageFrame image; frames.Next(&image); ++index) {
    while (next_pose < poses.size() && poses[next_pose].time < image.time) ++next_pose;
    const bool has_pose = next_pose < poses.size() && poses[next_pose].time == image.time;
    OverlayFrame frame;
    frame.image = &image.image;
    for (; next_detection < detections.size() && detections[next_detection].time <= image.time;
         ++next_detection) {
      const Detection& detection = detections[next_detection];
      if (detection.time != image.time) {
        times_without_frame.push_back(detection.time);
        continue;
      }
      const auto rejection = rejection_of.find(static_cast<int>(next_detection));
      if (rejection == rejection_of.end()) {
        frame.detections.push_back(detection);
      } else {
        frame.rejected.push_back({detection, rejection->second});
      }
      if (has_pose) AddPredicted(detection, camera, track.map, poses[next_pose].pose, &frame);
    }
    while (images && next_unused < images->unused.size() &&
           images->unused[next_unused].time <= image.time) {
      frame.unused.push_back(images->unused[next_unused++]);
    }
    frame.caption =
        fmt::format("t {:.2f} s, {}", image.time, Plural(frame.detections.size(), "tag"));
    if (has_pose) {
      const Eigen::Vector3d& p = track.world_from_body[next_pose].pose.translation;
      frame.caption += fmt::format(", x {:.2f} y {:.2f} z {:.2f} m, rms {:.2f} px",
                                   p.x(),
                                   p.y(),
                                   p.z(),
                                   track.frame_rms[next_pose]);
    } else {
      frame.caption += ", no pose";
    }
    if (overlay->Wants(index, num_frames)) overlay->Add(frame);
    progress(index + 1, num_frames);
  }
  for (; next_detection < detections.size(); ++next_detection) {
    times_without_frame.push_back(detections[next_detection].time);
  }

  std::vector<std::string> remarks;
  if (!images) remarks = frames.unreadable();
  if (!times_without_frame.empty()) {
    remarks.push_back(fmt::format(
        "{}: {} of {} detections are not drawn, the first at t = {}: their stamps are of no frame "
        "that can be read.",
        frames.name(),
        times_without_frame.size(),
        detections.size(),
        times_without_frame.front()));
  }
  return remarks;
}

}  // namespace fathom
