// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/model_file.h"

#include "fathom/base/input_error.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

FittedModel Example() {
  FittedModel fitted;
  fitted.dof = Dof::kHeave;
  fitted.force_unit = "N";
  fitted.model = {1511.53, 1911.21, 31.4, -12.42};
  fitted.covariance.setZero();
  for (int i = 0; i < kNumParameters; ++i) fitted.covariance(i, i) = 0.3 + 0.1 * i;
  fitted.covariance(0, 2) = fitted.covariance(2, 0) = -0.07;
  fitted.provenance = {{"family", "output_error"}};
  return fitted;
}

std::string ErrorFrom(const std::string& text) {
  try {
    ParseModel("m.json", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// The example with one piece of text exchanged.
std::string ErrorAfter(const std::string& from, const std::string& to) {
  std::string text = FormatModel(Example());
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return ErrorFrom(text.replace(at, from.size(), to));
}

TEST(ModelFile, KeepsEveryNumberToTheBit) {
  const FittedModel in = Example();
  const FittedModel out = ParseModel("m.json", FormatModel(in));
  EXPECT_EQ(out.dof, in.dof);
  EXPECT_EQ(out.force_unit, "N");
  EXPECT_EQ(ToVector(out.model), ToVector(in.model));
  EXPECT_EQ(out.covariance, in.covariance);
}

TEST(ModelFile, WritesTheFieldsThatDesignNames) {
  const std::string text = FormatModel(Example());
  EXPECT_THAT(text, HasSubstr("\"schema\": \"fathom-model-1\""));
  EXPECT_THAT(text, HasSubstr("\"unit\": \"kg/s\""));
  EXPECT_THAT(text, HasSubstr("\"family\": \"output_error\""));
}

TEST(ModelFile, KeepsWhatIsNotKnownAsNull) {
  FittedModel in = Example();
  in.covariance.setConstant(NAN);
  EXPECT_THAT(FormatModel(in), HasSubstr("\"std\": null"));
  EXPECT_TRUE(std::isnan(ParseModel("m.json", FormatModel(in)).covariance(0, 0)));
}

TEST(ModelFile, ReadsTheExtendedModelOfAVerdict) {
  const FittedModel model = ParseModel("v.json", R"({"schema": "fathom-verdict-1", "dof": "surge",
      "extended": {"parameters": {"inertia": {"value": 9}, "quadratic_damping": {"value": 2},
      "linear_damping": {"value": 3, "std": 0.5}, "buoyancy": {"value": -1}}}})");
  EXPECT_EQ(model.model.inertia, 9.0);
  EXPECT_EQ(model.force_unit, "N");
  EXPECT_EQ(model.covariance(kLinearDamping, kLinearDamping), 0.25);
}

TEST(ModelFile, SaysWhatIsWrong) {
  EXPECT_THAT(ErrorFrom("{\"schema\": "), HasSubstr("m.json: is not JSON"));
  EXPECT_THAT(ErrorFrom("[]"), HasSubstr("'schema' is missing"));
  EXPECT_THAT(ErrorAfter("fathom-model-1", "other"), HasSubstr("'schema' is 'other', expected"));
  EXPECT_THAT(ErrorAfter("\"heave\"", "\"up\""), HasSubstr("'dof' is not one of"));
  EXPECT_THAT(ErrorAfter("\"inertia\"", "\"mass\""), HasSubstr("'inertia' is missing"));
  EXPECT_THAT(ErrorAfter("1511.53", "\"x\""), HasSubstr("'value' is \"x\", expected a finite"));
  EXPECT_THAT(ErrorAfter("1511.53", "-3.0"),
              HasSubstr("'inertia' is -3, expected a value above 0"));
  EXPECT_THAT(ErrorAfter("\"covariance\": [", "\"covariance\": [3,"), HasSubstr("'covariance'"));
}

TEST(ModelFile, RefusesDeepNestingBeforeItOverflowsAnything) {
  EXPECT_THAT(ErrorFrom(std::string(100000, '[')), HasSubstr("nested more than 16 levels"));
}

TEST(ModelFile, RefusesAnEffectItCannotSimulate) {
  EXPECT_THAT(ErrorAfter("\"inertia\":", "\"time_constant\": {\"value\": 1}, \"inertia\":"),
              HasSubstr("'time_constant' is a parameter of an effect"));
}

}  // namespace
}  // namespace fathom
