// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/marker_map.h"

#include <filesystem>
#include <string>

namespace fathom {

// Reads the markers of a log; docs/file_formats.md. A tag without world_from_tag is one that is not
// surveyed. Throws InputError, naming file, line and key, for whatever breaks the format, an id
// that stands twice or that its family does not have, a family that libapriltag does not know, and
// a file without any surveyed tag: nothing would say where the world is.
MarkerMap ReadTagsFile(const std::filesystem::path& path);

// The same from memory; `name` stands for the file in messages.
MarkerMap ParseTagsFile(const std::string& name, const std::string& text);

// A file that reads back as the same map.
std::string FormatTagsFile(const MarkerMap& map);

}  // namespace fathom
