// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// How a log is sampled, or a simulation stepped, shifts it by a part of a step.

#include "fathom/base/random_stream.h"
#include "fathom/diagnosis/diagnosis.h"

#include <cmath>
#include <span>

#include "named.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

// A vehicle that rolls against a righting moment, as a simulation wrote it that goes by Euler's
// steps of 10 ms and logs at 50 Hz.
Log SteppedRoll() {
  constexpr double kStep = 0.01;
  RandomStream random(7, "stepped roll");
  Log log;
  log.name = "stepped";
  log.dofs = {Dof::kRoll};
  log.command = Stream{.time = {}, .columns = {"tau_roll"}, .values = {{}}};
  log.velocity = Stream{.time = {}, .columns = {"p"}, .values = {{}}};
  log.pose = Stream{.time = {}, .columns = {"qx", "qy", "qz", "qw"}, .values = {{}, {}, {}, {}}};
  double p = 0.0, roll = 0.0, tau = 0.0;
  int held = 0;
  for (int k = 0; k < 6000; ++k) {
    const double t = kStep * k;
    if (held-- == 0) {
      tau = 1.6 * (2.0 * random.Uniform() - 1.0);
      held = 20 + static_cast<int>(40.0 * random.Uniform());
      log.command->time.push_back(t);
      log.command->values[0].push_back(tau);
    }
    if (k % 2 == 0) {
      log.velocity->time.push_back(t);
      log.velocity->values[0].push_back(p + 0.003 * random.Normal());
      log.pose->time.push_back(t);
      const double half = 0.5 * (roll + 0.001 * random.Normal());
      log.pose->values[0].push_back(std::sin(half));
      log.pose->values[1].push_back(0.0);
      log.pose->values[2].push_back(0.0);
      log.pose->values[3].push_back(std::cos(half));
    }
    const double rate = (tau - 1.0 * p - 0.3 * std::abs(p) * p - 1.0 * std::sin(roll)) / 0.35;
    roll += kStep * p;
    p += kStep * rate;
  }
  return log;
}

Diagnosis DiagnosedRollOf(const Log& log) {
  return Diagnose(std::span<const Log>(&log, 1), Dof::kRoll);
}

TEST(DelaysUnderHalfOfAStep, AreNotNamedBesideTheCause) {
  const Diagnosis fine = DiagnosedRollOf(SteppedRoll());
  ASSERT_TRUE(fine.IsUsable()) << fine.message;
  EXPECT_EQ(TextOf(fine), "explained: righting_moment");
  EXPECT_THAT(fine.remarks, Contains(HasSubstr("half of the step")));
}

}  // namespace
}  // namespace fathom
