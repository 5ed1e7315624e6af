// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/place_more_markers.h"

#include "fathom/marker_trajectory/marker_placement.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace fathom {
namespace {

// By marker without a place: the frames that show it, with the known markers in them.
std::map<int, std::vector<std::vector<Detection>>> FramesWithUnplaced(
    std::span<const Detection> detections, const PoseTrack& track) {
  std::map<double, const TrackedView*> view_at;
  for (const TrackedView& view : track.views) view_at[view.time] = &view;
  std::map<int, std::vector<std::vector<Detection>>> frames_of;
  for (const RejectedDetection& one : track.rejected) {
    if (one.reason != Rejection::kNotSurveyed) continue;
    const Detection& detection = detections[one.index];
    const auto view = view_at.find(detection.time);
    if (view == view_at.end()) continue;
    std::vector<Detection> frame = {detection};
    for (const int i : view->second->detections) frame.push_back(detections[i]);
    frames_of[detection.tag_id].push_back(std::move(frame));
  }
  return frames_of;
}

}  // namespace

bool PlaceMoreMarkers(std::span<const Detection> detections,
                      const CameraModel& camera,
                      const PoseTrack& track,
                      MarkerMap* map) {
  MarkerMap placed = *map;
  for (const auto& [id, frames] : FramesWithUnplaced(detections, track)) {
    const std::optional<Pose> place = PlaceMarker(camera, *map, id, frames);
    if (!place) continue;
    for (Marker& marker : placed.markers) {
      if (marker.id != id) continue;
      marker.world_from_tag = *place;
      marker.is_surveyed = true;
    }
  }
  const auto is_placed = [&](const Marker& marker) {
    return marker.is_surveyed && !map->Find(marker.id)->is_surveyed;
  };
  const bool any = std::any_of(placed.markers.begin(), placed.markers.end(), is_placed);
  *map = std::move(placed);
  return any;
}

}  // namespace fathom
