// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_search.h"

#include <algorithm>
#include <cmath>

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

// Which of all commands of a vehicle goes farthest.
CommandTask FarthestIn(const TankVehicle& vehicle) {
  CommandTask task;
  task.limits = vehicle.limits;
  task.limits.distance = {-4.0, 4.0};
  task.duration = kHalfMinute;
  task.models = {ExtendedModel{vehicle.truth}};
  task.num_starts = 1;
  task.num_moves = 200;
  task.measure = [vehicle](const HeldCommand& command, std::span<const double> stamps) {
    return stamps.empty() ? 0.0 : GreatestDistance(vehicle, command);
  };
  task.is_kept_by_others = [](const HeldCommand&) { return true; };
  return task;
}

HeldCommand CommandOf(const CommandTask& task, const FoundCommand& found) {
  return CommandOfCells(ForcesOf(found.blocks), task.limits.shortest_hold);
}

TEST(SearchCommand, GoesAsFarAsTheLimitsLet) {
  const TankVehicle vehicle = DrawTankVehicle(5);
  const CommandTask task = FarthestIn(vehicle);
  const double distance = GreatestDistance(vehicle, CommandOf(task, SearchCommand(task)));
  EXPECT_GT(distance, 3.8);
  EXPECT_LE(distance, 4.001);
}

// 2 % narrower each time: 3.28 m are kept by limits of 3.27 m.
TEST(SearchCommand, GoesNoFartherThanOthersLet) {
  const TankVehicle vehicle = DrawTankVehicle(5);
  CommandTask task = FarthestIn(vehicle);
  task.is_kept_by_others = [vehicle](const HeldCommand& command) {
    return GreatestDistance(vehicle, command) <= 3.28;
  };
  const double distance = GreatestDistance(vehicle, CommandOf(task, SearchCommand(task)));
  EXPECT_GT(distance, 3.0);
  EXPECT_LE(distance, 3.28);
}

TEST(SearchCommand, FindsNothingThatOthersNeverLet) {
  CommandTask task = FarthestIn(DrawTankVehicle(5));
  task.is_kept_by_others = [](const HeldCommand&) { return false; };
  EXPECT_TRUE(SearchCommand(task).blocks.empty());
}

}  // namespace
}  // namespace fathom
