// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

namespace fathom {

// Tests on logs, photos and videos of real vehicles. They belong to others and are not bundled: the
// folder that FATHOM_REALDATA names, or the one beside the repository. Skipped, saying so, where
// there is none.
class OnRealData : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("FATHOM_REALDATA");
    folder_ = folder != nullptr ? folder : FATHOM_SOURCE_DIR "/../shared/realdata";
    if (!std::filesystem::is_directory(folder_)) {
      GTEST_SKIP() << "no real data in " << folder_ << "; set FATHOM_REALDATA to their folder";
    }
  }

  std::filesystem::path folder_;
};

}  // namespace fathom
