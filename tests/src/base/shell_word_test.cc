// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/shell_word.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(ShellWord, LeavesPlainWordsAsTheyAre) {
  EXPECT_EQ(ShellWord("--log=dives/run_1.csv"), "--log=dives/run_1.csv");
  EXPECT_EQ(ShellWord("--held_out=1.5:2,p:-1"), "--held_out=1.5:2,p:-1");
}

TEST(ShellWord, QuotesWhatAShellWouldSplitOrExpand) {
  EXPECT_EQ(ShellWord("my pool"), "'my pool'");
  EXPECT_EQ(ShellWord("$HOME;*"), "'$HOME;*'");
  EXPECT_EQ(ShellWord("it's"), "'it'\\''s'");
  EXPECT_EQ(ShellWord("~/log"), "'~/log'");
  EXPECT_EQ(ShellWord(""), "''");
}

}  // namespace
}  // namespace fathom
