// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/plural.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Plural, IsForEveryNumberButOne) {
  EXPECT_EQ(Plural(0, "frame"), "0 frames");
  EXPECT_EQ(Plural(1, "frame"), "1 frame");
  EXPECT_EQ(Plural(2, "frame"), "2 frames");
}

}  // namespace
}  // namespace fathom
