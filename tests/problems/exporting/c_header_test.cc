// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/c_header.h"

#include "fathom/exporting/comment_text.h"
#include "fathom/simulate/coupled/coupled_simulation.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "compiled_c.h"
#include "generic_models.h"
#include "written_out_rate.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ExportTarget Target(const std::string& name) { return {name, "a test"}; }

// Prints dnu/dt at each state.
std::string BodyOfAccelerations(const std::string& name, const std::vector<DrawnState>& states) {
  std::string body = "double a[6];\nint i;\n";
  for (const DrawnState& state : states) {
    body += fmt::format(
        "{{ const {0}_state s = {{{1}, {2}, {{0, 0, 0}}}}; const double tau[6] = {3};\n"
        "{0}_acceleration(&s, tau, a); for (i = 0; i < 6; ++i) printf(\"%.17g\\n\", a[i]); }}\n",
        name,
        Row(state.nu),
        Row(state.world_from_body.coeffs()),
        Row(state.tau));
  }
  return body;
}

void ExpectAccelerationsOf(const std::string& name,
                           const CoupledModel& model,
                           const ExportModel& exported) {
  const std::vector<DrawnState> states = DrawnStates(model, 20, /*all_move=*/true);
  const std::vector<double> numbers =
      NumbersPrinted(name, CHeader(exported, Target(name)).text, BodyOfAccelerations(name, states));
  ASSERT_EQ(numbers.size(), 6 * states.size());
  for (std::size_t k = 0; k < states.size(); ++k) {
    const Vector6 truth = WrittenOutRate(model, states[k]);
    const Vector6 given = Eigen::Map<const Vector6>(&numbers[6 * k]);
    EXPECT_LT((given - truth).norm(), 1e-12 * truth.norm()) << given.transpose();
  }
}

TEST(CHeader, AcceleratesAsTheEquationsOfSixDofs) {
  const FittedCoupledModel fitted = GenericRov();
  ExpectAccelerationsOf("rov", fitted.model, ExportModelOf(fitted, "rov.json"));
}

// Roll, pitch and heave move as the caller says, and enter C(nu).
TEST(CHeader, AcceleratesAsTheEquationsOfABoat) {
  const FittedCoupledModel fitted = GenericBoat();
  ExpectAccelerationsOf("boat", fitted.model, ExportModelOf(fitted, "boat.json"));
}

TEST(CHeader, AcceleratesWithEffectsAsTheirEquations) {
  const FittedCoupledModel fitted = GenericBoatWithEffects();
  ExpectAccelerationsOf("boat", fitted.model, ExportModelOf(fitted, "boat.json"));
}

// Beyond a dead zone of 2.5 N, and 0.7 of that astern.
TEST(CHeader, LosesThrustToTheEffectsOfACoupledModel) {
  const FittedCoupledModel fitted = GenericBoatWithEffects();
  const std::vector<double> numbers = NumbersPrinted(
      "boat",
      CHeader(ExportModelOf(fitted, "boat.json"), Target("boat")).text,
      "const double ahead[6] = {1, 6, 0, 0, 0, 0}, astern[6] = {1, -6, 0, 0, 0, 0};\n"
      "double tau[6];\n"
      "boat_thrusters thrusters = {{0}};\n"
      "boat_thrust(ahead, 0.1, &thrusters, tau);\nprintf(\"%.17g %.17g\\n\", tau[0], tau[1]);\n"
      "boat_thrust(astern, 0.1, &thrusters, tau);\nprintf(\"%.17g\\n\", tau[1]);\n");
  ASSERT_EQ(numbers.size(), 3u);
  EXPECT_DOUBLE_EQ(numbers[0], 1.0);
  EXPECT_DOUBLE_EQ(numbers[1], 3.5);
  EXPECT_DOUBLE_EQ(numbers[2], -2.45);
}

TEST(CHeader, AcceleratesAsModelsOfOneDofEach) {
  const FittedModel heave = GenericOneDof(Dof::kHeave), yaw = GenericOneDof(Dof::kYaw);
  CoupledModel truth;
  truth.dofs = {Dof::kHeave, Dof::kYaw};
  truth.inertia(2, 2) = heave.model.inertia;
  truth.inertia(5, 5) = yaw.model.inertia;
  truth.linear_damping(2, 2) = heave.model.linear_damping;
  truth.linear_damping(5, 5) = yaw.model.linear_damping;
  truth.quadratic_damping(2, 2) = heave.model.quadratic_damping;
  truth.quadratic_damping(5, 5) = yaw.model.quadratic_damping;
  truth.net_buoyancy = heave.model.buoyancy;
  truth.offset(5) = yaw.model.buoyancy;
  ExpectAccelerationsOf("two", truth, ExportModelOf({yaw, heave}, {"yaw.json", "heave.json"}));
}

