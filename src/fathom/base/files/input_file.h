// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

namespace fathom {

// Throws InputError, naming the path, if what is to be read is no file: nothing, a link to nothing,
// a folder, a device (which may never end) or a pipe (which may never begin).
void RequireRegularFile(const std::filesystem::path& path);

// The bytes of a whole file. Throws InputError, naming the file, as RequireRegularFile(), and if it
// cannot be read.
std::string ReadFile(const std::filesystem::path& path);

}  // namespace fathom
