// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/curve_chart.h"

#include <limits>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

CurvePanel Example() {
  CurvePanel panel;
  panel.x_name = "frequency";
  panel.x_unit = "Hz";
  panel.y_name = "density";
  panel.y_unit = "m^2/Hz";
  panel.x = {0.1, 1.0, 10.0};
  panel.y = {100.0, 1.0, 0.01};
  panel.low.assign(3, 0.5);
  panel.high.assign(3, 2.0);
  panel.band_name = "white noise";
  return panel;
}

std::string PathOfKind(const std::string& kind, const std::string& html) {
  std::smatch match;
  std::regex_search(html, match, std::regex("class=\"" + kind + "\" d=\"([^\"]*)\""));
  return match[1];
}

std::vector<double> NumbersIn(const std::string& path) {
  std::vector<double> numbers;
  const std::regex number("-?[0-9.]+");
  for (std::sregex_iterator match(path.begin(), path.end(), number), end; match != end; ++match) {
    numbers.push_back(std::stod(match->str()));
  }
  return numbers;
}

// A power law is a straight line down from the left.
TEST(CurveChart, DrawsAPowerLawStraightOnLogarithmicAxes) {
  CurvePanel panel = Example();
  panel.is_log_x = panel.is_log_y = true;
  const auto at = NumbersIn(PathOfKind("line", CurveChartHtml(panel)));
  ASSERT_EQ(at.size(), 6u);
  EXPECT_LT(at[0], at[2]);
  EXPECT_LT(at[1], at[3]);
  EXPECT_NEAR(at[2] - at[0], at[4] - at[2], 0.11);  // each is rounded to 0.1 px
  EXPECT_NEAR(at[3] - at[1], at[5] - at[3], 0.11);
}

TEST(CurveChart, LeavesOutWhatALogarithmicAxisCannotShow) {
  CurvePanel panel = Example();
  panel.is_log_x = panel.is_log_y = true;
  panel.x[0] = 0.0;
  panel.y[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(NumbersIn(PathOfKind("line", CurveChartHtml(panel))).size(), 2u);
  panel.y[2] = 0.0;
  EXPECT_THAT(CurveChartHtml(panel), HasSubstr("No data."));
}

TEST(CurveChart, KeepsTheBandInsideWithItsKey) {
  CurvePanel panel = Example();
  panel.y.assign(3, 1.0);
  const std::string html = CurveChartHtml(panel);
  const auto at = NumbersIn(PathOfKind("band", html));
  ASSERT_EQ(at.size(), 12u);
  for (std::size_t i = 1; i < at.size(); i += 2) {
    EXPECT_GT(at[i], 6.0);
    EXPECT_LT(at[i], 192.0);
  }
  EXPECT_THAT(html, HasSubstr("<i class=\"band\"></i>white noise</span>"));
}

TEST(CurveChart, HasNeitherBandNorKeyWithoutOne) {
  CurvePanel panel = Example();
  panel.low.clear();
  panel.high.clear();
  EXPECT_THAT(CurveChartHtml(panel), Not(HasSubstr("band")));
  EXPECT_THAT(CurveChartHtml(panel), Not(HasSubstr("curve-key")));
}

// x goes from 0.1 - 4 % of 9.9 to 10 + 4 %, 282 px wide from 52 px on; 3.5 of it are marked.
TEST(CurveChart, MarksAStretchAsFarAsItIsShown) {
  CurvePanel panel = Example();
  panel.marked = {6.896, 1e9};
  panel.marked_name = "excited";
  const std::string html = CurveChartHtml(panel);
  EXPECT_THAT(html, HasSubstr("<i class=\"marked\"></i>excited</span>"));
  EXPECT_THAT(html, HasSubstr("class=\"marked\" x=\"241.7\" y=\"6.0\" width=\"92.3\""));
}

TEST(CurveChart, SaysWhatItShowsToWhoCannotSeeIt) {
  EXPECT_THAT(CurveChartHtml(Example()),
              HasSubstr("role=\"img\" aria-label=\"density over frequency\""));
}

TEST(CurveChart, EscapesEveryText) {
  CurvePanel panel = Example();
  panel.marked = {1.0, 2.0};
  panel.x_name = panel.x_unit = panel.y_name = panel.y_unit = panel.band_name = panel.marked_name =
      panel.note = "<b onload=\"x\">";
  EXPECT_THAT(CurveChartHtml(panel), Not(HasSubstr("<b onload")));
}

TEST(CurveChart, OfNoPanelsIsNothing) { EXPECT_EQ(CurveChartsHtml({}), ""); }

}  // namespace
}  // namespace fathom
