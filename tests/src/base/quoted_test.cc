// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/quoted.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Quoted, ShowsBytesThatCannotBePrinted) {
  EXPECT_EQ(Quoted("u [m/s]"), "'u [m/s]'");
  EXPECT_EQ(Quoted("a\x1b[2J\xff"), "'a\\x1b[2J\\xff'");
}

TEST(Quoted, CutsLongText) {
  EXPECT_EQ(Quoted(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
  EXPECT_EQ(Quoted(std::string(61, 'x')), "'" + std::string(60, 'x') + "...'");
}

}  // namespace
}  // namespace fathom
