// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/plan_chart.h"

#include <limits>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// x and y of the points of a path, in px.
std::vector<double> PointsOf(const std::string& kind, const std::string& html) {
  std::smatch match;
  std::regex_search(html, match, std::regex("<path class=\"" + kind + "\" d=\"([^\"]*)\""));
  const std::string path = match[1];
  std::vector<double> numbers;
  const std::regex number("-?[0-9.]+");
  for (std::sregex_iterator at(path.begin(), path.end(), number), end; at != end; ++at) {
    numbers.push_back(std::stod(at->str()));
  }
  return numbers;
}

PlanPanel Corner(double ahead, double starboard) {
  PlanPanel panel;
  panel.title = "Track";
  panel.curve = {"predicted", {0.0, ahead, ahead}, {0.0, 0.0, starboard}};
  return panel;
}

// Ahead to the right, starboard down, a metre as long in both, whichever is longer.
TEST(PlanChart, DrawsAMetreAsLongInBothDirections) {
  for (const auto& [ahead, starboard] : {std::pair(30.0, 12.0), std::pair(5.0, 60.0)}) {
    const auto at = PointsOf("path", PlanChartHtml(Corner(ahead, starboard)));
    ASSERT_EQ(at.size(), 6u);
    const double right = at[2] - at[0], down = at[5] - at[3];
    EXPECT_GT(right, 0.0);
    EXPECT_NEAR(right / ahead, down / starboard, 0.2 / std::min(ahead, starboard));
    EXPECT_EQ(at[1], at[3]);
  }
}

TEST(PlanChart, NamesLimitsAndWhatWasMeasured) {
  PlanPanel panel = Corner(30.0, 12.0);
  EXPECT_THAT(PlanChartHtml(panel), Not(HasSubstr("limit")));
  panel.limits = {{"IMO: <advance>", false, 40.0}};
  panel.measured = PlanCurve{"measured", {0.0, 10.0}, {0.0, 5.0}};
  panel.others = {panel.curve, panel.curve};
  panel.others_name = "drawn models";
  const std::string html = PlanChartHtml(panel);
  EXPECT_THAT(html, HasSubstr("IMO: &lt;advance&gt;"));
  EXPECT_THAT(html, HasSubstr("measured"));
  EXPECT_THAT(html, HasSubstr("drawn models"));
  EXPECT_EQ(PointsOf("logged", html).size(), 4u);
}

TEST(PlanChart, LeavesGapsOut) {
  PlanPanel panel = Corner(30.0, 12.0);
  panel.curve.ahead[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(PointsOf("path", PlanChartHtml(panel)).size(), 4u);
  panel.curve.ahead.clear();
  panel.curve.starboard.clear();
  EXPECT_THAT(PlanChartHtml(panel), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace fathom
