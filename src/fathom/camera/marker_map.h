// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/geometry/pose.h"

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// One marker on the wall. Tag frame: origin at the centre, x right, y down, z into the wall.
struct Marker {
  int id = 0;
  double size = 0.0;   // side of the square that is detected [m], above 0
  std::string family;  // of libapriltag, "tag36h11"
  Pose world_from_tag;

  // False: its place is not known, and world_from_tag means nothing yet.
  bool is_surveyed = true;
};

// The markers of a log, each id once, also across families: detections tell them apart by id alone.
struct MarkerMap {
  std::vector<Marker> markers;

  // Null if there is no such marker.
  const Marker* Find(int id) const;

  // Each family there is, once, in the order of the markers.
  std::vector<std::string> Families() const;
};

// The corners of a marker in the tag frame, in the order of Detection::corners [m].
std::array<Eigen::Vector3d, 4> CornersInTag(double size);

// What an ideal detector would report of one view: every surveyed marker that faces the camera and
// whose four corners are in view, in the order of the map, without noise. The marker's light margin
// and its size in pixels do not count.
std::vector<Detection> ObserveCorners(const CameraModel& camera,
                                      const MarkerMap& map,
                                      const Pose& world_from_camera,
                                      double time = 0.0);

}  // namespace fathom
