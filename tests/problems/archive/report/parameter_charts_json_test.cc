// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/parameter_charts_json.h"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using nlohmann::json;

DiveFitRow FitOf(const char* vehicle, const char* dive, const char* dof, double value) {
  DiveFitRow row;
  row.vehicle = vehicle;
  row.dive = dive;
  row.dof = dof;
  row.parameter = "inertia";
  row.unit = "kg m^2";
  row.usable = true;
  row.value = value;
  row.std = 0.5;
  return row;
}

TEST(ParameterChartsJson, CountsThePlacesOfAVehicleOverItsOwnDives) {
  ArchiveReport report;
  report.tables.dive_fits = {FitOf("rov", "b", "surge", 11.0),
                             FitOf("lbv", "c", "surge", 20.0),
                             FitOf("rov", "d", "surge", 12.0)};
  report.tables.outliers = {{"d", "surge", "inertia", "rov"}};
  const json groups = json::parse(ParameterChartsJson(report, {"a", "b", "c", "d"}));
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0]["dives"], json({2}));
  EXPECT_EQ(groups[1]["dives"], json({1, 3}));
  const json chart = groups[1]["charts"][0];
  EXPECT_EQ(chart["unit"], "kg m²");
  EXPECT_EQ(chart["points"][0], json({0, 11.0, 0.5, "11.00 ± 0.50"}));
  EXPECT_EQ(chart["points"][1], json({1, 12.0, 0.5, "12.00 ± 0.50"}));
  EXPECT_EQ(chart["outliers"], json({1}));
  EXPECT_EQ(chart["lower_bound"], 0.0);
}

TEST(ParameterChartsJson, PutsDofsInTheirUsualOrder) {
  ArchiveReport report;
  for (const char* dof : {"yaw", "heave", "surge"}) {
    report.tables.dive_fits.push_back(FitOf("rov", "a", dof, 1.0));
  }
  std::string order;
  for (const json& group : json::parse(ParameterChartsJson(report, {"a"}))) {
    order += group["dof"].get<std::string>() + " ";
  }
  EXPECT_EQ(order, "surge heave yaw ");
}

TEST(ParameterChartsJson, LeavesOutWhatIsNotUsable) {
  ArchiveReport report;
  report.tables.dive_fits = {FitOf("", "a", "surge", 1.0), FitOf("", "b", "surge", kNoNumber)};
  report.tables.dive_fits[0].usable = false;
  const json groups = json::parse(ParameterChartsJson(report, {"a", "b"}));
  EXPECT_EQ(groups[0]["dives"].size(), 2u);
  EXPECT_TRUE(groups[0]["charts"].empty());
}

// The third value lies 990 from the median, over 25 times the usual distance of 1.
TEST(ParameterChartsJson, DoesNotStretchAChartForOneDivergedFit) {
  ArchiveReport report;
  report.tables.dive_fits = {FitOf("", "a", "surge", 9.0),
                             FitOf("", "b", "surge", 10.0),
                             FitOf("", "c", "surge", 1000.0),
                             FitOf("", "d", "surge", 11.0),
                             FitOf("", "e", "surge", 10.0)};
  const json groups = json::parse(ParameterChartsJson(report, {"a", "b", "c", "d", "e"}));
  const json range = groups[0]["charts"][0]["range"];
  EXPECT_LT(range[0].get<double>(), 9.0);
  EXPECT_GT(range[1].get<double>(), 11.0);
  EXPECT_LT(range[1].get<double>(), 15.0);
}

}  // namespace
}  // namespace fathom
