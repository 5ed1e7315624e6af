// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string_view>

namespace fathom {

// Writes a whole file or nothing: into a temporary beside it, then renamed. Creates the folder
// where it is missing. Through a symbolic link; a device or pipe is written into. Throws
// InputError, naming the file, if it cannot be written.
void WriteFile(const std::filesystem::path& path, std::string_view content);

// Creates the folder that a file is to stand in, with those above it, where they are missing: for
// what writes its files itself. Throws InputError, naming the file, if it cannot.
void MakeFolderOf(const std::filesystem::path& file);

// Throws InputError as WriteFile would, before the work is done that is to end in this file, or in
// this folder; leaves nothing behind. A disk may still fill up in between.
void RequireWritableFile(const std::filesystem::path& path);
void RequireWritableFolder(const std::filesystem::path& path);

}  // namespace fathom
