// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/parameter_chart.h"

#include "fathom/base/not_known.h"

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kRounding = 1e-9;  // sums of a few numbers of order 10

ParameterPanel PanelOf(std::vector<Estimate> estimates) {
  ParameterPanel panel;
  panel.name = "inertia";
  panel.unit = "kg";
  panel.estimates = std::move(estimates);
  return panel;
}

TEST(ParameterChart, RangeHoldsIntervalsAndEstimatesWithAMargin) {
  // 10 - 1.96 = 8.04 to 12, and 6 % of 3.96 on either side.
  const ChartRange range =
      RangeOf(PanelOf({{"a", 10.0, 1.0}, {"b", 12.0, kNotKnown}, {"c", kNotKnown, 1.0}}));
  EXPECT_NEAR(range.from, 7.8024, kRounding);
  EXPECT_NEAR(range.to, 12.2376, kRounding);
}

TEST(ParameterChart, RangeHoldsTheReference) {
  ParameterPanel panel = PanelOf({{"a", 10.0, 1.0}});
  panel.reference = 20.0;
  EXPECT_GT(RangeOf(panel).to, 20.0);
}

TEST(ParameterChart, ADivergedEstimateDoesNotSqueezeTheOthers) {
  const ParameterPanel panel = PanelOf({{"a", 10.0, 1.0}, {"b", 12.0, 1.0}, {"c", 1e6, 1.0}});
  EXPECT_LT(RangeOf(panel).to, 20.0);
  Palette palette;
  EXPECT_THAT(ParameterChartHtml(panel, palette), HasSubstr("arrow right"));
}

TEST(ParameterChart, AnEstimateAloneHasARange) {
  const ChartRange range = RangeOf(PanelOf({{"a", 10.0, kNotKnown}}));
  EXPECT_LT(range.from, 10.0);
  EXPECT_GT(range.to, 10.0);
}

TEST(ParameterChart, BarsEndAtWhatTheParameterCanBe) {
  ParameterPanel panel = PanelOf({{"a", 10.0, 10.0}, {"b", 20.0, 1.0}, {"c", -1.0, 2.0}});
  panel.lower_bound = 0.0;
  EXPECT_EQ(BarOf(panel.estimates[0], panel).from, 0.0);
  EXPECT_NEAR(BarOf(panel.estimates[0], panel).to, 29.6, kRounding);
  EXPECT_NEAR(BarOf(panel.estimates[1], panel).from, 18.04, kRounding);
  EXPECT_NEAR(BarOf(panel.estimates[2], panel).from, -4.92, kRounding);  // already beyond
  panel.upper_bound = 21.0;
  EXPECT_EQ(BarOf(panel.estimates[1], panel).to, 21.0);

  Palette palette;
  const std::string html = ParameterChartHtml(panel, palette);
  EXPECT_THAT(html, HasSubstr(R"(<i class="bar open-left open-right")"));  // a
  EXPECT_THAT(html, HasSubstr(R"(<i class="bar open-right")"));            // b
  EXPECT_THAT(html, HasSubstr("a: 10, 95 % interval 0 to 21 kg"));
  EXPECT_THAT(html, HasSubstr("10 ± 10"));
}

TEST(ParameterChart, RangeEndsCloseToTheBoundOfABar) {
  ParameterPanel panel = PanelOf({{"a", 10.0, 10.0}});
  panel.lower_bound = 0.0;
  // 0 to 29.6, and 6 % of it on either side.
  EXPECT_NEAR(RangeOf(panel).from, -1.776, kRounding);
  EXPECT_NEAR(RangeOf(panel).to, 31.376, kRounding);
}

TEST(ParameterChart, TicksAreRoundNumbers) {
  EXPECT_THAT(TicksOf({-0.1, 10.1}), ElementsAre(0.0, 5.0, 10.0));
  EXPECT_THAT(TicksOf({0.0, 10.0}), ElementsAre(0.0, 2.0, 4.0, 6.0, 8.0, 10.0));
  EXPECT_THAT(TicksOf({742.0, 958.0}), ElementsAre(750.0, 800.0, 850.0, 900.0, 950.0));
  EXPECT_EQ(TickLabel(0.75, 0.05), "0.75");
  EXPECT_EQ(TickLabel(-20.0, 10.0), "-20");
  EXPECT_EQ(TickLabel(1e-18, 0.1), "0");
  EXPECT_EQ(TickLabel(5.9941e-4, 1e-8), "0.00059941");
}

TEST(ParameterChart, PlacesDotAndBarInPercentOfTheRange) {
  Palette palette;
  const std::string html =
      ParameterChartHtml(PanelOf({{"a", 10.0, 1.0}, {"b", 12.0, kNotKnown}}), palette);
  // The range is 7.8024 to 12.2376, 4.4352 wide: 2.1976, 0.2376 and 3.92 of it.
  EXPECT_THAT(html, HasSubstr(R"(<i class="dot" style="left:49.55%;background:#0072b2">)"));
  EXPECT_THAT(html,
              HasSubstr(R"(<i class="bar" style="left:5.36%;width:88.38%;background:#0072b2">)"));
  EXPECT_THAT(html, HasSubstr("a: 10, 95 % interval 8.04 to 11.96 kg"));
  EXPECT_THAT(html, HasSubstr("10.0 ± 1.0"));
}

TEST(ParameterChart, SaysWhereThereIsNoEstimate) {
  Palette palette;
  EXPECT_THAT(ParameterChartHtml(PanelOf({{"a", kNotKnown, kNotKnown}}), palette),
              HasSubstr("no estimate"));
}

}  // namespace
}  // namespace fathom
