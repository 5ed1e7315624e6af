// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/model_file.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <string>
#include <vector>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

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

std::string ModelError(const std::string& text) {
  return ErrorFrom([&] { ParseModel("m.json", text); });
}

// The example with one piece of text exchanged.
std::string ErrorAfter(const std::string& from, const std::string& to) {
  std::string text = FormatModel(Example());
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return ModelError(text.replace(at, from.size(), to));
}

TEST(ModelFile, KeepsEveryNumberToTheBit) {
  const FittedModel in = Example();
  const FittedModel out = ParseModel("m.json", FormatModel(in));
  EXPECT_EQ(out.dof, in.dof);
  EXPECT_EQ(out.force_unit, "N");
  EXPECT_EQ(ToVector(out.model), ToVector(in.model));
  EXPECT_EQ(out.covariance, in.covariance);
}

TEST(ModelFile, KeepsHowManySamplesItsFiguresAreOf) {
  FittedModel in = Example();
  in.train = {.mae = 0.01, .nmae = 0.1, .num_samples = 1234, .duration = 61.7};
  const FittedModel out = ParseModel("m.json", FormatModel(in));
  EXPECT_EQ(out.train.num_samples, 1234);
  EXPECT_EQ(out.train.duration, 61.7);
}

// A slow propeller, and damping from two other DOFs: the same effect twice, with different
// partners.
FittedModel ExampleWithEffects() {
  FittedModel fitted = Example();
  const EffectSetting lag = {.dof = Dof::kHeave, .reference_force = 31.25};
  const EffectSetting surge = {.dof = Dof::kHeave, .partner = Dof::kSurge};
  const EffectSetting pitch = {.dof = Dof::kHeave, .partner = Dof::kPitch};
  fitted.effects = {{FindEffect("thruster_lag"), lag, {0.47}},
                    {FindEffect("fluid_memory"), {.dof = Dof::kHeave}, {12.5, 3.75}},
                    {FindEffect("velocity_coupling"), surge, {-8.1}},
                    {FindEffect("velocity_coupling"), pitch, {2.3}}};
  fitted.covariance.resize(9, 9);
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) fitted.covariance(i, j) = (i == j ? 2.0 : 0.0) + 0.01 * (i + j);
  }
  fitted.log_fingerprints = {"00c0ffee00c0ffee"};
  return fitted;
}

TEST(ModelFile, KeepsEffectsWithTheirSettingsValuesAndCovariance) {
  const FittedModel in = ExampleWithEffects();
  const FittedModel out = ParseModel("m.json", FormatModel(in));
  ASSERT_EQ(out.effects.size(), 4u);
  for (size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(out.effects[k].effect, in.effects[k].effect);
    EXPECT_EQ(out.effects[k].values, in.effects[k].values);
    EXPECT_EQ(out.effects[k].setting.dof, Dof::kHeave);
    EXPECT_EQ(out.effects[k].setting.reference_force, in.effects[k].setting.reference_force);
  }
  EXPECT_EQ(out.effects[2].setting.partner, Dof::kSurge);
  EXPECT_EQ(out.effects[3].setting.partner, Dof::kPitch);
  EXPECT_EQ(out.covariance, in.covariance);
  EXPECT_EQ(ToVector(out.model), ToVector(in.model));
  EXPECT_EQ(out.log_fingerprints, in.log_fingerprints);
  EXPECT_EQ(FormatModel(out), FormatModel([&] {
              FittedModel again = in;
              again.provenance.clear();
              again.train = out.train;
              return again;
            }()));
}

TEST(ModelFile, NamesAnEffectsParametersAfterItAndItsPartner) {
  const std::string text = FormatModel(ExampleWithEffects());
  for (const char* key : {"\"thruster_lag.time_constant\"",
                          "\"fluid_memory.coefficient\"",
                          "\"fluid_memory.time_constant\"",
                          "\"velocity_coupling(surge).coefficient\"",
                          "\"velocity_coupling(pitch).coefficient\""}) {
    EXPECT_THAT(text, HasSubstr(key));
  }
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
  EXPECT_THAT(ModelError("{\"schema\": "),
              StartsWith("m.json: is not JSON: parse error at line 1"));
  EXPECT_EQ(ModelError("t,u\n0,1\n"),
            "m.json: is no model, expected the JSON of fathom_identify --model.");
  EXPECT_THAT(ModelError("[]"), HasSubstr("'schema' is missing"));
  EXPECT_THAT(ErrorAfter("fathom-model-1", "other"), HasSubstr("'schema' is 'other', expected"));
  EXPECT_THAT(ErrorAfter("\"heave\"", "\"up\""), HasSubstr("'dof' is not one of"));
  EXPECT_THAT(ErrorAfter("\"inertia\"", "\"mass\""), HasSubstr("'parameters.inertia' is missing"));
  EXPECT_THAT(ErrorAfter("1511.53", "\"x\""),
              HasSubstr("'parameters.inertia.value' is \"x\", expected a finite"));
  EXPECT_THAT(ErrorAfter("1511.53", "-3.0"),
              HasSubstr("'parameters.inertia' is -3, expected a value above 0"));
  EXPECT_THAT(ErrorAfter("\"covariance\": [", "\"covariance\": [3,"), HasSubstr("'covariance'"));
}

