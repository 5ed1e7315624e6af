// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/geometry/pose.h"

#include <filesystem>
#include <string>

namespace fathom {

// Reads body_from_camera, where the camera sits on the vehicle; docs/file_formats.md. Throws
// InputError, naming file, line and key, for whatever breaks the format.
Pose ReadMountFile(const std::filesystem::path& path);

// The same from memory; `name` stands for the file in messages.
Pose ParseMountFile(const std::string& name, const std::string& text);

}  // namespace fathom
