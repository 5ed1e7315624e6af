// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dives/named_few.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(NamedFew, NamesThreeAndCountsTheRest) {
  EXPECT_EQ(NamedFew({}), "");
  EXPECT_EQ(NamedFew({"a"}), "a");
  EXPECT_EQ(NamedFew({"a", "b"}), "a and b");
  EXPECT_EQ(NamedFew({"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(NamedFew({"a", "b", "c", "d", "e"}), "a, b, c and 2 more");
}

}  // namespace
}  // namespace fathom
