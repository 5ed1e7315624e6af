// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/track_overlay.h"

#include "fathom/base/plural.h"

#include <algorithm>
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

// The elements from `next` on whose stamps are not after `time`; `next` goes behind them.
template <typename Stamped>
std::span<const Stamped> TakeUpTo(double time, std::span<const Stamped> all, std::size_t* next) {
  const std::size_t first = *next;
  while (*next < all.size() && all[*next].time <= time) ++*next;
  return all.subspan(first, *next - first);
}

std::string CaptionOf(double time,
                      std::size_t num_tags,
                      const MarkerTrack& track,
                      const std::optional<std::size_t>& pose) {
  std::string caption = fmt::format("t {:.2f} s, {}", time, Plural(num_tags, "tag"));
  if (!pose) return caption + ", no pose";
  const Eigen::Vector3d& p = track.world_from_body[*pose].pose.translation;
  return caption + fmt::format(", x {:.2f} y {:.2f} z {:.2f} m, rms {:.2f} px",
                               p.x(),
                               p.y(),
                               p.z(),
                               track.frame_rms[*pose]);
}

// Where in the track the pose of a frame is, by their stamps.
std::optional<std::size_t> PoseAt(double time, std::span<const StampedPose> poses) {
  const auto found =
      std::lower_bound(poses.begin(), poses.end(), time, [](const StampedPose& pose, double t) {
        return pose.time < t;
      });
  if (found == poses.end() || found->time != time) return std::nullopt;
  return static_cast<std::size_t>(found - poses.begin());
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
  std::span<const UnusedSighting> unused;
  if (images) unused = images->unused;
  std::size_t next_detection = 0, next_unused = 0;
  std::vector<double> times_without_frame;  // of detections
  int index = 0;
  for (ImageFrame image; frames.Next(&image); ++index) {
    OverlayFrame frame;
    frame.image = &image.image;
    const auto pose = PoseAt(image.time, track.world_from_camera);
    auto detection_index = static_cast<int>(next_detection);
    for (const Detection& detection : TakeUpTo(image.time, detections, &next_detection)) {
      const auto rejection = rejection_of.find(detection_index++);
      if (detection.time != image.time) {
        times_without_frame.push_back(detection.time);
        continue;
      }
      if (rejection == rejection_of.end()) {
        frame.detections.push_back(detection);
      } else {
        frame.rejected.push_back({detection, rejection->second});
      }
      if (pose) {
        AddPredicted(detection, camera, track.map, track.world_from_camera[*pose].pose, &frame);
      }
    }
    const auto sightings = TakeUpTo(image.time, unused, &next_unused);
    frame.unused.assign(sightings.begin(), sightings.end());
    frame.caption = CaptionOf(image.time, frame.detections.size(), track, pose);
    if (overlay->Wants(index, num_frames)) overlay->Add(frame);
    progress(index + 1, num_frames);
  }
  for (const Detection& one : detections.subspan(next_detection)) {
    times_without_frame.push_back(one.time);
  }
  std::vector<std::string> remarks;
  if (!images) remarks = frames.unreadable();
  if (times_without_frame.empty()) return remarks;
  remarks.push_back(
      fmt::format("{}: {} of {} detections are not drawn, the first at t = {}: their stamps are of "
                  "no frame that can be read.",
                  frames.name(),
                  times_without_frame.size(),
                  detections.size(),
                  times_without_frame.front()));
  return remarks;
}

}  // namespace fathom
