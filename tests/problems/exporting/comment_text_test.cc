// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/comment_text.h"

#include "fathom/base/names_of_dofs.h"

#include <string>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(CommentText, EndsNoCommentAndBeginsNone) {
  EXPECT_EQ(CommentText("a */ b"), "a * / b");
  EXPECT_EQ(CommentText("logs/*.csv"), "logs/ *.csv");
  EXPECT_EQ(CommentText("a --> b"), "a - -> b");
  EXPECT_EQ(CommentText("---"), "- - -");
  EXPECT_EQ(CommentText("why?\?/"), "why? ?/");
}

TEST(CommentText, StaysOnOneLine) {
  EXPECT_EQ(CommentText("a\nb").find('\n'), std::string::npos);
  EXPECT_EQ(CommentText("a\rb").find('\r'), std::string::npos);
}

TEST(LiteralOf, IsANumberWithAPointOrAnExponentThatReadsBack) {
  EXPECT_EQ(LiteralOf(40.0), "40.0");
  EXPECT_EQ(LiteralOf(-0.1), "-0.1");
  EXPECT_EQ(LiteralOf(1e300), "1e+300");
  EXPECT_EQ(std::stod(LiteralOf(0.1 + 0.2)), 0.1 + 0.2);
}

TEST(CommentOn, TellsTheIntervalWhereItIsKnown) {
  ExportNumber number;
  number.value = 40.0;
  number.unit = "kg";
  EXPECT_EQ(CommentOn(number), "kg, interval not known");
  number.std = 1.0;
  number.log = "tank_07";
  EXPECT_EQ(CommentOn(number), "kg, 95 % interval 38.04 to 41.96, log tank_07");
  number.is_identified = false;
  EXPECT_EQ(CommentOn(number), "kg, held, log tank_07");
}

TEST(CommentOn, EndsTheIntervalOfADampingAt0) {
  ExportNumber number = {LinearDampingEntry(Dof::kYaw, Dof::kYaw), 1.0, 1.0, true, "kg m^2/s", ""};
  EXPECT_EQ(CommentOn(number), "kg m^2/s, 95 % interval 0 to 2.96");
  number.entry = LinearDampingEntry(Dof::kYaw, Dof::kSway);
  EXPECT_EQ(CommentOn(number), "kg m^2/s, 95 % interval -0.96 to 2.96");
}

TEST(NamesOf, AreInASentence) {
  EXPECT_EQ(NamesOf({Dof::kSurge}), "surge");
  EXPECT_EQ(NamesOf({Dof::kSurge, Dof::kSway, Dof::kYaw}), "surge, sway and yaw");
}

}  // namespace
}  // namespace fathom
