// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/path_text.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(PathText, KeepsEveryAlphabet) {
  EXPECT_EQ(PathText("dive 1/données, \"été\" 'x'/データ.csv"),
            "dive 1/données, \"été\" 'x'/データ.csv");
  EXPECT_EQ(PathText("\U0001F30A"), "\U0001F30A");
}

TEST(PathText, ShowsOtherBytesAsHexadecimals) {
  EXPECT_EQ(PathText("a\xff\xfe"), "a\\xff\\xfe");
  EXPECT_EQ(PathText("a\nb\tc\x7f"), "a\\x0ab\\x09c\\x7f");
  EXPECT_EQ(PathText("cut \xe3\x83"), "cut \\xe3\\x83");
}

// RFC 3629, section 3.
TEST(PathText, TakesNoCharacterThatIsWrittenWrongly) {
  EXPECT_EQ(PathText("\xc0\xaf"), "\\xc0\\xaf");                    // "/" in two bytes
  EXPECT_EQ(PathText("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");           // in three
  EXPECT_EQ(PathText("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // a surrogate
  EXPECT_EQ(PathText("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // U+110000
  EXPECT_EQ(PathText("\xf4\x8f\xbf\xbf"), "\xf4\x8f\xbf\xbf");      // U+10FFFF
}

TEST(PathText, GivesDifferentPathsDifferentTexts) {
  EXPECT_EQ(PathText("a\\xff"), "a\\\\xff");
  EXPECT_NE(PathText("a\\xff"), PathText("a\xff"));
}

TEST(CleanText, KeepsLinesAndBackslashes) {
  EXPECT_EQ(CleanText("a\\b\n\tc\r\xff"), "a\\b\n\tc\\x0d\\xff");
}

}  // namespace
}  // namespace fathom
