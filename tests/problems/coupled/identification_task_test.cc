// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/identification_task.h"

#include "fathom/base/input_error.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

// 10 Hz for 10 s along one axis.
Log StraightLog(const char* folder) {
  Log log;
  log.name = "dive";
  log.path = folder;
  log.command = Stream{.time = {0.0}, .columns = {"tau_surge"}, .values = {{2.0}}};
  log.velocity = Stream{.time = {}, .columns = {"u"}, .values = {{}}};
  for (int k = 0; k <= 100; ++k) {
    log.velocity->time.push_back(0.1 * k);
    log.velocity->values[0].push_back(0.01 * k);
  }
  return log;
}

TEST(IdentificationTaskOf, TellsLogsOfOneNameApart) {
  const IdentificationTask task =
      IdentificationTaskOf({StraightLog("monday"), StraightLog("tuesday")}, {Dof::kSurge}, {});
  EXPECT_EQ(task.logs.data[0].log, "dive (monday)");
  EXPECT_EQ(task.logs.data[1].inputs.log, "dive (tuesday)");
}

// Its first samples go on the velocities at its start.
TEST(IdentificationTaskOf, RefusesWindowsOfFewSamples) {
  CoupledFitOptions fit;
  fit.window = 0.5;
  EXPECT_NO_THROW(IdentificationTaskOf({StraightLog("monday")}, {Dof::kSurge}, fit));
  fit.window = 0.2;
  EXPECT_THROW(IdentificationTaskOf({StraightLog("monday")}, {Dof::kSurge}, fit), InputError);
}

}  // namespace
}  // namespace fathom
