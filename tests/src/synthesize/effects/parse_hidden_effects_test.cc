// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/effects/parse_hidden_effects.h"

#include "fathom/base/input_error.h"
#include "fathom/synthesize/effects/unlisted_effects.h"
#include "fathom/synthesize/synthesize.h"
#include "fathom/synthesize/truth_file.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

InputSignal Prbs(double amplitude) { return {0.0, PrbsInput{.amplitude = amplitude, .hold = 2.0}}; }

Vehicle Probe() {
  Vehicle vehicle;
  vehicle.name = "probe";
  vehicle.models[Index(Dof::kSurge)] = {85.0, 28.6, 13.9, -0.8};
  vehicle.models[Index(Dof::kSway)] = {95.0, 38.6, 23.9, 0.4};
  vehicle.models[Index(Dof::kYaw)] = {30.0, 28.0, 12.7, 0.1};
  return vehicle;
}

Experiment SurgeSwayYaw() {
  Experiment experiment;
  experiment.name = "run";
  experiment.duration = 120.0;
  experiment.command_rate = 10.0;
  experiment.drives = {{.dof = Dof::kSurge, .input = Prbs(20.0), .pid = {}},
                       {.dof = Dof::kSway, .input = Prbs(15.0), .pid = {}},
                       {.dof = Dof::kYaw, .input = Prbs(5.0), .pid = {}}};
  experiment.velocity.emplace();
  experiment.pose.emplace();
  return experiment;
}

std::vector<ActiveEffect> Parse(const std::string& text, std::uint64_t seed = 1) {
  static const auto scales = ScalesOf(Probe(), SurgeSwayYaw(), 1);
  return ParseHiddenEffects(text, SurgeSwayYaw(), scales, seed);
}

std::string MessageOf(const std::string& text) {
  return ErrorFrom([&] { Parse(text); });
}

TEST(ParseHiddenEffects, ReadsNamesValuesDofsAndPartners) {
  EXPECT_TRUE(Parse("").empty());
  const auto effects = Parse(
      "thruster_lag:time_constant=0.5,yaw.buoyancy_step:time=40:jump=-2.5,"
      "sway.velocity_coupling:partner=yaw:coefficient=3,unlisted.thrust_levels:step=7,"
      "yaw.unlisted.thrust_levels:step=2");
  ASSERT_EQ(effects.size(), 5u);
  EXPECT_EQ(effects[0].effect, FindEffect("thruster_lag"));
  EXPECT_EQ(effects[0].setting.dof, Dof::kSurge);
  EXPECT_THAT(effects[0].values, ElementsAre(0.5));
  EXPECT_EQ(effects[1].setting.dof, Dof::kYaw);
  EXPECT_THAT(effects[1].values, ElementsAre(-2.5, 40.0));
  EXPECT_EQ(effects[2].setting.dof, Dof::kSway);
  EXPECT_EQ(effects[2].setting.partner, Dof::kYaw);
  EXPECT_EQ(effects[3].effect, FindUnlistedEffect("unlisted.thrust_levels"));
  EXPECT_EQ(effects[3].setting.dof, Dof::kSurge);
  EXPECT_EQ(effects[4].setting.dof, Dof::kYaw);
  EXPECT_EQ(Describe(effects[1]), "yaw.buoyancy_step: jump = -2.5 N m, time = 40 s");
  EXPECT_EQ(Describe(effects[2]), "sway.velocity_coupling: coefficient = 3 kg/s, partner yaw");
}

TEST(ParseHiddenEffects, TakesTheRmsOfTheCommandAsReference) {
  EXPECT_DOUBLE_EQ(Parse("thrust_curve")[0].setting.reference_force, 20.0);
  EXPECT_DOUBLE_EQ(Parse("yaw.thrust_curve")[0].setting.reference_force, 5.0);
}

