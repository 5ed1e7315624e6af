// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/followed_command.h"

#include "fathom/base/random_stream.h"

#include <cmath>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::IsEmpty;

// Two minutes of steps of random force along surge, and of others along sway; each velocity follows
// its own as a linear drag makes it, with a time constant of 1.6 s.
Log StepsOfTwo() {
  RandomStream random(3, "steps of two");
  Log log;
  log.command = Stream{{}, {"tau_surge", "tau_sway"}, {{}, {}}};
  log.velocity = Stream{{}, {"u", "v"}, {{}, {}}};
  double force[2] = {}, speed[2] = {};
  for (int i = 0; i < 1200; ++i) {
    for (int k = 0; k < 2; ++k) {
      if (i % (40 + 13 * k) == 0) force[k] = 40.0 * (random.Uniform() - 0.5);
      log.command->values[k].push_back(force[k]);
      log.velocity->values[k].push_back(speed[k] + 0.01 * random.Normal());
      speed[k] += (force[k] / 25.0 - speed[k]) * (1.0 - std::exp(-0.1 / 1.6));
    }
    log.command->time.push_back(0.1 * i);
    log.velocity->time.push_back(0.1 * i);
  }
  return log;
}

auto CodesAre(const char* code) { return ElementsAre(Field(&Finding::code, code)); }

void LoseSign(std::vector<double>* values) {
  for (double& value : *values) value = std::abs(value);
}

TEST(FollowedCommand, SaysNothingOfAVehicleThatFollowsItsOwn) {
  const Log log = StepsOfTwo();
  EXPECT_THAT(CheckFollowedCommand(log, Dof::kSurge), IsEmpty());
  EXPECT_THAT(CheckFollowedCommand(log, Dof::kSway), IsEmpty());
}

TEST(FollowedCommand, FindsASpeedWithoutItsSign) {
  Log log = StepsOfTwo();
  LoseSign(&log.velocity->values[0]);
  EXPECT_THAT(CheckFollowedCommand(log, Dof::kSurge), CodesAre("unsigned_speed"));
}

TEST(FollowedCommand, FindsACommandWithoutItsSign) {
  Log log = StepsOfTwo();
  LoseSign(&log.command->values[0]);
  EXPECT_THAT(CheckFollowedCommand(log, Dof::kSurge), CodesAre("unsigned_command"));
}

TEST(FollowedCommand, FindsSwappedAxes) {
  Log log = StepsOfTwo();
  log.velocity->columns = {"v", "u"};
  EXPECT_THAT(CheckFollowedCommand(log, Dof::kSurge), CodesAre("swapped_axes"));
  EXPECT_THAT(CheckFollowedCommand(log, Dof::kSway), CodesAre("swapped_axes"));
}

// A vehicle that is only ever pushed ahead goes ahead: that is no lost sign.
TEST(FollowedCommand, AllowsAVehicleThatOnlyGoesAhead) {
  Log log = StepsOfTwo();
  LoseSign(&log.command->values[0]);
  double speed = 0.0;
  for (std::size_t i = 0; i < 1200; ++i) {
    log.velocity->values[0][i] = speed;
    speed += (log.command->values[0][i] / 25.0 - speed) * (1.0 - std::exp(-0.1 / 1.6));
  }
  EXPECT_THAT(CheckFollowedCommand(log, Dof::kSurge), IsEmpty());
}

// R^2 of a first-order answer is 1 at its own lag.
TEST(FollowedCommand, IsAllOfAnAnswerOfFirstOrder) {
  HeldCommand command = {{0.0, 5.0, 12.0, 20.0}, {1.0, -2.0, 0.5, 3.0}};
  std::vector<double> time, value;
  double state = 0.0;
  for (int i = 0; i < 300; ++i) {
    time.push_back(0.1 * i);
    value.push_back(state);
    state += (command.At(0.1 * i + 0.05) - state) * (1.0 - std::exp(-0.1 / 3.0));
  }
  EXPECT_NEAR(ShareFollowed(time, value, command), 1.0, 1e-9);
}

}  // namespace
}  // namespace fathom
