// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/c_command.h"

#include "fathom/exporting/c_header.h"
#include "fathom/exporting/model_in_format.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/vehicle/coupled/fin_force.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "compiled_c.h"
#include "error_from.h"
#include "generic_models.h"
#include "written_out_rate.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// The rudder stands behind the shaft, the second one is stuck, the third is not straight.
FittedCoupledModel Ship() {
  FittedCoupledModel fitted = GenericBoat();
  CoupledModel& model = fitted.model;
  model.lift(1, 1) = 31.0;
  model.lift(1, 5) = -12.0;
  model.lift(5, 1) = 7.0;
  model.fin_force = {{"rudder", 40.0}, {"stuck", 15.0}, {"askew", 11.0}};
  model.fin_race = {{"rudder", 0.05}};
  model.fin_stuck = {{"stuck", 0.15}};
  model.fin_neutral = {{"askew", -0.07}};
  model.thrust_gain = {{"propeller", 0.9}};
  return fitted;
}

ExportTarget Target() {
  ExportTarget target = {"ship", "a test"};
  target.vehicle.emplace();
  Fin rudder, stuck, askew;
  rudder.name = "rudder";
  rudder.position = {-2.0, 0.0, 0.0};
  rudder.behind = "propeller";
  stuck.name = "stuck";
  stuck.position = {-1.8, 0.3, 0.1};
  askew.name = "askew";
  askew.position = {1.5, -0.2, 0.0};
  askew.axis = Eigen::Vector3d(0.0, 0.6, 0.8);
  target.vehicle->fins = {askew, rudder, stuck};
  Shaft propeller;
  propeller.name = "propeller";
  propeller.position = {-1.5, 0.2, 0.1};
  propeller.diameter = 0.5;
  propeller.curve = OpenWaterCurve{{0.0, 0.5, 1.0}, {0.4, 0.25, 0.1}};
  propeller.wake = 0.2;
  propeller.thrust_deduction = 0.1;
  target.vehicle->shafts = {propeller};
  return target;
}

// One fin at x = -2 m whose span points down, behind a propeller. At u = 2 m/s and 4 Hz
// J = 0.8 x 2 / (4 x 0.5) = 0.8, K_T = 0.16, T = 1000 x 16 x 0.5^4 x 0.16 = 160 N, of which 0.9 x
// 0.9 acts on the ship; with 5 N of tau s^2 = 4 + 0.05 x 165 = 12.25.
TEST(CCommand, GivesTheForcesOfARudderInTheRaceOfAShaft) {
  FittedCoupledModel fitted = Ship();
  fitted.model.fin_force = {{"rudder", 40.0}};
  ExportTarget target = Target();
  target.vehicle->shafts[0].position = {-1.5, 0.0, 0.0};
  const std::vector<double> numbers =
      NumbersPrinted("ship",
                     CHeader(ExportModelOf(fitted, "ship.json"), target).text,
                     "const double nu[6] = {2, 0, 0, 0, 0, 0}; double tau[6]; int i;\n"
                     "ship_command command = {{5, 0, 0, 0, 0, 0.3}, {0.2}, {5}, {4}};\n"
                     "ship_command_forces(nu, &command, tau);\n"
                     "for (i = 0; i < 6; ++i) printf(\"%.17g\\n\", tau[i]);\n");
  ASSERT_EQ(numbers.size(), 6u);
  const double load = 40.0 * 12.25 * std::sin(0.2);
  EXPECT_NEAR(numbers[0], 5.0 + 0.81 * 160.0 - load * std::sin(0.2), 1e-11);
  EXPECT_NEAR(numbers[1], load * std::cos(0.2), 1e-11);
  EXPECT_NEAR(numbers[5], 0.3 - 2.0 * load * std::cos(0.2), 1e-11);
  for (const int i : {2, 3, 4}) EXPECT_EQ(numbers[static_cast<std::size_t>(i)], 0.0);
}