TEST(ParseHiddenEffects, ChoosesAPartnerThatCanBeOne) {
  EXPECT_EQ(Parse("velocity_coupling")[0].setting.partner, Dof::kSway);
  EXPECT_EQ(Parse("yaw.velocity_coupling")[0].setting.partner, Dof::kSurge);
  EXPECT_EQ(Parse("lever_arm")[0].setting.partner, Dof::kYaw);
  EXPECT_EQ(Parse("sway.coriolis_coupling")[0].setting.partner, Dof::kSurge);
  EXPECT_EQ(Parse("sensor_misalignment")[0].setting.partner, Dof::kSway);
}

TEST(ParseHiddenEffects, DrawsWhatIsNotGivenFromItsOwnNumbers) {
  const auto alone = Parse("buoyancy_step");
  EXPECT_EQ(Parse("buoyancy_step")[0].values, alone[0].values);
  EXPECT_EQ(Parse("thruster_lag,buoyancy_step")[1].values, alone[0].values);
  EXPECT_NE(Parse("buoyancy_step", 2)[0].values, alone[0].values);
  EXPECT_NE(Parse("yaw.buoyancy_step")[0].values, alone[0].values);
  EXPECT_THAT(Parse("buoyancy_step:time=33")[0].values, ElementsAre(alone[0].values[0], 33.0));
}

TEST(ParseHiddenEffects, SaysWhatThereIs) {
  EXPECT_THAT(MessageOf("slow"),
              AllOf(HasSubstr("--effects: 'slow' is no effect, expected one of "
                              "time_offset, thrust_dead_zone, "),
                    HasSubstr("unlisted.slack_tether")));
  EXPECT_EQ(MessageOf("thruster_lagg"),
            "--effects: 'thruster_lagg' is no effect, did you mean thruster_lag?");
  EXPECT_THAT(MessageOf("thruster_lag,"), HasSubstr("'' is no effect"));
  EXPECT_EQ(MessageOf("heave.thruster_lag"),
            "--effects: 'heave' is not a DOF that the experiment drives, expected one of surge, "
            "sway, yaw.");
  EXPECT_EQ(MessageOf("buoyancy_step:size=3"),
            "--effects: buoyancy_step: 'size=3' sets no parameter, expected jump=... or time=...");
  EXPECT_THAT(MessageOf("buoyancy_step:jump"), HasSubstr("'jump' sets no parameter"));
  EXPECT_EQ(MessageOf("thruster_lag:time_constant=fast"),
            "--effects: thruster_lag's time_constant is 'fast', expected a number from 0 to 20.");
  EXPECT_EQ(MessageOf("righting_moment"),
            "--effects: righting_moment does not act along surge, expected an experiment that "
            "drives roll or pitch.");
  EXPECT_THAT(MessageOf("yaw.righting_moment"), HasSubstr("does not act along yaw"));
  EXPECT_EQ(
      MessageOf("thrust_dead_zone:width=inf"),
      "--effects: thrust_dead_zone's width is 'inf', expected a finite number of at least 0.");
  EXPECT_THAT(MessageOf("thruster_lag:time_constant=21"), HasSubstr("is '21', expected a number"));
  EXPECT_THAT(MessageOf("thruster_lag:time_constant=1:time_constant=2"),
              HasSubstr("thruster_lag: time_constant is given twice"));
  EXPECT_THAT(MessageOf("thruster_lag,surge.thruster_lag"),
              HasSubstr("surge.thruster_lag is given twice"));
  EXPECT_EQ(MessageOf("velocity_coupling:partner=surge"),
            "--effects: surge.velocity_coupling's partner is 'surge', expected sway, yaw.");
  EXPECT_THAT(MessageOf("lever_arm:partner=sway"), HasSubstr("expected yaw."));
  EXPECT_THAT(MessageOf("thruster_lag:partner=yaw"), HasSubstr("sets no parameter"));
}

