// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "run_tool.h"

#include "fathom/process/run_child.h"

#include <fstream>
#include <stdexcept>

#include <gtest/gtest.h>

namespace fathom {

ToolRun RunToolBinary(const std::string& name,
                      const std::vector<std::string>& arguments,
                      const std::function<void(int)>& on_start) {
  std::string binary = FATHOM_TOOLS_DIR;
  binary.append("/").append(name);
  const ChildResult result =
      RunChild({.program = binary, .arguments = arguments, .on_start = on_start});
  if (result.end == ChildEnd::kNotStarted) {
    throw std::runtime_error("cannot run " + binary + ": " + result.err);
  }
  return {.exit_code = result.exit_code,
          .out = result.out,
          .err = result.err,
          .peak_memory = result.peak_memory};
}

std::filesystem::path EmptyTestFolder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder = std::filesystem::path(FATHOM_SCRATCH_DIR) /
                                       (std::string(test->test_suite_name()) + "." + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

std::filesystem::path WriteTestFile(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path.string());
  return path;
}

}  // namespace fathom
