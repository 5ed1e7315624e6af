// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/model_for_log.h"

#include "fathom/log/log_fingerprint.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Log LogWithCommand(double force) {
  Log log;
  log.command = {.time = {0.0}, .columns = {"tau_surge"}, .values = {{force}}};
  return log;
}

// A lag is the vehicle's, a bias belongs to the run `dive_1`.
FittedModel ModelOfTwoLogs() {
  FittedModel model;
  model.effects = {{FindEffect("thruster_lag"), {.dof = Dof::kSurge}, {0.5}},
                   {FindEffect("sensor_bias"), {.dof = Dof::kSurge, .log = "dive_1"}, {0.1}}};
  model.logs = {"dive_1", "dive_2"};
  model.log_fingerprints = {FingerprintOf(LogWithCommand(1.0)), FingerprintOf(LogWithCommand(2.0))};
  return model;
}

TEST(RestrictToLog, KeepsAnEffectInItsOwnRunOnly) {
  const ModelForLog own = RestrictToLog(ModelOfTwoLogs(), LogWithCommand(1.0), false);
  EXPECT_EQ(own.model.effects.size(), 2u);
  EXPECT_THAT(own.left_out, IsEmpty());
  EXPECT_EQ(own.model.effects[1].setting.log, "");
  for (const double force : {2.0, 3.0}) {
    const ModelForLog other = RestrictToLog(ModelOfTwoLogs(), LogWithCommand(force), false);
    ASSERT_EQ(other.model.effects.size(), 1u);
    EXPECT_EQ(other.model.effects[0].effect, FindEffect("thruster_lag"));
    EXPECT_THAT(other.left_out, ElementsAre("sensor_bias(dive_1)"));
  }
}

TEST(RestrictToLog, KeepsAllWhereItIsAskedTo) {
  const ModelForLog kept = RestrictToLog(ModelOfTwoLogs(), LogWithCommand(3.0), true);
  EXPECT_EQ(kept.model.effects.size(), 2u);
  EXPECT_THAT(kept.left_out, IsEmpty());
}

TEST(RestrictToLog, KnowsTheLogsThatTheModelWasIdentifiedFrom) {
  for (const double force : {1.0, 2.0, 3.0}) {
    const ModelForLog own = RestrictToLog(ModelOfTwoLogs(), LogWithCommand(force), false);
    EXPECT_EQ(own.is_trained_on_it, force < 3.0) << force;
  }
}

}  // namespace
}  // namespace fathom