// A second of each of 20 forces, by steps of both that are the same.
TEST(CHeader, RunsAsOurOwnSimulation) {
  constexpr double kStep = 0.02;
  constexpr int kNumSteps = 1000, kStepsOfAForce = 50;
  const FittedCoupledModel fitted = GenericRov();
  const std::vector<DrawnState> drawn = DrawnStates(fitted.model, kNumSteps / kStepsOfAForce, true);
  const DrawnState& start = drawn.front();

  CoupledInputs inputs;
  for (int k = 0; k < kNumSteps; ++k) {
    inputs.command.time.push_back(kStep * k);
    inputs.command.force.push_back(drawn[static_cast<std::size_t>(k / kStepsOfAForce)].tau);
  }
  CoupledOutputs outputs;
  CoupledStamps stamps;
  stamps.pose = {kStep * kNumSteps};
  ASSERT_TRUE(RunCoupled(fitted.model,
                         inputs,
                         {start.nu, start.world_from_body.coeffs(), Eigen::Vector3d(1, -2, 3)},
                         stamps,
                         &outputs));
  ASSERT_EQ(outputs.num_steps, kNumSteps);

  std::string body = fmt::format("static const double tau[{}][6] = {{\n", drawn.size());
  for (const DrawnState& state : drawn) body += Row(state.tau) + ",\n";
  body += fmt::format(
      "}};\nrov_state s = {{{}, {}, {{1, -2, 3}}}};\nint i;\n"
      "for (i = 0; i < {}; ++i) rov_step(&s, tau[i / {}], {});\n"
      "for (i = 0; i < 6; ++i) printf(\"%.17g\\n\", s.nu[i]);\n"
      "for (i = 0; i < 4; ++i) printf(\"%.17g\\n\", s.attitude[i]);\n"
      "for (i = 0; i < 3; ++i) printf(\"%.17g\\n\", s.position[i]);\n",
      Row(start.nu),
      Row(start.world_from_body.coeffs()),
      kNumSteps,
      kStepsOfAForce,
      kStep);
  const std::vector<double> numbers =
      NumbersPrinted("rov", CHeader(ExportModelOf(fitted, "rov.json"), Target("rov")).text, body);
  ASSERT_EQ(numbers.size(), 13u);
  // A thousand steps of rounding, 1e-16 each, some a hundred times as large in the end.
  const CoupledState& end = outputs.pose.front();
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(numbers[static_cast<std::size_t>(i)], end.nu[i], 1e-11);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(numbers[static_cast<std::size_t>(6 + i)], end.attitude[i], 1e-11);
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(numbers[static_cast<std::size_t>(10 + i)], end.position[i], 1e-10);
  }
}

// m dv/dt + d v + b = F from rest: v = (F - b)/d (1 - exp(-t d/m)), and its integral.
TEST(CHeader, ComesToSpeedAsTheClosedForm) {
  FittedModel fitted = GenericOneDof(Dof::kSurge);
  fitted.model = {23.0, 0.0, 4.5, 0.7};
  const std::vector<double> numbers =
      NumbersPrinted("surge",
                     CHeader(ExportModelOf({fitted}, {"surge.json"}), Target("surge")).text,
                     "surge_state s = {{0, 0, 0, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, 0}};\n"
                     "const double tau[6] = {3.1, 0, 0, 0, 0, 0};\n"
                     "int i;\n"
                     "for (i = 0; i < 200; ++i) surge_step(&s, tau, 0.05);\n"
                     "printf(\"%.17g %.17g\\n\", s.nu[0], s.position[0]);\n");
  ASSERT_EQ(numbers.size(), 2u);
  const double m = 23.0, d = 4.5, t = 10.0, top = (3.1 - 0.7) / d;
  // The scheme: (0.05 d/m)^4 / 120 of what is left to come, over 2 time constants: 2e-10.
  EXPECT_NEAR(numbers[0], top * (1.0 - std::exp(-t * d / m)), 1e-9);
  EXPECT_NEAR(numbers[1], top * (t - m / d * (1.0 - std::exp(-t * d / m))), 1e-8);
}

