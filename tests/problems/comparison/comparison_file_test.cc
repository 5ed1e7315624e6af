// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison_file.h"

#include "handmade_comparison.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::json;

Comparison TwoRows() {
  Comparison comparison;
  comparison.log_name = "tank_07";
  comparison.dofs = {
      HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 0.03), UnusableRow(Family::kAdaptive)})};
  comparison.dofs[0].rows[0].fitted.caveats = {"a caveat"};
  return comparison;
}

TEST(ComparisonFile, NamesItsSchemaAndLog) {
  const Json json = Json::parse(FormatComparison(TwoRows()));
  EXPECT_EQ(json["schema"], "fathom-comparison-1");
  EXPECT_EQ(json["log"], "tank_07");
  EXPECT_EQ(json["rows"].size(), 2u);
}

TEST(ComparisonFile, ARowHoldsWhatTheFormatPromises) {
  const Json row = Json::parse(FormatComparison(TwoRows()))["rows"][0];
  EXPECT_EQ(row["dof"], "surge");
  EXPECT_EQ(row["family"], "output_error");
  EXPECT_EQ(row["source"], "pose_estimator");
  EXPECT_EQ(row["mae"], 0.01);
  EXPECT_EQ(row["nmae"], 0.02);
  EXPECT_EQ(row["heldout_mae"], 0.0075);
  EXPECT_EQ(row["heldout_nmae"], 0.03);
  EXPECT_EQ(row["usable"], true);
  EXPECT_EQ(row["message"], "converged");
  EXPECT_EQ(row["caveats"], Json({"a caveat"}));

  struct {
    const char* name;
    double value, std;
    const char* unit;
  } const kExpected[] = {{"inertia", 40.0, 2.0, "kg"},
                         {"quadratic_damping", 30.0, 1.5, "kg/m"},
                         {"linear_damping", 5.0, 0.5, "kg/s"},
                         {"buoyancy", -0.5, 0.1, "N"}};
  EXPECT_EQ(row["parameters"].size(), 4u);
  for (const auto& expected : kExpected) {
    const Json& parameter = row["parameters"][expected.name];
    EXPECT_EQ(parameter["value"], expected.value) << expected.name;
    EXPECT_DOUBLE_EQ(parameter["std"].get<double>(), expected.std) << expected.name;
    EXPECT_EQ(parameter["unit"], expected.unit) << expected.name;
  }
}

// A parameter that was never computed must not come out as a plausible number.
TEST(ComparisonFile, SaysHowOutputErrorWeighed) {
  Comparison comparison = TwoRows();
  comparison.dofs[0].rows[0].weighting = "learned";
  comparison.dofs[0].rows[0].weighting_reason = "a reason";
  const Json rows = Json::parse(FormatComparison(comparison))["rows"];
  EXPECT_EQ(rows[0]["weighting"], "learned");
  EXPECT_EQ(rows[0]["weighting_reason"], "a reason");
  EXPECT_FALSE(rows[1].contains("weighting"));
}

TEST(ComparisonFile, AnUnusableRowHoldsNullsAndSaysWhy) {
  const Json row = Json::parse(FormatComparison(TwoRows()))["rows"][1];
  EXPECT_EQ(row["usable"], false);
  EXPECT_EQ(row["message"], "the command never changes");
  for (const char* figure : {"mae", "nmae", "heldout_mae", "heldout_nmae"}) {
    EXPECT_TRUE(row[figure].is_null()) << figure;
  }
  for (const auto& [name, parameter] : row["parameters"].items()) {
    EXPECT_TRUE(parameter["value"].is_null()) << name << " is " << parameter["value"];
    EXPECT_TRUE(parameter["std"].is_null()) << name;
  }
}

TEST(ComparisonFile, FindingsAreKeptWithTheirDof) {
  Comparison comparison = TwoRows();
  comparison.dofs[0].findings = {
      {.severity = Severity::kWarning, .code = "passivity", .sentence = "It gains energy."}};
  const Json findings = Json::parse(FormatComparison(comparison))["findings"];
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0]["dof"], "surge");
  EXPECT_EQ(findings[0]["sentence"], "It gains energy.");
}

}  // namespace
}  // namespace fathom
