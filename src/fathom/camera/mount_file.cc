// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/mount_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/camera/yaml_pose.h"

namespace fathom {

Pose ReadMountFile(const std::filesystem::path& path) {
  return ParseMountFile(path.string(), ReadFile(path));
}

Pose ParseMountFile(const std::string& name, const std::string& text) {
  const YamlMap file = ParseYaml(name, text);
  const Pose body_from_camera = PoseAt(file, "body_from_camera");
  file.Finish();
  return body_from_camera;
}

}  // namespace fathom
