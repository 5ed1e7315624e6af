// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fathom {

// What must be known before corners become the poses of a vehicle: its camera, where the camera
// sits on it, and the markers it looks at.
struct CameraRig {
  CameraModel camera;
  MarkerMap map;
  Pose body_from_camera;

  // What the files hold that nobody reads, a sentence each with the file's name.
  std::vector<std::string> remarks = {};
};

// Reads camera.yaml, tags.yaml and mount.yaml of a log folder. Throws InputError if one of them is
// missing or cannot be used.
CameraRig ReadCameraRig(const std::filesystem::path& folder);

}  // namespace fathom