TEST(ParseHiddenEffects, RefusesToDrawFromNothing) {
  std::array<Scales, 6> scales = {};
  EXPECT_THAT([&] { ParseHiddenEffects("cubic_damping", SurgeSwayYaw(), scales, 1); },
              testing::ThrowsMessage<InputError>(HasSubstr("cubic_damping's coefficient cannot be "
                                                           "drawn")));
  EXPECT_NO_THROW(ParseHiddenEffects("cubic_damping:coefficient=3", SurgeSwayYaw(), scales, 1));
}

// Every effect, listed or not, of the first DOF, with sizes from ten seeds.
class DrawnSizes : public testing::TestWithParam<const Effect*> {};

TEST_P(DrawnSizes, ChangeTheLogVisiblyButDoNotDrownIt) {
  Experiment experiment = SurgeSwayYaw();
  // Two levels do not show a thrust curve.
  experiment.drives[0].input = {0.0, ChirpInput{20.0, 0.1, 1.5, 60.0}};
  if (GetParam()->info().needs_pose) experiment.drives.resize(1);
  Vehicle vehicle = Probe();
  if (!CanActAlong(GetParam()->info(), Dof::kSurge)) {
    vehicle.models = {};
    vehicle.models[Index(Dof::kRoll)] = Probe().models[Index(Dof::kSurge)];
    experiment.drives.resize(1);
    experiment.drives[0].dof = Dof::kRoll;
  }
  const auto scales = ScalesOf(vehicle, experiment, 1);
  const Scales& scale = scales[Index(experiment.drives[0].dof)];
  const Log plain = Synthesize(vehicle, experiment, 1);
  double least = 1e9, most = 0.0;
  for (int seed = 1; seed <= 10; ++seed) {
    const auto effects =
        ParseHiddenEffects(std::string(GetParam()->info().name), experiment, scales, seed);
    const Log log = Synthesize(vehicle, experiment, effects, 1);
    double change = 0.0;
    if (GetParam()->info().needs_pose) {
      for (std::size_t i = 0; i < plain.pose->time.size(); ++i) {
        // A clock's offset moves the vehicle by its speed times it.
        const double late = log.pose->time[i] - plain.pose->time[i];
        const double moved = log.pose->values[0][i] - plain.pose->values[0][i];
        change +=
            std::pow(moved / scale.length, 2) + std::pow(late * scale.speed / scale.length, 2);
      }
    } else {
      for (std::size_t i = 0; i < plain.velocity->time.size(); ++i) {
        const double moved = log.velocity->values[0][i] - plain.velocity->values[0][i];
        change += std::pow(moved / scale.speed, 2);
      }
    }
    change = std::sqrt(change / plain.velocity->time.size());
    least = std::min(least, change);
    most = std::max(most, change);
  }
  // Noise of a few per cent over a thousand samples hides no more than this.
  EXPECT_GT(least, 0.003);
  EXPECT_LT(most, 1.5);
}

std::vector<const Effect*> AllEffects() {
  std::vector<const Effect*> all(EffectCatalogue().begin(), EffectCatalogue().end());
  all.insert(all.end(), UnlistedEffects().begin(), UnlistedEffects().end());
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, DrawnSizes, testing::ValuesIn(AllEffects()), [](const auto& info) {
  std::string name(info.param->info().name);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

TEST(TruthFile, HoldsModelsAndEffects) {
  const std::string text =
      FormatTruth(Probe(),
                  SurgeSwayYaw(),
                  Parse("thruster_lag:time_constant=0.5,unlisted.thrust_levels:step=7"),
                  3);
  EXPECT_THAT(text,
              AllOf(HasSubstr("\"schema\": \"fathom-truth-1\""),
                    HasSubstr("\"seed\": 3"),
                    HasSubstr("\"value\": 28.6"),
                    HasSubstr("\"effect\": \"thruster_lag\""),
                    HasSubstr("\"in_catalogue\": true"),
                    HasSubstr("\"in_catalogue\": false")));
}

}  // namespace
}  // namespace fathom
