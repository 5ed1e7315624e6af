// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/camera_rig.h"

#include "fathom/base/input_error.h"
#include "fathom/camera/camera_file.h"
#include "fathom/camera/mount_file.h"
#include "fathom/camera/tags_file.h"

#include <system_error>

#include <fmt/format.h>

namespace fathom {

CameraRig ReadCameraRig(const std::filesystem::path& folder) {
  const auto require = [&](const char* file, const char* meaning) {
    std::error_code error;
    if (std::filesystem::exists(folder / file, error)) return folder / file;
    throw InputError(
        fmt::format("{}: holds no {} ({}), expected it in a camera log. See docs/file_formats.md.",
                    folder.string(),
                    file,
                    meaning));
  };
  CameraRig rig;
  rig.camera = ReadCameraFile(require("camera.yaml", "the camera's calibration"), &rig.remarks);
  rig.map = ReadTagsFile(require("tags.yaml", "size and place of the markers"));
  rig.body_from_camera = ReadMountFile(require("mount.yaml", "the camera's place on the vehicle"));
  return rig;
}

}  // namespace fathom
