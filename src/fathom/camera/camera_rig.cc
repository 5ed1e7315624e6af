// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/camera_rig.h"

#include "fathom/base/input_error.h"
#include "fathom/camera/camera_file.h"
#include "fathom/camera/mount_file.h"
#include "fathom/camera/tags_file.h"

#include <array>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {

namespace {

struct RigFile {
  const char* name;
  const char* meaning;
};

constexpr std::array<RigFile, 3> kRigFiles = {
    {{"camera.yaml", "the camera's calibration"},
     {"tags.yaml", "size and place of the markers"},
     {"mount.yaml", "the camera's place on the vehicle"}}};

}  // namespace

void RequireRigFiles(const std::filesystem::path& folder,
                     const std::vector<std::string>& also_missing) {
  std::vector<std::string> missing;
  for (const RigFile& file : kRigFiles) {
    std::error_code error;
    if (std::filesystem::exists(folder / file.name, error)) continue;
    missing.push_back(fmt::format("{} ({})", file.name, file.meaning));
  }
  if (missing.empty()) return;
  missing.insert(missing.end(), also_missing.begin(), also_missing.end());
  throw InputError(
      fmt::format("{}: holds no {}, expected {} in a camera log. See docs/file_formats.md.",
                  folder.string(),
                  fmt::join(missing, ", no "),
                  missing.size() == 1 ? "it" : "them"));
}

CameraRig ReadCameraRig(const std::filesystem::path& folder) {
  RequireRigFiles(folder);
  CameraRig rig;
  rig.camera = ReadCameraFile(folder / "camera.yaml", &rig.remarks);
  rig.map = ReadTagsFile(folder / "tags.yaml");
  rig.body_from_camera = ReadMountFile(folder / "mount.yaml");
  return rig;
}

}  // namespace fathom
