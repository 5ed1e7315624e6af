// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"

#include <string>

#include <Eigen/Geometry>

namespace fathom {

// Cameras and markers for the tests of images.

inline CameraModel PlainCamera() {
  CameraModel camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = 600.0;
  camera.fy = 602.0;
  camera.cx = 320.3;
  camera.cy = 238.8;
  return camera;
}

// Straight lines bulge by some 6 px over the image.
inline CameraModel BarrelCamera() {
  CameraModel camera = PlainCamera();
  camera.lens = LensModel::kPlumbBob;
  camera.coefficients = {-0.2, 0.05, 0.001, -0.0005, 0.0};
  return camera;
}

inline CameraModel FisheyeCamera() {
  CameraModel camera = PlainCamera();
  camera.fx = 420.0;
  camera.fy = 421.0;
  camera.lens = LensModel::kEquidistant;
  camera.coefficients = {-0.02, 0.004, -0.001, 0.0};
  return camera;
}

// A marker at the world's origin, its frame the world's.
inline MarkerMap OneMarker(const std::string& family, int id, double size) {
  Marker marker;
  marker.id = id;
  marker.size = size;
  marker.family = family;
  MarkerMap map;
  map.markers = {marker};
  return map;
}

// A camera at a place in the world that looks along the world's z, turned a little about all three
// axes.
inline Pose LookingAt(const Eigen::Vector3d& camera_in_world, double turn) {
  Pose world_from_camera;
  world_from_camera.translation = camera_in_world;
  world_from_camera.rotation =
      Eigen::AngleAxisd(turn, Eigen::Vector3d(0.3, -0.5, 1.0).normalized());
  return world_from_camera;
}

}  // namespace fathom
