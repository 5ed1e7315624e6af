// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace fathom {

// "0.1.0 (abc1234)": the version and the commit that was built, "abc1234 with changes" where files
// differed from it, "unknown" where the sources were no checkout of git.
std::string VersionWithCommit();

}  // namespace fathom
