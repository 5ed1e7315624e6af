// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/chart_frame.h"

#include <cmath>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(ChartAxis, HoldsItsValuesWithAMargin) {
  for (const bool is_log : {false, true}) {
    const ChartAxis axis = AxisOver(2.0, 300.0, is_log);
    EXPECT_NEAR(axis.PlaceOf(2.0), 0.04 / 1.08, 1e-12);
    EXPECT_NEAR(axis.PlaceOf(300.0), 1.04 / 1.08, 1e-12);
  }
}

TEST(ChartAxis, OfOneValueHasAnExtent) {
  for (const bool is_log : {false, true}) {
    const ChartAxis axis = AxisOver(7.0, 7.0, is_log);
    EXPECT_NEAR(axis.PlaceOf(7.0), 0.5, 1e-12);
  }
  EXPECT_NEAR(AxisOver(0.0, 0.0).PlaceOf(0.0), 0.5, 1e-12);
}

TEST(ChartAxis, PutsAFactorAtADistanceWhereItIsLogarithmic) {
  const ChartAxis axis = {{0.1, 1000.0}, true};
  EXPECT_NEAR(axis.PlaceOf(1.0), 0.25, 1e-12);
  EXPECT_NEAR(axis.PlaceOf(10.0), 0.5, 1e-12);
}

TEST(LogTicks, ArePowersOfTen) {
  EXPECT_THAT(LogTicksOf({0.09, 150.0}),
              ElementsAre(DoubleEq(0.1), DoubleEq(1.0), DoubleEq(10.0), DoubleEq(100.0)));
}

TEST(LogTicks, AreFinerWhereTheRangeIsShort) {
  EXPECT_THAT(
      LogTicksOf({0.3, 12.0}),
      ElementsAre(DoubleEq(0.5), DoubleEq(1.0), DoubleEq(2.0), DoubleEq(5.0), DoubleEq(10.0)));
}

TEST(LogTicks, AreFewOverManyDecades) {
  EXPECT_THAT(LogTicksOf({1e-9, 1e9}).size(), testing::AllOf(testing::Ge(3u), testing::Le(7u)));
}

TEST(LogTicks, AreLabelledAsPeopleWriteThem) {
  EXPECT_EQ(LogTickLabel(0.02), "0.02");
  EXPECT_EQ(LogTickLabel(1000.0), "1000");
  EXPECT_EQ(LogTickLabel(1e4), "10⁴");
  EXPECT_EQ(LogTickLabel(2.0 * std::pow(10.0, -12)), "2·10⁻¹²");
}

// The drawing is 230 px high, its lower end 38 px above the rim, its upper one 6 px below.
TEST(ChartFrame, BreaksALineAtAGapAndKeepsItInside) {
  const ChartFrame frame = {{{0.0, 1.0}}, {{0.0, 1.0}}};
  EXPECT_EQ(frame.PathOf({0.0, 1.0, 0.5, 0.0}, {0.0, 9.0, std::nan(""), 1.0}),
            "M52.0 192.0L334.0 6.0M52.0 6.0");
}

TEST(ChartFrame, AnAreaGoesAlongTheUpperLineAndBackAlongTheLower) {
  const ChartFrame frame = {{{0.0, 1.0}}, {{0.0, 1.0}}};
  EXPECT_EQ(frame.AreaOf({0.0, 1.0}, {0.0, 0.0}, {1.0, 1.0}),
            "M52.0 6.0L334.0 6.0L334.0 192.0L52.0 192.0Z");
}

TEST(ChartFrame, DrawsTheZeroOnlyWhereItIs) {
  const auto svg = [](const ChartAxis& y) {
    return ChartFrame{{{1.0, 2.0}}, y}.Svg("y over x", "x", "");
  };
  EXPECT_THAT(svg({{-1.0, 1.0}}), HasSubstr("class=\"zero\""));
  EXPECT_THAT(svg({{0.5, 1.0}}), Not(HasSubstr("class=\"zero\"")));
  EXPECT_THAT(svg({{0.5, 1.0}, true}), Not(HasSubstr("class=\"zero\"")));
}

}  // namespace
}  // namespace fathom
