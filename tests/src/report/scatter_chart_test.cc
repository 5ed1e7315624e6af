// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/scatter_chart.h"

#include "fathom/base/not_known.h"
#include "fathom/report/scatter_columns.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kScatterRounding = 1e-12;

std::vector<double> CountTo(int n) {
  std::vector<double> x(static_cast<std::size_t>(n));
  std::iota(x.begin(), x.end(), 0.0);
  return x;
}

std::vector<double> Line(const std::vector<double>& x, double slope, double offset) {
  std::vector<double> y;
  for (const double value : x) y.push_back(slope * value + offset);
  return y;
}

// Ten bins of ten neighbouring integers: the mean of bin k is 10 k + 4.5, their variance
// (10^2 - 1) / 12.
TEST(MeansByBins, MatchTheClosedFormOnALine) {
  const std::vector<double> x = CountTo(100);
  const auto means = MeansByBins(x, Line(x, -2.0, 1.0), 10);
  ASSERT_EQ(means.size(), 10u);
  for (int k = 0; k < 10; ++k) {
    EXPECT_NEAR(means[k].x, 10.0 * k + 4.5, kScatterRounding);
    EXPECT_NEAR(means[k].y, -2.0 * (10.0 * k + 4.5) + 1.0, 1e-11);
    EXPECT_NEAR(means[k].spread, 2.0 * std::sqrt(99.0 / 12.0), 1e-11);
    EXPECT_EQ(means[k].num_points, 10);
  }
}

TEST(MeansByBins, DoNotDependOnTheOrderOfThePoints) {
  std::vector<double> x = CountTo(60);
  std::mt19937 generator(3);
  std::shuffle(x.begin(), x.end(), generator);
  const auto means = MeansByBins(x, Line(x, 1.0, 0.0), 6);
  ASSERT_EQ(means.size(), 6u);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(means[k].y, 10.0 * k + 4.5, kScatterRounding);
}

// A command that holds two levels has two bins, however many were asked for.
TEST(MeansByBins, KeepPointsOfEqualXTogether) {
  std::vector<double> x(50, -1.0), y(50, 3.0);
  x.insert(x.end(), 50, 2.0);
  y.insert(y.end(), 50, 5.0);
  const auto means = MeansByBins(x, y, 20);
  ASSERT_EQ(means.size(), 2u);
  EXPECT_NEAR(means[0].x, -1.0, kScatterRounding);
  EXPECT_NEAR(means[1].y, 5.0, kScatterRounding);
  EXPECT_NEAR(means[0].spread, 0.0, kScatterRounding);
  EXPECT_EQ(means[1].num_points, 50);
}

// Twelve points in ten bins would be two each.
TEST(MeansByBins, HoldFivePointsAtLeast) {
  const std::vector<double> x = CountTo(12);
  const auto means = MeansByBins(x, x, 10);
  ASSERT_EQ(means.size(), 2u);
  EXPECT_EQ(means[0].num_points, 5);
  EXPECT_EQ(means[1].num_points, 7);
  ASSERT_EQ(MeansByBins({1.0, 2.0, 6.0}, {0.0, 3.0, 9.0}, 10).size(), 1u);
  EXPECT_NEAR(MeansByBins({1.0, 2.0, 6.0}, {0.0, 3.0, 9.0}, 10)[0].y, 4.0, kScatterRounding);
}

TEST(MeansByBins, LeaveOutPairsWithANan) {
  std::vector<double> x = CountTo(10), y = CountTo(10);
  x[3] = kNotKnown;
  y[7] = kNotKnown;
  const auto means = MeansByBins(x, y, 1);
  ASSERT_EQ(means.size(), 1u);
  EXPECT_EQ(means[0].num_points, 8);
  EXPECT_NEAR(means[0].y, (45.0 - 3.0 - 7.0) / 8.0, kScatterRounding);
  EXPECT_TRUE(MeansByBins({kNotKnown}, {1.0}, 4).empty());
}

TEST(MeansByBins, HoldEveryPointOnce) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  for (const int n : {1, 4, 5, 9, 23, 24, 25, 121, 1000}) {
    std::vector<double> x(static_cast<std::size_t>(n));
    for (double& value : x) value = std::round(3.0 * normal(generator));
    int count = 0;
    for (const BinMean& mean : MeansByBins(x, x, 24)) count += mean.num_points;
    EXPECT_EQ(count, n);
    EXPECT_LE(MeansByBins(x, x, 24).size(), 24u);
  }
}

// Of the variance (100^2 - 1) / 12 of a hundred integers (10^2 - 1) / 12 lies within ten bins.
TEST(ShareBetweenBins, MatchesTheClosedFormOnALine) {
  const std::vector<double> x = CountTo(100);
  EXPECT_NEAR(ShareBetweenBins(x, Line(x, -3.0, 7.0), 10), 1.0 - 99.0 / 9999.0, 1e-12);
}

// A step of +-1, and +-1/2 by turns on top: variances 1 and 1/4.
TEST(ShareBetweenBins, FollowsAnyShape) {
  const std::vector<double> x = CountTo(200);
  std::vector<double> y;
  for (int i = 0; i < 200; ++i) y.push_back((i / 20 % 2 == 0 ? 1.0 : -1.0) + (i % 2 ? 0.5 : -0.5));
  EXPECT_NEAR(ShareBetweenBins(x, y, 10), 0.8, 1e-12);
}

