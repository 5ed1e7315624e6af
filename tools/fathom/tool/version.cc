// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/version.h"

#include <fmt/format.h>

namespace fathom {

// In commit.cc, which cmake/write_commit.cmake writes with each build.
extern const char kCommit[];

std::string VersionWithCommit() { return fmt::format("{} ({})", FATHOM_VERSION, kCommit); }

}  // namespace fathom
