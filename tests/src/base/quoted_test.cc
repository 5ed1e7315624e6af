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

TEST(Shown, EscapesWhatATerminalWouldObeyAndNothingElse) {
  // ESC, BEL, DEL, and the CSI of ISO 6429 in UTF-8; umlauts stay.
  EXPECT_EQ(ShownOnOneLine("a\x1b[31m\a\x7f\xc2\x9b"
                           "2J"),
            "a\\x1b[31m\\x07\\x7f\\xc2\\x9b"
            "2J");
  EXPECT_EQ(ShownOnOneLine("Fl\xc3\xa4"
                           "che \xc2\xb0"),
            "Fl\xc3\xa4"
            "che \xc2\xb0");
  EXPECT_EQ(ShownOnOneLine("a\r\n\tb"), "a\\x0d\\x0a\\x09b");
  EXPECT_EQ(ShownOnLines("a\r\n\tb"), "a\\x0d\n\tb");
}

}  // namespace
}  // namespace fathom
