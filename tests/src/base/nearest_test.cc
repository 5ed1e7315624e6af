// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/nearest.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

const std::vector<std::string> kNames = {"dof", "family", "log", "velocity", "time_limit"};

TEST(Nearest, TakesOneLetterMoreOrLess) {
  EXPECT_EQ(Nearest("dofs", kNames), "dof");
  EXPECT_EQ(Nearest("famly", kNames), "family");
}

TEST(Nearest, TakesSwappedLettersForOneSlip) { EXPECT_EQ(Nearest("lgo", kNames), "log"); }

TEST(Nearest, TakesAnotherLetter) { EXPECT_EQ(Nearest("time-limit", kNames), "time_limit"); }

TEST(Nearest, TakesABeginning) { EXPECT_EQ(Nearest("vel", kNames), "velocity"); }

// A third of eight letters is two.
TEST(Nearest, TakesMoreSlipsInALongText) {
  EXPECT_EQ(Nearest("velosety", kNames), "velocity");
  EXPECT_EQ(Nearest("belosety", kNames), "");
}

TEST(Nearest, TakesTheOneWithTheFewestSlips) {
  EXPECT_EQ(Nearest("abcdef", {"abcxyf", "abcdxf"}), "abcdxf");
  EXPECT_EQ(Nearest("abcdef", {"abcdxf", "abcdyf"}), "abcdxf");
}

TEST(Nearest, SuggestsNothingThatIsFar) {
  EXPECT_EQ(Nearest("colour", kNames), "");
  EXPECT_EQ(Nearest("x", {"a", "xy"}), "");
  EXPECT_EQ(Nearest("", kNames), "");
  EXPECT_EQ(Nearest("dof", {}), "");
  EXPECT_EQ(Nearest(std::string(1 << 20, 'd'), kNames), "");
}

}  // namespace
}  // namespace fathom
