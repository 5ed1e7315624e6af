// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "test_folder.h"

namespace fathom {

// Files and folders below `folder`, sorted.
std::vector<std::string> ListOf(const std::filesystem::path& folder);

// Runs the tool and expects exit code 1, an empty stdout and no new file, finished or not, in
// `folder`, where its outputs would go; gives what it said on stderr.
std::string ExpectRefusal(const std::string& tool,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder = TestFolder());

}  // namespace fathom
