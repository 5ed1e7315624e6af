// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace fathom {

// The folder of the running test, program/suite/test: tests run side by side, and no two share it.
// Between tests the process number stands for the test. A '/' in a name, as parameters have it,
// becomes a dot, so that no folder lies within that of another test.
inline std::filesystem::path TestFolder() {
  const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
  std::filesystem::path folder = FATHOM_SCRATCH_DIR;
  folder /= std::filesystem::read_symlink("/proc/self/exe").filename();
  const auto enter = [&](std::string name) {
    std::ranges::replace(name, '/', '.');
    folder /= name;
  };
  const auto* suite = tests.current_test_suite();
  const auto* test = tests.current_test_info();
  if (suite != nullptr) enter(suite->name());
  enter(test != nullptr ? test->name() : std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::filesystem::path EmptyTestFolder() {
  std::filesystem::remove_all(TestFolder());
  return TestFolder();
}

}  // namespace fathom
