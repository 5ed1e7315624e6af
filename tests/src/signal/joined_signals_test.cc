// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/joined_signals.h"

#include <cmath>
#include <string>
#include <vector>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// 20 s at 10 Hz along one DOF, the last 5 s held out.
Log RunAlong(Dof dof) {
  Log log;
  log.path = "run";
  log.dofs = {dof};
  log.held_out = {{15.0, 20.05}};
  log.command = {.time = {}, .columns = {"tau_" + std::string(Name(dof))}, .values = {{}}};
  log.velocity = {.time = {}, .columns = {std::string(VelocityColumn(dof))}, .values = {{}}};
  for (int i = 0; i <= 200; ++i) {
    log.command->time.push_back(0.1 * i);
    log.command->values[0].push_back(std::sin(0.13 * i));
    log.velocity->time.push_back(0.1 * i);
    log.velocity->values[0].push_back(0.2 * std::cos(0.13 * i));
  }
  return log;
}

std::string RefusalOf(const std::vector<Log>& logs) {
  return ErrorFrom([&] { JoinSignals(logs, {}, {}); });
}

TEST(JoinSignals, KnowsWhichLogASegmentIsOf) {
  Log second = RunAlong(Dof::kSurge);
  second.held_out = {{5.0, 15.0}};
  const std::vector<Log> logs = {RunAlong(Dof::kSurge), second};
  const JoinedSignals joined = JoinSignals(logs, {}, {});
  EXPECT_EQ(joined.all.dof, Dof::kSurge);
  ASSERT_EQ(joined.all.train.size(), 3u);
  EXPECT_THAT(joined.log_of_train, ElementsAre(0, 1, 1));
  EXPECT_THAT(joined.log_of_held_out, ElementsAre(0, 1));
  EXPECT_EQ(joined.all.train[2].time.front(), 15.0);
}

TEST(JoinSignals, NamesTheLogOfARemarkWhereThereAreSeveral) {
  Log second = RunAlong(Dof::kSurge);
  second.path = "folder/other";
  const JoinedSignals joined = JoinSignals(std::vector{RunAlong(Dof::kSurge), second}, {}, {});
  EXPECT_THAT(joined.all.remarks,
              ElementsAre(StartsWith("run: A Savitzky-Golay filter gives"),
                          StartsWith("other: A Savitzky-Golay filter gives")));
  const Log alone = RunAlong(Dof::kSurge);
  EXPECT_THAT(JoinSignals({&alone, 1}, {}, {}).all.remarks,
              ElementsAre(StartsWith("A Savitzky-Golay filter gives")));
}

TEST(JoinSignals, RefusesLogsOfDifferentDofsOrUnits) {
  EXPECT_THAT(RefusalOf({RunAlong(Dof::kSurge), RunAlong(Dof::kHeave)}),
              HasSubstr("names surge, but "));
  Log percent = RunAlong(Dof::kSurge);
  percent.command_unit = "%";
  EXPECT_THAT(RefusalOf({RunAlong(Dof::kSurge), percent}),
              HasSubstr("(% from velocity.csv, expected N from velocity.csv)"));
}

}  // namespace
}  // namespace fathom
