// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

namespace fathom {

// Whether a path that a file of a log gives, from the log's folder on, may lead out of that folder:
// where it is absolute, or holds "..".
bool LeavesItsFolder(const std::filesystem::path& path);

}  // namespace fathom
