// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/command_search.h"

#include "fathom/planning/one_dof_judge.h"
#include "fathom/planning/planned_motion.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "tank_trial.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kHalfMinute = 30.0;

// How far a vehicle goes to either side under a command and while it coasts behind it [m].
double GreatestDistance(const TankVehicle& vehicle, const HeldCommand& command) {
  const TrueRun run = RunTruth(vehicle.truth, command, kHalfMinute + 10.0);
  double greatest = 0.0;
  for (const double x : run.displacement) greatest = std::max(greatest, std::abs(x));
  return greatest;
}

HeldCommand CommandOf(const std::vector<WrenchBlock>& blocks) {
  return CommandOfCells(ForcesAlong(blocks, 0), 1.0);
}

// The command under which a vehicle goes farthest, of those that keep within 4 m and that others
// keep.
FoundCommand FarthestOf(const TankVehicle& vehicle,
                        const std::function<bool(const HeldCommand& command)>& is_kept) {
  OneDofQuestion question = {.limits = vehicle.limits,
                             .stamps = PlannedStamps(kHalfMinute, 0.1),
                             .limit_stamps = LimitStamps(1.0, kHalfMinute + 10.0, 0.1),
                             .models = {ExtendedModel{vehicle.truth}},
                             .measure = [&](const HeldCommand& command, auto stamps) {
                               return stamps.empty() ? 0.0 : GreatestDistance(vehicle, command);
                             }};
  question.limits.distance = {-4.0, 4.0};
  question.limits.shortest_hold = 1.0;
  CommandTask task;
  task.axes = {{Dof::kSurge, vehicle.limits.force}};
  task.duration = kHalfMinute;
  task.judge = [&](double share) { return OneDofJudge(question, share); };
  task.is_kept_by_others = [&](const auto& blocks) { return is_kept(CommandOf(blocks)); };
  task.num_starts = 1;
  task.num_moves_of_start = 200;
  task.num_moves = 200;
  return SearchCommand(task);
}

TEST(SearchCommand, GoesAsFarAsTheLimitsLet) {
  const TankVehicle vehicle = DrawTankVehicle(5);
  const FoundCommand found = FarthestOf(vehicle, [](const HeldCommand&) { return true; });
  const double distance = GreatestDistance(vehicle, CommandOf(found.blocks));
  EXPECT_GT(distance, 3.8);
  EXPECT_LE(distance, 4.001);
}

// 2 % narrower each time: 3.28 m are kept by limits of 3.27 m.
TEST(SearchCommand, GoesNoFartherThanOthersLet) {
  const TankVehicle vehicle = DrawTankVehicle(5);
  const FoundCommand found = FarthestOf(vehicle, [&](const HeldCommand& command) {
    return GreatestDistance(vehicle, command) <= 3.28;
  });
  const double distance = GreatestDistance(vehicle, CommandOf(found.blocks));
  EXPECT_GT(distance, 3.0);
  EXPECT_LE(distance, 3.28);
}

TEST(SearchCommand, FindsNothingThatOthersNeverLet) {
  const TankVehicle vehicle = DrawTankVehicle(5);
  EXPECT_TRUE(FarthestOf(vehicle, [](const HeldCommand&) { return false; }).blocks.empty());
}

}  // namespace
}  // namespace fathom
