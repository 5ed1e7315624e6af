// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "hidden_log.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "log_plan.h"
#include <gtest/gtest.h>

namespace fathom::hidden {
namespace {

constexpr std::uint64_t kSeed = 7;

TEST(HiddenLog, IsTheSameForASeedAndAnotherForAnother) {
  const LogPlan plan = {HiddenClass::kOneEffect, {FindEffect("thruster_lag")}, 3};
  const HiddenLog once = DrawHiddenLog(plan, kSeed), again = DrawHiddenLog(plan, kSeed);
  EXPECT_EQ(once.log.velocity->values, again.log.velocity->values);
  EXPECT_EQ(once.truth.model.effects[0].values, again.truth.model.effects[0].values);
  EXPECT_EQ(once.truth.setup, again.truth.setup);
  const HiddenLog other = DrawHiddenLog(plan, kSeed + 1);
  EXPECT_NE(once.log.velocity->values, other.log.velocity->values);
}

TEST(HiddenLog, TellsTheDiagnosisNothing) {
  const LogPlan plan = {HiddenClass::kOneEffect, {FindEffect("sensor_lag")}, 0};
  const HiddenLog hidden = DrawHiddenLog(plan, kSeed);
  EXPECT_EQ(hidden.log.name, "hidden");
  EXPECT_EQ(hidden.log.vehicle, "hidden");
  EXPECT_EQ(hidden.log.notes, "");
}

TEST(HiddenLog, PlansWhatTheIssueAsksFor) {
  const auto plans = DrawPlans({}, kSeed);
  std::map<HiddenClass, int> count;
  std::map<std::string_view, int> per_effect;
  std::set<std::string> names;
  for (const LogPlan& plan : plans) {
    ++count[plan.hidden];
    names.insert(plan.Name());
    if (plan.hidden == HiddenClass::kOneEffect) ++per_effect[plan.effects[0]->info().name];
  }
  EXPECT_GE(plans.size(), 400u);
  EXPECT_EQ(names.size(), plans.size());
  EXPECT_EQ(count[HiddenClass::kNothing], 120);
  EXPECT_EQ(count[HiddenClass::kTwoEffects], 40);
  EXPECT_EQ(count[HiddenClass::kUnlisted], 40);
  EXPECT_EQ(per_effect.size(), EffectCatalogue().size());
  for (const auto& [name, logs] : per_effect) EXPECT_GE(logs, 8) << name;
}

TEST(HiddenLog, MovesAtTheSpeedsOfVehiclesAndHoldsItsNoise) {
  for (int number = 0; number < 10; ++number) {
    const HiddenLog hidden = DrawHiddenLog({HiddenClass::kNothing, {}, number}, kSeed);
    const auto& velocity = *hidden.log.velocity->Find(VelocityColumn(hidden.dof));
    double sum2 = 0.0;
    for (const double v : velocity) sum2 += v * v;
    const double speed = std::sqrt(sum2 / static_cast<double>(velocity.size()));
    EXPECT_GT(speed, 0.04) << hidden.truth.setup;  // [m/s] or [rad/s]
    EXPECT_LT(speed, 1.1) << hidden.truth.setup;
    const SensorNoise& noise = hidden.truth.noise.model.velocity;
    const double share = std::hypot(noise.white_std, noise.coloured.std) / speed;
    EXPECT_GT(share, 0.002) << hidden.truth.setup;
    EXPECT_LT(share, 0.12) << hidden.truth.setup;
  }
}

}  // namespace
}  // namespace fathom::hidden