// 0.4 s of each of 20 commands, ahead and astern, by steps of both that are the same.
void ExpectRunsAsOurOwn(const FittedCoupledModel& fitted) {
  constexpr double kStep = 0.004;
  constexpr std::size_t kNumSteps = 2000, kStepsOfACommand = 100;
  const ExportTarget target = Target();
  const std::vector<DrawnState> drawn =
      DrawnStates(fitted.model, static_cast<int>(kNumSteps / kStepsOfACommand), false);
  const auto turns = [&](std::size_t k) { return 0.2 * drawn[k].tau[1]; };
  const auto angle = [&](std::size_t k, int fin) { return 0.04 * drawn[k].tau[2 + fin]; };

  CoupledInputs inputs;
  CoupledCommand& command = inputs.command;
  command.shafts = {CommandedShaftOf(target.vehicle->shafts[0])};
  for (const Fin& fin : target.vehicle->fins) {
    CommandedFin commanded;
    commanded.name = fin.name;
    commanded.arms = ArmsOf(fin);
    commanded.behind = fin.behind;
    command.fins.push_back(commanded);
  }
  for (std::size_t step = 0; step < kNumSteps; ++step) {
    const std::size_t k = step / kStepsOfACommand;
    command.time.push_back(kStep * static_cast<double>(step));
    command.force.push_back(drawn[k].tau);
    command.shafts[0].turns.push_back(turns(k));
    for (int fin = 0; fin < 3; ++fin) command.fins[fin].angle.push_back(angle(k, fin));
  }
  CoupledOutputs outputs;
  CoupledStamps stamps;
  stamps.pose = {kStep * static_cast<double>(kNumSteps)};
  const CoupledState start = {drawn[0].nu};
  ASSERT_TRUE(RunCoupled(fitted.model, inputs, start, stamps, &outputs));
  ASSERT_EQ(outputs.num_steps, static_cast<int>(kNumSteps));

  std::string body = fmt::format("static const ship_command command[{}] = {{\n", drawn.size());
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    body += fmt::format("{{{}, {}, {{0, 0, 0}}, {{{}}}}},\n",
                        Row(drawn[k].tau),
                        Row(Eigen::Vector3d(angle(k, 0), angle(k, 1), angle(k, 2))),
                        turns(k));
  }
  body += fmt::format(
      "}};\nship_state s = {{{}, {{0, 0, 0, 1}}, {{0, 0, 0}}}};\nint i;\n"
      "for (i = 0; i < {}; ++i) ship_step(&s, &command[i / {}], {});\n"
      "for (i = 0; i < 6; ++i) printf(\"%.17g\\n\", s.nu[i]);\n"
      "for (i = 0; i < 3; ++i) printf(\"%.17g\\n\", s.position[i]);\n",
      Row(drawn[0].nu),
      kNumSteps,
      kStepsOfACommand,
      kStep);
  const std::vector<double> numbers =
      NumbersPrinted("ship", CHeader(ExportModelOf(fitted, "ship.json"), target).text, body);
  ASSERT_EQ(numbers.size(), 9u);
  const CoupledState& end = outputs.pose.front();
  EXPECT_GT(end.nu.norm(), 0.1);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(numbers[i], end.nu[static_cast<int>(i)], 1e-11);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(numbers[6 + i], end.position[static_cast<int>(i)], 1e-10);
  }
}

TEST(CCommand, RunsAsOurOwnSimulation) { ExpectRunsAsOurOwn(Ship()); }

TEST(CCommand, RunsAsOurOwnSimulationOfFinsThatStall) {
  FittedCoupledModel ship = Ship();
  ship.model.fin_stall = {{"rudder", 0.2}, {"askew", 0.1}};
  ExpectRunsAsOurOwn(ship);
}

