// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/place_more_markers.h"

#include "fathom/marker_trajectory/marker_placement.h"
#include "fathom/marker_trajectory/placement_from_poses.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace fathom {
namespace {

// The frames that show a marker without a place.
struct Showing {
  std::vector<std::vector<Detection>> frames;  // its detection, and those of known markers
  std::vector<PosedFrame> posed;               // those whose pose is known without it
};

// Three known markers leave no flip.
bool IsPoseKnown(const TrackedView& view) {
  constexpr std::size_t kFewest = 3;
  return view.detections.size() >= kFewest && !view.is_ambiguous;
}

// By marker.
std::map<int, Showing> FramesWithUnplaced(std::span<const Detection> detections,
                                          const PoseTrack& track,
                                          const MarkerMap& map) {
  std::map<double, const TrackedView*> view_at;
  for (const TrackedView& view : track.views) view_at[view.time] = &view;
  std::map<int, Showing> frames_of;
  for (const RejectedDetection& one : track.rejected) {
    // As an outlier, where a place was tried and taken back.
    const bool is_sound =
        one.reason == Rejection::kNotSurveyed || one.reason == Rejection::kOutlier;
    const Detection& detection = detections[one.index];
    if (!is_sound || map.Find(detection.tag_id)->is_surveyed) continue;
    const auto view = view_at.find(detection.time);
    if (view == view_at.end()) continue;
    std::vector<Detection> frame = {detection};
    for (const int i : view->second->detections) frame.push_back(detections[i]);
    Showing& showing = frames_of[detection.tag_id];
    showing.frames.push_back(std::move(frame));
    if (IsPoseKnown(*view->second)) {
      showing.posed.push_back(
          {view->second->pose.world_from_camera, detection, view->second->pose.noise_scale});
    }
  }
  return frames_of;
}

}  // namespace

bool PlaceMoreMarkers(std::span<const Detection> detections,
                      const CameraModel& camera,
                      const PoseTrack& track,
                      MarkerMap* map) {
  MarkerMap placed = *map;
  for (const auto& [id, showing] : FramesWithUnplaced(detections, track, *map)) {
    constexpr std::size_t kFewestPosed = 5;
    std::optional<Pose> place;
    if (showing.posed.size() >= kFewestPosed) {
      place = PlaceMarkerFromPoses(camera, map->Find(id)->size, showing.posed);
    }
    if (!place) place = PlaceMarker(camera, *map, id, showing.frames);
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
