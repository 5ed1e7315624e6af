// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A boat that sways and turns while it surges, without noise: what is left beside the named cause
// is rounding, and no structure is looked for in it.

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/diagnosis/report/verdict_sentence.h"

#include <cmath>
#include <cstddef>
#include <span>

#include <gmock/gmock.h>

namespace fathom {
namespace {

double SwayAt(double t) { return 0.15 * std::sin(0.31 * t) + 0.08 * std::sin(0.83 * t + 1.0); }
double YawRateAt(double t) { return 0.3 * std::sin(0.23 * t + 0.4) + 0.2 * std::sin(0.57 * t); }
double ForceOfStep(int step) { return 30.0 + 40.0 * std::sin(1.7 * step * step); }

// 48 du/dt = tau - 145 u + 81 v r, at 10 Hz for 300 s.
Log TurningBoat() {
  Log log;
  log.name = "boat";
  log.dofs = {Dof::kSurge};
  log.command.emplace();
  log.command->columns = {"tau_surge"};
  log.command->values.resize(1);
  log.velocity.emplace();
  log.velocity->columns = {"u", "v", "r"};
  log.velocity->values.resize(3);
  double u = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const double t = 0.1 * k;
    const double force = ForceOfStep(k / 25);
    log.command->time.push_back(t);
    log.command->values[0].push_back(force);
    log.velocity->time.push_back(t);
    log.velocity->values[0].push_back(u);
    log.velocity->values[1].push_back(SwayAt(t));
    log.velocity->values[2].push_back(YawRateAt(t));
    constexpr int kSteps = 100;
    for (int i = 0; i < kSteps; ++i) {  // midpoint rule
      constexpr double kStep = 0.1 / kSteps;
      const double middle = t + (i + 0.5) * kStep;
      const auto rate = [&](double speed) {
        return (force - 145.0 * speed + 81.0 * SwayAt(middle) * YawRateAt(middle)) / 48.0;
      };
      u += kStep * rate(u + 0.5 * kStep * rate(u));
    }
  }
  return log;
}

TEST(TurningBoat, WithoutNoiseIsExplainedToTheLast) {
  const Log log = TurningBoat();
  const Diagnosis diagnosis = Diagnose(std::span(&log, 1), Dof::kSurge);
  ASSERT_TRUE(diagnosis.IsUsable());
  EXPECT_EQ(diagnosis.verdict, Verdict::kExplained) << VerdictSentence(diagnosis);
  ASSERT_EQ(diagnosis.causes.size(), 1u) << VerdictSentence(diagnosis);
  const std::size_t at = static_cast<std::size_t>(diagnosis.causes[0].effect_index);
  EXPECT_EQ(diagnosis.extended.model.effects[at].effect->info().name, "coriolis_coupling");
  EXPECT_THAT(diagnosis.remarks, testing::Not(testing::Contains(testing::HasSubstr("too few"))));
}

}  // namespace
}  // namespace fathom
