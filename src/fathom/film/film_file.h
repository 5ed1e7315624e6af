// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/film/film.h"

#include <filesystem>
#include <string>

namespace fathom {

// Reads a film file (YAML; docs/file_formats.md) and the camera, tags and mount files that it
// names, which are looked for in its folder. Throws InputError, naming file, line and key, for
// whatever breaks their formats.
Film ReadFilmFile(const std::filesystem::path& path);

// The same with the film file in memory; `path` stands for it in messages, and its folder is where
// the other files are.
Film ParseFilmFile(const std::filesystem::path& path, const std::string& text);

}  // namespace fathom
