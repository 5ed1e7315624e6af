// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/open_causes.h"

#include "fathom/planning/plan_experiment.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <string>

#include "error_from.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// The parts of a verdict file that are read here, of a lag of the thrusters against others.
std::string VerdictText(const std::string& verdict) {
  return R"json({"schema": "fathom-verdict-1", "noise_nmae": 0.04,
    "causes": [{"effect": "thruster_lag",
                "alternatives": ["time_offset", "buoyancy_step", "velocity_coupling(sway)"]}],
    "candidates": [
      {"effect": "time_offset", "label": "time_offset", "parameters": {"offset": {"value": 0.35}}},
      {"effect": "buoyancy_step", "label": "buoyancy_step",
       "parameters": {"jump": {"value": 1}, "time": {"value": 50}}},
      {"effect": "velocity_coupling", "label": "velocity_coupling(sway)", "partner": "sway",
       "parameters": {"coefficient": {"value": 3}}}],
    "verdict": ")json" +
         verdict + "\"}";
}

// A model whose log was a sine, with a lag.
FittedModel LaggingModel() {
  FittedModel fitted;
  fitted.force_unit = "N";
  fitted.model = {850.0, 40.0, 40.0, 0.5};
  ActiveEffect lag;
  lag.effect = FindEffect("thruster_lag");
  lag.values = {0.4};
  fitted.effects = {lag};
  fitted.covariance = Eigen::MatrixXd::Zero(5, 5);
  fitted.covariance.diagonal() << 4.0, 100.0, 9.0, 1e-3, 4e-4;
  fitted.train = {.mae = 0.01, .nmae = 0.05, .num_samples = 1000, .duration = 100.0};
  fitted.range = DataRange{{-0.2, 0.2}, {-50.0, 50.0}};
  return fitted;
}

TEST(OpenCauses, AreTheCauseAndWhatThisDofCanTellFromIt) {
  const OpenCauses open = ReadOpenCauses("v.json", VerdictText("ambiguous"), LaggingModel());
  ASSERT_EQ(open.rivals.size(), 2U);
  EXPECT_EQ(open.rivals[0].label, "thruster_lag");
  EXPECT_EQ(open.rivals[1].label, "time_offset");
  ASSERT_EQ(open.rivals[1].model.effects.size(), 1U);
  EXPECT_EQ(open.rivals[1].model.effects[0].values, (std::vector<double>{0.35}));
  EXPECT_EQ(open.rivals[1].model.baseline.inertia, 850.0);
  EXPECT_EQ(open.left_out,
            (std::vector<std::string>{
                "buoyancy_step is left out: it belongs to one run: any new run tells.",
                "velocity_coupling(sway) is left out: it needs another DOF to move."}));
  // 0.04 of the mean speed, which is 0.01 / 0.05 m/s.
  EXPECT_NEAR(open.noise, 0.008, 1e-12);
}

TEST(OpenCauses, AreNoneUnlessTheVerdictIsAmbiguous) {
  EXPECT_TRUE(ReadOpenCauses("v.json", VerdictText("explained"), LaggingModel()).rivals.empty());
}

std::string Changed(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

// The model misses 0.05 of the mean speed, five times the scatter: another cause is missing.
TEST(OpenCauses, TakeAllThatTheModelMissesForNoiseWhereThatIsFarAboveTheScatter) {
  const std::string text = Changed(VerdictText("ambiguous"), "0.04", "0.01");
  EXPECT_NEAR(ReadOpenCauses("v.json", text, LaggingModel()).noise, 0.01, 1e-12);
}

// As in the causes of a verdict: a force to divide by, a partner that is another DOF.
TEST(OpenCauses, HaveSettingsThatCanBe) {
  const auto error_of = [](const std::string& text) {
    return ErrorFrom([&] { ReadOpenCauses("v.json", text, LaggingModel()); });
  };
  const std::string text = VerdictText("ambiguous");
  EXPECT_EQ(error_of(Changed(text,
                             "\"label\": \"time_offset\"",
                             "\"label\": \"time_offset\", \"reference_force\": 0")),
            "v.json: 'candidates[0].reference_force' is 0, expected a value above 0.");
  EXPECT_EQ(error_of(Changed(text, "\"partner\": \"sway\"", "\"partner\": \"surge\""))
                .find("v.json: 'candidates[2].partner' of velocity_coupling is 'surge', expected "
                      "another DOF than surge"),
            0U);
}

TEST(OpenCauses, LeaveOutWhatTheModelHasAlready) {
  FittedModel fitted = LaggingModel();
  ActiveEffect offset;
  offset.effect = FindEffect("time_offset");
  offset.values = {0.1};
  fitted.effects = WithEffect(fitted.Extended(), offset).effects;
  const OpenCauses open = ReadOpenCauses("v.json", VerdictText("ambiguous"), fitted);
  EXPECT_TRUE(open.rivals.empty());
  ASSERT_EQ(open.left_out.size(), 3U);
  EXPECT_EQ(open.left_out[0], "time_offset is left out: the model then lists time_offset twice.");
}

TEST(OpenCauses, AreToldApartByTheirPlan) {
  PlanRequest request;
  request.model = LaggingModel();
  request.name = "v.json";
  request.limits = {.force = 60.0, .speed = 0.6, .distance = {-3.0, 5.0}};
  request.duration = 60.0;
  request.effort = 0.1;
  request.rivals = ReadOpenCauses("v.json", VerdictText("ambiguous"), request.model).rivals;
  const ExperimentPlan plan = PlanExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  EXPECT_EQ(plan.led_by, "thruster_lag");
  ASSERT_EQ(plan.separations.size(), 2U);
  for (const PlannedSeparation& separation : plan.separations) {
    EXPECT_GT(separation.sigmas, 5.0) << separation.truth;
    EXPECT_GT(separation.sigmas, 3.0 * separation.sine) << separation.truth;
  }
}

}  // namespace
}  // namespace fathom
