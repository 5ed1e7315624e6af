// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/effect_inputs.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// Surge and yaw commanded, surge and yaw rate measured.
Log VelocityLog() {
  Log log;
  log.path = "tank_07";
  log.command = Stream{{0.0, 1.0}, {"tau_surge", "tau_yaw"}, {{2.0, 3.0}, {4.0, 5.0}}};
  log.velocity = Stream{{0.5, 1.5}, {"u", "r"}, {{0.1, 0.2}, {0.3, 0.4}}};
  return log;
}

ActiveEffect WithPartner(const char* name, Dof partner, double value) {
  return {FindEffect(name), {.dof = Dof::kSurge, .partner = partner}, {value}};
}

std::string ErrorOf(const ActiveEffect& effect, const Log& log) {
  return ErrorFrom([&] { RequirePartners({{}, {effect}}, EffectInputsOf(log, Dof::kSurge), log); });
}

TEST(EffectInputs, HoldEveryCommandAndMeasuredVelocity) {
  const EffectInputs inputs = EffectInputsOf(VelocityLog(), Dof::kSurge);
  EXPECT_EQ(inputs.command.value, (std::vector<double>{2.0, 3.0}));
  EXPECT_EQ(inputs.force[Index(Dof::kYaw)].value, (std::vector<double>{4.0, 5.0}));
  EXPECT_TRUE(inputs.force[Index(Dof::kSway)].time.empty());
  EXPECT_EQ(inputs.velocity[Index(Dof::kYaw)].value, (std::vector<double>{0.3, 0.4}));
  EXPECT_TRUE(inputs.velocity[Index(Dof::kSway)].time.empty());
}

// Drifting to starboard at 0.25 m/s, upright: a parabola's and a line's slope are exact.
TEST(EffectInputs, TakeFromThePosesWhatTheVelocitiesLack) {
  Log log = VelocityLog();
  Stream pose = {{}, {"x", "y", "z", "qx", "qy", "qz", "qw"}, {{}, {}, {}, {}, {}, {}, {}}};
  for (int i = 0; i < 50; ++i) {
    pose.time.push_back(0.1 * i);
    const double row[] = {0.0, 0.25 * 0.1 * i, 0.0, 0.0, 0.0, 0.0, 1.0};
    for (int k = 0; k < 7; ++k) pose.values[k].push_back(row[k]);
  }
  log.pose = pose;
  const EffectInputs inputs = EffectInputsOf(log, Dof::kSurge);
  const SampledSignal& sway = inputs.velocity[Index(Dof::kSway)];
  ASSERT_EQ(sway.value.size(), 50u);
  for (const double v : sway.value) EXPECT_NEAR(v, 0.25, 1e-9);
  EXPECT_EQ(inputs.velocity[Index(Dof::kYaw)].value, (std::vector<double>{0.3, 0.4}));
}

TEST(RequirePartners, SaysWhichEffectMissesWhat) {
  const Log log = VelocityLog();
  EXPECT_EQ(ErrorOf(WithPartner("velocity_coupling", Dof::kYaw, 2.0), log), "no error");
  EXPECT_EQ(ErrorOf(WithPartner("thrust_crosstalk", Dof::kYaw, 2.0), log), "no error");
  EXPECT_EQ(
      ErrorOf(WithPartner("velocity_coupling", Dof::kSway, 2.0), log),
      "tank_07: the model's velocity_coupling(sway) needs the measured sway velocity, expected "
      "column 'v' in velocity.csv, or a pose.csv.");
  EXPECT_EQ(ErrorOf(WithPartner("thrust_crosstalk", Dof::kHeave, 2.0), log),
            "tank_07: the model's thrust_crosstalk(heave) needs the command of heave, expected "
            "column 'tau_heave' in command.csv.");
  Log without_yaw = log;
  without_yaw.velocity = Stream{{0.5, 1.5}, {"u", "v"}, {{0.1, 0.2}, {0.3, 0.4}}};
  EXPECT_THAT(ErrorOf(WithPartner("coriolis_coupling", Dof::kSway, 2.0), without_yaw),
              HasSubstr("needs the measured yaw velocity"));
}

}  // namespace
}  // namespace fathom
