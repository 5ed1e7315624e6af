// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "expect_refusal.h"

#include <algorithm>

#include "run_tool.h"
#include <gtest/gtest.h>

namespace fathom {

std::vector<std::string> ListOf(const std::filesystem::path& folder) {
  std::vector<std::string> entries;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    entries.push_back(entry.path().string());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

std::string ExpectRefusal(const std::string& tool,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder) {
  const auto before = ListOf(folder);
  const ToolRun run = RunToolBinary(tool, arguments);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(ListOf(folder), before);
  return run.err;
}

}  // namespace fathom