// The parser would stop there, and whatever follows count for nothing.
TEST(ModelFile, RefusesANulByte) {
  EXPECT_EQ(ErrorFrom([] { ParseModel("m.json", std::string("{\n \0}", 5)); }),
            "m.json:2: a NUL byte stands in column 2, expected the text of a JSON file. It is "
            "damaged; restore it from its source.");
}

TEST(ModelFile, RefusesDeepNestingBeforeItOverflowsAnything) {
  EXPECT_THAT(ModelError(std::string(100000, '[')), HasSubstr("nested more than 16 levels"));
}

// With the example's baseline, and effects as DESIGN.md writes causes.
std::string VerdictWithCauses(const std::string& causes, const std::string& effect_parameters) {
  return R"({"schema": "fathom-verdict-1", "dof": "surge", "causes": [)" + causes +
         R"(], "extended": {"parameters": {"inertia": {"value": 9}, "quadratic_damping": {"value": 2},
      "linear_damping": {"value": 3, "std": 0.5}, "buoyancy": {"value": -1})" +
         effect_parameters + R"(}, "mae": 0.02, "nmae": 0.3, "heldout_nmae": 0.4}})";
}

const char* const kLag = R"({"effect": "sensor_lag", "place": "sensor",
    "parameters": {"time_constant": {"value": 0.7, "std": 0.1, "unit": "s"}}, "p_value": 0.001})";
const char* const kDeadZone = R"({"effect": "thrust_dead_zone",
    "parameters": {"width": {"value": 8}}, "alternatives": []})";

TEST(ModelFile, TakesTheCausesOfAVerdictThatDoesNotSayItsStructure) {
  const FittedModel model =
      ParseModel("v.json", VerdictWithCauses(std::string(kLag) + "," + kDeadZone, ""));
  ASSERT_EQ(model.effects.size(), 2u);  // in the order in which they act
  EXPECT_EQ(model.effects[0].effect, FindEffect("thrust_dead_zone"));
  EXPECT_EQ(model.effects[0].values, std::vector<double>{8.0});
  EXPECT_EQ(model.effects[1].effect, FindEffect("sensor_lag"));
  EXPECT_EQ(model.effects[1].values, std::vector<double>{0.7});
  EXPECT_EQ(model.covariance.rows(), 6);
  EXPECT_EQ(model.train.nmae, 0.3);
  EXPECT_EQ(model.held_out.nmae, 0.4);
}

TEST(ModelFile, TheExtendedModelsOwnNumbersGoBeforeTheCauses) {
  const FittedModel model = ParseModel(
      "v.json",
      VerdictWithCauses(kLag, R"(, "sensor_lag.time_constant": {"value": 0.9, "std": 1})"));
  ASSERT_EQ(model.effects.size(), 1u);
  EXPECT_EQ(model.effects[0].values, std::vector<double>{0.9});
  EXPECT_EQ(model.covariance(4, 4), 1.0);
}

