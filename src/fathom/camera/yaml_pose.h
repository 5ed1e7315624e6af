// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/files/yaml_file.h"
#include "fathom/geometry/pose.h"

#include <string>
#include <string_view>

namespace fathom {

// The pose {position: [x, y, z], quaternion: [x, y, z, w]} under a key. Throws InputError, naming
// file, line and key, if it is not there, or its quaternion is not of length 1 within 1e-3.
Pose PoseAt(const YamlMap& map, std::string_view key);

// The same in one line, digits enough to read back to the bit.
std::string FormatYamlPose(const Pose& pose);

}  // namespace fathom