// n points in random order: (bins - 1) / (n - 1) in the mean, for any values.
TEST(ShareBetweenBins, OfUnrelatedPointsIsWhatChanceGives) {
  const std::vector<double> x = CountTo(240);
  std::vector<double> y = CountTo(240);
  std::mt19937 generator(7);
  const int num_draws = 400;
  double sum = 0.0, sum_of_squares = 0.0;
  for (int draw = 0; draw < num_draws; ++draw) {
    std::shuffle(y.begin(), y.end(), generator);
    const double share = ShareBetweenBins(x, y, 24);
    sum += share;
    sum_of_squares += share * share;
  }
  const double mean = sum / num_draws;
  const double std = std::sqrt(sum_of_squares / num_draws - mean * mean);
  EXPECT_NEAR(mean, 23.0 / 239.0, 4.0 * std / std::sqrt(num_draws));
}

TEST(ShareBetweenBins, IsNotKnownWhereNothingVaries) {
  for (const double value : {2.0, 0.1, -1.0 / 3.0}) {
    EXPECT_TRUE(std::isnan(ShareBetweenBins(CountTo(50), std::vector<double>(50, value), 5)));
  }
  EXPECT_TRUE(std::isnan(ShareBetweenBins({}, {}, 5)));
}

ScatterPanel PanelOf(std::vector<double> x, std::vector<double> y) {
  ScatterPanel panel;
  panel.x_name = "command";
  panel.x_unit = "N";
  panel.y_name = "missing force";
  panel.y_unit = "N";
  panel.x = std::move(x);
  panel.y = std::move(y);
  panel.second_name = "explained";
  return panel;
}

// Every "x y" of a path, and the x and y of every text.
std::vector<std::pair<double, double>> PlacesIn(const std::string& html) {
  std::vector<std::pair<double, double>> places;
  const std::regex point(R"(([ML]|x=")(-?[0-9.]+)(" y=")?( ?)(-?[0-9.]+))");
  for (std::sregex_iterator match(html.begin(), html.end(), point), end; match != end; ++match) {
    places.emplace_back(std::stod((*match)[2]), std::stod((*match)[5]));
  }
  return places;
}

TEST(ScatterChart, KeepsEverythingInsideTheDrawing) {
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  std::vector<double> x(500), y(500);
  for (double& value : x) value = 1e4 * normal(generator);
  for (double& value : y) value = 1e-3 * std::pow(normal(generator), 5);
  ScatterPanel panel = PanelOf(x, y);
  panel.second_y = Line(x, 1e-7, 0.0);
  Palette palette;
  const auto places = PlacesIn(ScatterChartHtml(panel, palette));
  ASSERT_GT(places.size(), 500u);
  for (const auto& [left, top] : places) {
    EXPECT_GE(left, 0.0);
    EXPECT_LE(left, 340.0);
    EXPECT_GE(top, 0.0);
    EXPECT_LE(top, 230.0);
  }
}

// The points (0, 0), (1, 0), (0, 1): to the right and above.
TEST(ScatterChart, DrawsXToTheRightAndYUp) {
  Palette palette;
  const std::string html = ScatterChartHtml(PanelOf({0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}), palette);
  const auto at = html.find("class=\"points\"");
  ASSERT_NE(at, std::string::npos);
  const auto places = PlacesIn(html.substr(at, html.find("/>", at) - at));
  ASSERT_EQ(places.size(), 3u);
  EXPECT_GT(places[1].first, places[0].first + 200.0);
  EXPECT_EQ(places[1].second, places[0].second);
  EXPECT_EQ(places[2].first, places[0].first);
  EXPECT_LT(places[2].second, places[0].second - 100.0);
}

TEST(ScatterChart, ThinsManyPoints) {
  Palette palette;
  const std::vector<double> x = CountTo(100000);
  const std::string html = ScatterChartHtml(PanelOf(x, x), palette);
  const auto at = html.find("class=\"points\"");
  const auto count = PlacesIn(html.substr(at, html.find("/>", at) - at)).size();
  EXPECT_LE(count, kMostPoints);
  EXPECT_GE(count, kMostPoints / 2);
}

TEST(ScatterChart, EscapesEveryText) {
  ScatterPanel panel = PanelOf(CountTo(20), CountTo(20));
  panel.x_name = panel.x_unit = panel.y_name = panel.y_unit = panel.note = "<b onload=\"x\">";
  panel.second_y = CountTo(20);
  panel.second_name = panel.y_name;
  Palette palette;
  EXPECT_THAT(ScatterChartsHtml({panel}, palette), Not(HasSubstr("<b onload")));
  EXPECT_THAT(ScatterChartsHtml({panel}, palette), HasSubstr("&lt;b onload"));
}

TEST(ScatterChart, GivesMeansTheColourThatTheirNameHasOverTime) {
  Palette palette;
  const std::string first(palette.ColorOf("missing force"));
  const std::string second(palette.ColorOf("explained"));
  ScatterPanel panel = PanelOf(CountTo(100), CountTo(100));
  panel.second_y = CountTo(100);
  const std::string html = ScatterChartHtml(panel, palette);
  EXPECT_THAT(html, HasSubstr("class=\"means\" style=\"stroke:" + first));
  EXPECT_THAT(html, HasSubstr("class=\"second\" style=\"stroke:" + second));
}

TEST(ScatterChart, SaysWhereThereAreNoData) {
  Palette palette;
  EXPECT_THAT(ScatterChartHtml(PanelOf({kNotKnown}, {1.0}), palette), HasSubstr("No data."));
  EXPECT_EQ(ScatterChartsHtml({}, palette), "");
}

}  // namespace
}  // namespace fathom