TEST(ModelFile, RefusesAnEffectItCannotSimulate) {
  const auto error_with = [](const std::string& effects) {
    std::string text = FormatModel(Example());
    const std::string from = "\"effects\": []";
    return ModelError(text.replace(text.find(from), from.size(), "\"effects\": [" + effects + "]"));
  };
  EXPECT_THAT(
      error_with(R"({"effect": "ghost"})"),
      HasSubstr("m.json: 'structure.effects[0].effect' is 'ghost', an effect that this version "
                "cannot simulate, expected one of time_offset, thrust_dead_zone, "));
  EXPECT_THAT(
      error_with(R"({"effect": "righting_moment"})"),
      HasSubstr("effects[0].effect' is 'righting_moment', an effect that does not act along "
                "heave"));
  EXPECT_THAT(error_with(R"({"effect": "velocity_coupling"})"),
              HasSubstr("'structure.effects[0].partner' is missing"));
  EXPECT_THAT(
      error_with(R"({"effect": "velocity_coupling", "partner": "heave"})"),
      HasSubstr(
          "effects[0].partner' of velocity_coupling is 'heave', expected another DOF than heave"));
  EXPECT_THAT(error_with(R"({"effect": "thrust_curve", "reference_force": 0})"),
              HasSubstr("effects[0].reference_force' is 0, expected a value above 0"));
  EXPECT_THAT(error_with(R"({"effect": "thruster_lag"})"),
              HasSubstr("'parameters.thruster_lag.time_constant' is missing"));
  EXPECT_THAT(
      error_with(R"({"effect": "sensor_lag"}, {"effect": "thruster_lag"})"),
      HasSubstr("'structure.effects' lists sensor_lag before thruster_lag, expected the order"));
  EXPECT_THAT(error_with(R"({"effect": "sensor_lag"}, {"effect": "sensor_lag"})"),
              HasSubstr("'structure.effects' lists sensor_lag twice"));
  EXPECT_THAT(ErrorAfter("\"effects\": []", "\"effects\": 3"),
              HasSubstr("'structure.effects' is 3, expected a list"));
}

TEST(ModelFile, RefusesAParameterThatNoEffectHas) {
  EXPECT_THAT(
      ErrorAfter("\"inertia\":", "\"time_constant\": {\"value\": 1}, \"inertia\":"),
      HasSubstr("'parameters.time_constant' is a parameter of no effect of this model, expected "
                "inertia, quadratic_damping, linear_damping, buoyancy."));
}

TEST(ModelFile, RefusesAValueBeyondItsBounds) {
  std::string text = FormatModel(ExampleWithEffects());
  text.replace(text.find("0.47"), 4, "-0.1");
  EXPECT_THAT(ModelError(text),
              HasSubstr("'parameters.thruster_lag.time_constant' is -0.1, expected 0 to 20."));
}

TEST(ModelFile, RefusesACovarianceOfAnotherSize) {
  std::string text = FormatModel(ExampleWithEffects());
  const std::string key = "\"covariance\": ";
  const size_t begin = text.find(key), end = text.find("\"fit\"");
  EXPECT_THAT(ModelError(text.replace(begin, end - begin, key + "[[1]],\n")),
              HasSubstr("'covariance' has 1 entries, expected a 9 x 9 array of numbers or nulls."));
}

TEST(ModelFile, RefusesKeysThatNobodyWrites) {
  // Without its dead zone the model would be another one.
  EXPECT_EQ(ErrorAfter("\"effects\"", "\"effect\""),
            "m.json: 'structure.effect' is not known here, expected one of baseline, effects. "
            "Correct or remove it.");
  EXPECT_THAT(ErrorAfter("\"fit\"", "\"fitt\""),
              HasSubstr("'fitt' is not known here, expected one of schema, dof, structure, "));
  EXPECT_THAT(ErrorAfter("\"nmae\"", "\"NMAE\""), HasSubstr("'fit.NMAE' is not known here"));
  EXPECT_THAT(ErrorAfter("\"std\"", "\"sd\""),
              HasSubstr("'parameters.inertia.sd' is not known here, expected one of value, std, "));
  EXPECT_EQ(ErrorAfter("\"family\"", "\"anything\""), "no error");  // in the provenance
}

TEST(ModelFile, RefusesUnknownKeysOfAVerdict) {
  const auto error_of = [](const std::string& cause) {
    return ModelError(VerdictWithCauses(cause, ""));
  };
  EXPECT_EQ(error_of(kLag), "no error");
  EXPECT_THAT(error_of(R"({"effect": "sensor_lag", "parameter": {}})"),
              HasSubstr("'causes[0].parameter' is not known here"));
  EXPECT_THAT(error_of(R"({"effect": "sensor_lag", "partner": "yaw", "parameters": {}})"),
              HasSubstr("'causes[0].partner' is not known here"));
  EXPECT_THAT(error_of(R"({"effect": "sensor_lag", "parameters": {"time_constant": {"value": 1},
                           "width": {"value": 2}}})"),
              HasSubstr("'causes[0].parameters.width' is not known here"));
  EXPECT_THAT(ModelError(R"({"schema": "fathom-verdict-1", "dof": "surge", "fit": {}})"),
              HasSubstr("'fit' is not known here"));
}

TEST(ModelFile, RefusesAKeyThatIsGivenTwice) {
  EXPECT_EQ(ErrorAfter("\"fit\"", "\"dof\": \"heave\", \"fit\""),
            "m.json: 'dof' is given twice, expected once.");
  EXPECT_EQ(ErrorAfter("\"std\"", "\"value\": 1511.53, \"std\""),
            "m.json: 'parameters.inertia.value' is given twice, expected once.");
  EXPECT_EQ(ModelError(R"({"a": [1, {"b": 1}, {"b": 1, "c": [], "b": 2}]})"),
            "m.json: 'a[2].b' is given twice, expected once.");
}

