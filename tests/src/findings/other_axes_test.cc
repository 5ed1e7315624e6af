// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/other_axes.h"

#include "fathom/base/random_stream.h"
#include "fathom/signal/signals.h"

#include <array>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

// Five minutes of a boat that surges, sways and yaws at random steps, at 10 Hz with the noise of a
// sensor: M = diag(48, 81, 16) and linear damping, integrated in steps of 1 ms. With `coriolis`
// 1 C(nu) follows from M, with 0 each axis moves by itself.
Log Boat(int seed, double coriolis) {
  constexpr std::array<double, 3> kInertia = {48.0, 81.0, 16.0}, kDamping = {145.0, 125.0, 33.0};
  RandomStream random(seed, "boat");
  Log log;
  log.command = Stream{{}, {"tau_surge", "tau_sway", "tau_yaw"}, {{}, {}, {}}};
  log.velocity = Stream{{}, {"u", "v", "r"}, {{}, {}, {}}};
  std::array<double, 3> force = {}, nu = {};
  for (int i = 0; i < 3000; ++i) {
    if (i % 37 == 0) force[0] = 160.0 * random.Uniform();
    if (i % 53 == 0) force[1] = 60.0 * (random.Uniform() - 0.5);
    if (i % 41 == 0) force[2] = 20.0 * (random.Uniform() - 0.5);
    for (std::size_t k = 0; k < 3; ++k) {
      log.command->values[k].push_back(force[k]);
      log.velocity->values[k].push_back(nu[k] + 0.005 * random.Normal());
    }
    log.command->time.push_back(0.1 * i);
    log.velocity->time.push_back(0.1 * i);
    for (int step = 0; step < 100; ++step) {
      const std::array<double, 3> of_others = {kInertia[1] * nu[1] * nu[2],
                                               -kInertia[0] * nu[0] * nu[2],
                                               (kInertia[0] - kInertia[1]) * nu[0] * nu[1]};
      for (std::size_t k = 0; k < 3; ++k) {
        nu[k] += 1e-3 * (force[k] + coriolis * of_others[k] - kDamping[k] * nu[k]) / kInertia[k];
      }
    }
  }
  return log;
}

std::optional<Finding> Checked(const Log& log, Dof dof) {
  return CheckOtherAxes(log, dof, SignalsOf(log, dof).train);
}

TEST(OtherAxes, FindsTheProductThatActsOnEachAxis) {
  const Log log = Boat(1, 1.0);
  const auto surge = Checked(log, Dof::kSurge), sway = Checked(log, Dof::kSway),
             yaw = Checked(log, Dof::kYaw);
  ASSERT_TRUE(surge && sway && yaw);
  EXPECT_EQ(surge->code, "other_axes");
  EXPECT_THAT(surge->sentence, HasSubstr("v times r"));
  EXPECT_THAT(sway->sentence, HasSubstr("u times r"));
  EXPECT_THAT(yaw->sentence, HasSubstr("u times v"));
}

TEST(OtherAxes, TellsTheInertiaThatTheProductUncovers) {
  const auto yaw = Checked(Boat(2, 1.0), Dof::kYaw);
  ASSERT_TRUE(yaw);
  EXPECT_THAT(yaw->sentence, ContainsRegex("the inertia is 16[.0-9]* kg m.*2 with it"));
}

TEST(OtherAxes, SaysNothingWhereEachAxisMovesByItself) {
  int num_findings = 0;
  for (int seed = 0; seed < 30; ++seed) {
    const Log log = Boat(seed, 0.0);
    for (const Dof dof : {Dof::kSurge, Dof::kSway, Dof::kYaw}) {
      if (Checked(log, dof)) ++num_findings;
    }
  }
  EXPECT_EQ(num_findings, 0);
}

TEST(OtherAxes, SaysNothingWithoutTheOtherVelocities) {
  Log log = Boat(1, 1.0);
  log.velocity->columns[1] = "w";
  EXPECT_FALSE(Checked(log, Dof::kSurge));
}

}  // namespace
}  // namespace fathom
