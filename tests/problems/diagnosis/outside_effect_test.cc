// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// An effect that the library does not know, hidden in a log, and named by a diagnosis that was told
// of it; docs/adding_an_effect.md.

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "square_root_drag.h"
#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kCoefficient = 40.0;

std::vector<Log> LogsWith(const Effect* effect) {
  SurgeRun run;
  run.input = Steps({60.0, 5.0, -20.0, -60.0, 10.0, 30.0, -5.0, 0.0}, 12.0);
  run.duration = 200.0;
  run.velocity_noise = 0.003;
  run.more = {{effect, {}, {kCoefficient}}};
  return {LogOf(run, 1)};
}

TEST(OutsideEffect, IsNamedByADiagnosisThatKnowsIt) {
  static const EffectOf<SquareRootDrag> square_root_drag;
  DiagnosisOptions options;
  options.effects.assign(EffectCatalogue().begin(), EffectCatalogue().end());
  options.effects.push_back(&square_root_drag);
  const Diagnosis diagnosis = Diagnose(LogsWith(&square_root_drag), Dof::kSurge, options);
  EXPECT_EQ(diagnosis.verdict, Verdict::kExplained);
  ASSERT_EQ(diagnosis.causes.size(), 1u);
  EXPECT_TRUE(diagnosis.causes[0].alternatives.empty());
  const ActiveEffect& named = diagnosis.extended.model.effects.at(0);
  EXPECT_EQ(named.effect, &square_root_drag);
  EXPECT_NEAR(named.values[0], kCoefficient, 4.0 * std::sqrt(diagnosis.extended.covariance(4, 4)));
  EXPECT_LT(std::sqrt(diagnosis.extended.covariance(4, 4)), 0.2 * kCoefficient);
}

TEST(OutsideEffect, IsNotNamedByADiagnosisThatDoesNot) {
  static const EffectOf<SquareRootDrag> square_root_drag;
  const Diagnosis diagnosis = Diagnose(LogsWith(&square_root_drag), Dof::kSurge);
  for (const ActiveEffect& active : diagnosis.extended.model.effects) {
    EXPECT_NE(active.effect, &square_root_drag);
  }
  EXPECT_NE(diagnosis.verdict, Verdict::kConsistent);
}

// A wall that is not still: the marker goes to and fro by 10 cm a minute. No effect of the
// catalogue does, and the velocities know nothing of it; the page needs the poses to show it.
TEST(OutsideEffect, IsShownInThePosesTooWhereNothingExplainsIt) {
  constexpr double kSwing = 0.1, kFrequency = 0.1;  // [m], [rad/s]
  SurgeRun run;
  run.input = Multisine(40.0);
  run.duration = 200.0;
  run.has_poses = true;
  Log log = LogOf(run, 1);
  const auto x = std::find(log.pose->columns.begin(), log.pose->columns.end(), "x");
  std::vector<double>& position = log.pose->values[x - log.pose->columns.begin()];
  for (size_t k = 0; k < position.size(); ++k) {
    position[k] += kSwing * std::sin(kFrequency * log.pose->time[k]);
  }
  const Diagnosis diagnosis = Diagnose(std::vector<Log>{log}, Dof::kSurge);
  EXPECT_EQ(diagnosis.verdict, Verdict::kUnexplained);
  ASSERT_EQ(diagnosis.pose_traces.size(), 1u);
  EXPECT_EQ(diagnosis.pose_traces[0].time, log.pose->time);
  EXPECT_EQ(diagnosis.pose_traces[0].measured, position);
}

}  // namespace
}  // namespace fathom