TEST(ModelFile, RefusesUnitsOfAnotherDof) {
  EXPECT_EQ(ErrorAfter("\"unit\": \"kg\"", "\"unit\": \"kg m^2\""),
            "m.json: 'parameters.inertia.unit' is 'kg m^2', expected 'kg'.");
  // What was identified from amperes is in amperes all through.
  EXPECT_EQ(ErrorAfter("\"force_unit\": \"N\"", "\"force_unit\": \"A\""),
            "m.json: 'parameters.inertia.unit' is 'kg', expected 'A s^2/m'.");
  EXPECT_EQ(ModelError(VerdictWithCauses(
                R"({"effect": "thrust_dead_zone", "parameters": {"width": {"value": 8,
                    "unit": "N m"}}})",
                "")),
            "m.json: 'causes[0].parameters.width.unit' is 'N m', expected 'N'.");
}

// Least squares and the adaptive law do not bound the damping.
TEST(ModelFile, RefusesNegativeDampingButOfFamiliesThatDoNotBoundIt) {
  EXPECT_EQ(ErrorAfter("31.4", "-31.4"),
            "m.json: 'parameters.linear_damping' is -31.4, expected at least 0, but for a model of "
            "the family adaptive or least_squares.");
  EXPECT_THAT(ErrorAfter("1911.21", "-1911.21"),
              HasSubstr("'parameters.quadratic_damping' is -1911.21, expected at least 0"));
  FittedModel fitted = Example();
  fitted.model.linear_damping = -31.4;
  fitted.caveats = {"linear_damping is negative."};  // words decide nothing
  fitted.provenance["family"] = "output_error";
  EXPECT_THAT(ModelError(FormatModel(fitted)), HasSubstr("'parameters.linear_damping' is -31.4"));
  fitted.provenance["family"] = "least_squares";
  EXPECT_EQ(ParseModel("m.json", FormatModel(fitted)).model.linear_damping, -31.4);
}

TEST(ModelFile, RefusesANegativeDeviation) {
  const std::string text = VerdictWithCauses(kLag, R"(, "sensor_lag.time_constant": {"value": 0.9,
      "std": -0.5})");
  EXPECT_EQ(ModelError(text),
            "m.json: 'extended.parameters.sensor_lag.time_constant.std' is -0.5, expected at "
            "least 0.");
}

TEST(ModelFile, KeepsTheRangeOfTheData) {
  FittedModel in = Example();
  EXPECT_FALSE(ParseModel("m.json", FormatModel(in)).range);  // as in files before there were any
  in.range = {.speed = {-0.75, 0.5}, .force = {-120.0, 100.5}};
  const auto out = ParseModel("m.json", FormatModel(in)).range;
  ASSERT_TRUE(out);
  EXPECT_EQ(out->speed.low, -0.75);
  EXPECT_EQ(out->speed.high, 0.5);
  EXPECT_EQ(out->force.low, -120.0);
  EXPECT_EQ(out->force.high, 100.5);
}

TEST(ModelFile, KeepsTheColourOfTheResidual) {
  FittedModel in = Example();
  EXPECT_FALSE(ParseModel("m.json", FormatModel(in)).residual_autoregression);
  in.residual_autoregression = {1.25, -0.375};
  EXPECT_EQ(ParseModel("m.json", FormatModel(in)).residual_autoregression,
            in.residual_autoregression);
  in.residual_autoregression.emplace();  // known to be white
  EXPECT_TRUE(ParseModel("m.json", FormatModel(in)).residual_autoregression->empty());
}

TEST(ModelFile, RefusesARangeThatIsNone) {
  FittedModel in = Example();
  in.range = {.speed = {0.5, -0.75}, .force = {-120.0, 100.5}};
  EXPECT_EQ(ModelError(FormatModel(in)),
            "m.json: 'fit.speed_range' is 0.5 to -0.75, expected the smaller value first.");
  EXPECT_EQ(ErrorAfter("\"mae\"", "\"speed_range\": [1], \"mae\""),
            "m.json: 'fit.speed_range' has 1 entries, expected 2: the smallest and the greatest "
            "value.");
  EXPECT_EQ(ErrorAfter("\"mae\"", "\"speed_range\": [1, 2], \"mae\""),
            "m.json: 'fit.force_range' is missing.");
}

}  // namespace
}  // namespace fathom
