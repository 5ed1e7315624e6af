// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/marker_map.h"

#include <algorithm>
#include <cstddef>

namespace fathom {
namespace {

// The tag's z axis points into the wall: the camera must be on the other side.
bool FacesTheCamera(const Pose& camera_from_tag) {
  return camera_from_tag.Inverse().translation.z() < 0.0;
}

}  // namespace

const Marker* MarkerMap::Find(int id) const {
  const auto found = std::find_if(
      markers.begin(), markers.end(), [id](const Marker& marker) { return marker.id == id; });
  return found == markers.end() ? nullptr : &*found;
}

std::vector<std::string> MarkerMap::Families() const {
  std::vector<std::string> families;
  for (const Marker& marker : markers) {
    if (std::find(families.begin(), families.end(), marker.family) == families.end()) {
      families.push_back(marker.family);
    }
  }
  return families;
}

std::array<Eigen::Vector3d, 4> CornersInTag(double size) {
  const double h = 0.5 * size;
  return {Eigen::Vector3d(-h, h, 0.0),
          Eigen::Vector3d(h, h, 0.0),
          Eigen::Vector3d(h, -h, 0.0),
          Eigen::Vector3d(-h, -h, 0.0)};
}

std::vector<Detection> ObserveCorners(const CameraModel& camera,
                                      const MarkerMap& map,
                                      const Pose& world_from_camera,
                                      double time) {
  const Pose camera_from_world = world_from_camera.Inverse();
  std::vector<Detection> detections;
  for (const Marker& marker : map.markers) {
    if (!marker.is_surveyed) continue;
    const Pose camera_from_tag = camera_from_world * marker.world_from_tag;
    if (!FacesTheCamera(camera_from_tag)) continue;
    const auto corners_in_tag = CornersInTag(marker.size);
    Detection detection;
    detection.time = time;
    detection.tag_id = marker.id;
    bool is_seen = true;
    for (std::size_t i = 0; i < corners_in_tag.size() && is_seen; ++i) {
      const Eigen::Vector3d corner_in_camera = camera_from_tag * corners_in_tag[i];
      is_seen = IsInView(camera, corner_in_camera);
      if (is_seen) detection.corners[i] = Project(camera, corner_in_camera);
    }
    if (is_seen) detections.push_back(detection);
  }
  return detections;
}

}  // namespace fathom
