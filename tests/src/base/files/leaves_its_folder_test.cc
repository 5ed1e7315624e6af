// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/leaves_its_folder.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(LeavesItsFolder, IsTrueOfAbsolutePathsAndOfAnyStepUp) {
  for (const char* path : {"/a.png", "..", "../a.png", "sub/../a.png", "sub/.."}) {
    EXPECT_TRUE(LeavesItsFolder(path)) << path;
  }
  for (const char* path : {"a.png", "./a.png", "sub/a.png", "a..png", "..a/b.png"}) {
    EXPECT_FALSE(LeavesItsFolder(path)) << path;
  }
}

}  // namespace
}  // namespace fathom
