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

// Throws InputError, naming all that are missing, if camera.yaml, tags.yaml or mount.yaml is; with
// them what else the caller misses, a file and what it is: "frames.csv (the images)".
void RequireRigFiles(const std::filesystem::path& folder,
                     const std::vector<std::string>& also_missing = {});

// Reads camera.yaml, tags.yaml and mount.yaml of a log folder. Throws InputError if some of them
// are missing or cannot be used.
CameraRig ReadCameraRig(const std::filesystem::path& folder);

}  // namespace fathom
