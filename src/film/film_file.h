// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/film/film.h"

#include <filesystem>

namespace fathom {

// Reads a film file (YAML; docs/file_formats.md) and the camera, tags and mount files that it
// names, which are looked for in its folder. Throws InputError, naming file, line and key, for
// whatever breaks their formats.
Film ReadFilmFile(const std::filesystem::path& path);

}  // namespace fathom
