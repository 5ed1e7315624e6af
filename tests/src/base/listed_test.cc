// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/listed.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Listed, PutsAnAndBeforeTheLast) {
  EXPECT_EQ(Listed({}), "");
  EXPECT_EQ(Listed({"surge"}), "surge");
  EXPECT_EQ(Listed({"surge", "sway"}), "surge and sway");
  EXPECT_EQ(Listed({"surge", "sway", "yaw"}), "surge, sway and yaw");
}

}  // namespace
}  // namespace fathom