// From 0 to an order of 0.3 rad with T = 0.5 s over 0.2 s: 0.3 (1 - exp(-0.4)) at the end, and in
// the mean 0.3 (1 - 0.5/0.2 (1 - exp(-0.4))).
TEST(CCommand, MovesFinsThatLagTowardsTheirOrders) {
  FittedCoupledModel fitted = Ship();
  fitted.model.fin_lag = {{"rudder", 0.5}};
  const std::vector<double> numbers =
      NumbersPrinted("ship",
                     CHeader(ExportModelOf(fitted, "ship.json"), Target()).text,
                     "const double order[3] = {0.1, 0.3, 0.2};\n"
                     "double angle[3] = {0}, mean[3]; int i;\n"
                     "ship_fin_angles(order, 0.2, angle, mean);\n"
                     "for (i = 0; i < 3; ++i) printf(\"%.17g %.17g\\n\", angle[i], mean[i]);\n");
  ASSERT_EQ(numbers.size(), 6u);
  EXPECT_EQ(numbers[0], 0.1);
  EXPECT_EQ(numbers[1], 0.1);
  EXPECT_NEAR(numbers[2], 0.3 * (1.0 - std::exp(-0.4)), 1e-15);
  EXPECT_NEAR(numbers[3], 0.3 * (1.0 - 2.5 * (1.0 - std::exp(-0.4))), 1e-15);
}

// From 0 to orders of 0.3 and of -0.05 rad at 0.5 rad/s over 0.2 s: the one comes to 0.1, the other
// is there after 0.1 s.
TEST(CCommand, TurnsFinsOfALimitedRateTowardsTheirOrders) {
  FittedCoupledModel fitted = Ship();
  fitted.model.fin_rate_limit = {{"rudder", 0.5}};
  const std::vector<double> numbers =
      NumbersPrinted("ship",
                     CHeader(ExportModelOf(fitted, "ship.json"), Target()).text,
                     "const double far[3] = {0.1, 0.3, 0.2}, near[3] = {0.1, -0.05, 0.2};\n"
                     "double angle[3] = {0}, mean[3];\n"
                     "ship_fin_angles(far, 0.2, angle, mean);\n"
                     "printf(\"%.17g %.17g\\n\", angle[1], mean[1]);\n"
                     "angle[1] = 0.0;\n"
                     "ship_fin_angles(near, 0.2, angle, mean);\n"
                     "printf(\"%.17g %.17g\\n\", angle[1], mean[1]);\n");
  ASSERT_EQ(numbers.size(), 4u);
  EXPECT_NEAR(numbers[0], 0.1, 1e-15);
  EXPECT_NEAR(numbers[1], 0.05, 1e-15);
  EXPECT_NEAR(numbers[2], -0.05, 1e-15);
  EXPECT_NEAR(numbers[3], -0.0375, 1e-15);
}

TEST(CCommand, AsksForTheVehicleFileThatHasTheFins) {
  const ExportModel model = ExportModelOf(Ship(), "ship.json");
  ExportTarget target = Target();
  std::erase_if(target.vehicle->fins, [](const Fin& fin) { return fin.name == "rudder"; });
  EXPECT_EQ(ErrorFrom([&] { CommandInC(model, target); }),
            "--vehicle: has no fin of that name, expected the file that says where the model's fin "
            "rudder stands.");
  target.vehicle.reset();
  EXPECT_THAT(ErrorFrom([&] { CommandInC(model, target); }), HasSubstr("--vehicle: is missing"));
}

TEST(Export, RefusesFinsAndLiftWhereTheFormatHasNoPlaceForThem) {
  const ExportModel ship = ExportModelOf(Ship(), "ship.json");
  EXPECT_EQ(ErrorFrom([&] { Export(ship, Target(), ExportFormat::kMss); }),
            "--model: has fin_force.askew, which --format=mss does not hold; expected one of c, "
            "csv.");
  EXPECT_EQ(ErrorFrom([&] { Export(ship, Target(), ExportFormat::kGazebo); }),
            "--model: has lift.sway, which --format=gazebo does not hold; expected one of c, csv, "
            "mss.");
  EXPECT_THAT(Export(ship, Target(), ExportFormat::kCsv).text,
              HasSubstr("fin_race.rudder,0.05,,,,m^2/(s^2 N),fin,"));
}

}  // namespace
}  // namespace fathom