// Port pushes ahead at y = -0.45 m: 0.8 x 10 N and 0.45 m x 8 N = 3.6 N m; starboard down at
// x = 0.3 m: 5 N and a pitch of -0.3 x 5 = -1.5 N m.
TEST(CHeader, AllocatesTheThrustsOfTheVehicle) {
  ExportTarget target = Target("rov");
  target.vehicle.emplace();
  target.vehicle->thrusters = {{"port", {-0.4, -0.45, 0.0}, {1.0, 0.0, 0.0}},
                               {"down */ tube", {0.3, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
  const ExportedFile file = CHeader(ExportModelOf(GenericRov(), "rov.json"), target);
  EXPECT_TRUE(file.remarks.empty());
  const std::vector<double> numbers =
      NumbersPrinted("rov",
                     file.text,
                     "const double thrust[2] = {10, 5}; double tau[6]; int i;\n"
                     "rov_forces(thrust, tau);\n"
                     "for (i = 0; i < 6; ++i) printf(\"%.17g\\n\", tau[i]);\n");
  ASSERT_EQ(numbers.size(), 6u);
  const std::vector<double> truth = {8.0, 0.0, 5.0, 0.0, -1.5, 3.6};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(numbers[i], truth[i], 1e-14);
}

// 1600 us is half way from 0 to 1700 us, 14 V half way from 12 V to 16 V: a half of 15 N. 1300 us
// is half of the full command back.
TEST(CHeader, ReadsThrustsOfPulsesFromTheTables) {
  ExportTarget target = Target("rov");
  target.vehicle.emplace();
  target.vehicle->thrust_tables = {
      {"width", "us", {12.0, 16.0}, {1500.0, 1700.0}, {{0.0, 0.0}, {12.0, 18.0}}},
      {"of none", "us", {12.0}, {1500.0, 1700.0}, {{0.0}, {12.0}}},
      {"a */ share", "1", {14.0}, {-1.0, 1.0}, {{-17.0}, {17.0}}}};
  target.vehicle->thrusters = {{"one", {0, 0, 0}, {1, 0, 0}, 0, 0, "a */ share"},
                               {"two", {0, 0, 0}, {0, 1, 0}, 0, 0, "width"}};
  const std::string text = CHeader(ExportModelOf(GenericBoat(), "boat.json"), target).text;
  EXPECT_THAT(text, Not(HasSubstr("of none")));
  EXPECT_EQ(NumbersPrinted("rov",
                           text,
                           "printf(\"%.17g %.17g %.17g %.17g %.17g %.17g %d\\n\",\n"
                           "rov_thrust_of_pulse(1, 1600, 14), rov_thrust_of_pulse(1, 2000, 18),\n"
                           "rov_thrust_of_pulse(1, 1600, 9), rov_thrust_of_pulse(0, 1300, 12),\n"
                           "rov_thrust_of_pulse(0, 0, 12), rov_thrust_of_pulse(0, 1, 20),\n"
                           "rov_num_thrusters);\n"),
            (std::vector<double>{7.5, 18.0, 6.0, -8.5, 0.0, -17.0, 2.0}));
}

TEST(CHeader, WritesNoThrustsOfPulsesWhereAThrusterHasNoTable) {
  ExportTarget target = Target("rov");
  target.vehicle.emplace();
  target.vehicle->thrust_tables = {{"width", "us", {12.0}, {1500.0, 1700.0}, {{0.0}, {12.0}}}};
  target.vehicle->thrusters = {{"one", {0, 0, 0}, {1, 0, 0}, 0, 0, "width"},
                               {"two", {0, 0, 0}, {0, 1, 0}, 0.1, 0.1}};
  const std::string text = CHeader(ExportModelOf(GenericBoat(), "boat.json"), target).text;
  EXPECT_THAT(text, HasSubstr("rov_forces"));
  EXPECT_THAT(text, Not(HasSubstr("_of_pulse")));
}

TEST(CHeader, SaysOfEachNumberWhereItIsFrom) {
  const std::string text = CHeader(ExportModelOf(GenericRov(), "rov.json"), Target("rov")).text;
  // 40 give or take 1.96 x 0.1.
  EXPECT_THAT(text,
              HasSubstr("#define ROV_INERTIA_SURGE 40.0 /* kg, 95 % interval 39.8 to 40.2, log "
                        "tank_07 */\n"));
  EXPECT_THAT(text,
              HasSubstr("#define ROV_INERTIA_SURGE_PITCH (-1.5) /* kg m, 95 % interval -1.696 to "
                        "-1.304, log tank_07 */\n"));
  EXPECT_THAT(text, HasSubstr("ROV_THRUST_GAIN_1 0.8 /* thruster port, 1, interval not known"));
  EXPECT_THAT(text, HasSubstr("From rov.json: log tank_07, version 0.1.0\n"));
}

TEST(CHeader, SaysWhichGainItHasNoThrusterFor) {
  const ExportedFile file = CHeader(ExportModelOf(GenericRov(), "rov.json"), Target("rov"));
  ASSERT_EQ(file.remarks.size(), 1u);
  EXPECT_THAT(file.remarks[0],
              HasSubstr("thrust_gain.port of 0.8 is left out: multiply its thrust by it"));
  EXPECT_THAT(file.text, HasSubstr("Note: " + file.remarks[0]));
  EXPECT_THAT(file.text, Not(HasSubstr("rov_forces")));
}

}  // namespace
}  // namespace fathom
