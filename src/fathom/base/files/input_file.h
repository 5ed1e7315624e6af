// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

namespace fathom {

// The bytes of a whole file. Throws InputError, naming the file, if there is no such file, if it is
// a folder, or if it cannot be read.
std::string ReadFile(const std::filesystem::path& path);

}  // namespace fathom
