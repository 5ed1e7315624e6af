// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Synthesize() of a vehicle whose DOFs act on each other.

#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/simulate/coupled/coupled_prediction.h"
#include "fathom/synthesize/experiment/experiment_file.h"
#include "fathom/synthesize/synthesize.h"
#include "fathom/synthesize/truth_file.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "error_from.h"
#include "plain_simulator.h"
#include <Eigen/Geometry>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// No number of it is 0 or 1 where it acts, and all axes couple.
Vehicle CoupledRov() {
  return ParseVehicleFile(
      "rov.yaml",
      "name: rov\n"
      "mass: 22\n"
      "rigid_body:\n"
      "  inertia_tensor: [[0.9, 0.05, 0.02], [0.05, 1.4, -0.04], [0.02, -0.04, 1.7]]\n"
      "  centre_of_mass: [0.02, -0.01, 0.05]\n"
      "thrusters:\n"
      "  - {name: port, position: [-0.2, -0.25, 0.05], direction: [1, 0, 0]}\n"
      "  - {name: starboard, position: [-0.2, 0.3, 0.05], direction: [1, 0, 0]}\n"
      "  - {name: lift, position: [0.1, 0.02, 0], direction: [0, 0, 1]}\n"
      "fins:\n"
      "  - {name: rudder, position: [-0.6, 0, 0.1], axis: [0, 0, 1]}\n"
      "coupled_model:\n"
      "  added_mass:\n"
      "    - [7, 0.5, -1.2, 0.3, 0.8, -0.2]\n"
      "    - [0.5, 15, 0.6, -1.1, 0.2, 0.9]\n"
      "    - [-1.2, 0.6, 21, 0.2, -1.3, 0.1]\n"
      "    - [0.3, -1.1, 0.2, 0.5, 0.05, -0.03]\n"
      "    - [0.8, 0.2, -1.3, 0.05, 0.7, 0.02]\n"
      "    - [-0.2, 0.9, 0.1, -0.03, 0.02, 0.6]\n"
      "  linear_damping:\n"
      "    - [6, 0, 0.4, 0, 0.3, 0]\n"
      "    - [0, 9, 0, -0.5, 0, 0.7]\n"
      "    - [0.2, 0, 11, 0, 0.4, 0]\n"
      "    - [0, -0.3, 0, 1.5, 0, 0.1]\n"
      "    - [0.1, 0, 0.6, 0, 1.8, 0]\n"
      "    - [0, 0.5, 0, 0.2, 0, 2.1]\n"
      "  quadratic_damping: [24, 37, 45, 2.5, 2.7, 3.1]\n"
      "  net_buoyancy: 3.5\n"
      "  righting_moment: {roll: 11, pitch: 10}\n"
      "  offset: [0.4, -0.3, 0.2, 0.03, -0.02, 0.05]\n"
      "  thrust_gain: {starboard: 0.6}\n"
      "  fin_force: {rudder: 7}\n");
}

Experiment OfLines(const std::string& lines) {
  return ParseExperiment("e.yaml",
                         "name: run\nduration: 20\ncommand_rate: 5\nvelocity: {rate: 10}\n"
                         "pose: {rate: 4}\n" +
                             lines);
}

std::string StepsOn(const std::string& dof, double amplitude) {
  return dof + ": {control: open_loop, input: {kind: random_steps, amplitude: " +
         std::to_string(amplitude) + ", hold: [0.6, 2]}}\n";
}

Experiment OnAllAxes() {
  return OfLines(StepsOn("surge", 40.0) + StepsOn("sway", 45.0) + StepsOn("heave", 50.0) +
                 StepsOn("roll", 5.0) + StepsOn("pitch", 5.0) + StepsOn("yaw", 6.0));
}

// The rudder's force by the law of docs/fins.md (1), written for a fin that stands upright at the
// stern: by the velocity of its place, normal to its plane.
Vector6 RudderForce(const Vector6& nu, double angle) {
  const Eigen::Vector3d place(-0.6, 0.0, 0.1);
  const Eigen::Vector3d at_fin = nu.head<3>() + nu.tail<3>().cross(place);
  const double inflow = std::atan2(at_fin[1], at_fin[0]);
  const double size = 7.0 * (at_fin[0] * at_fin[0] + at_fin[1] * at_fin[1]);
  const double normal = size * std::sin(angle - inflow);
  const Eigen::Vector3d force = normal * Eigen::Vector3d(-std::sin(angle), std::cos(angle), 0.0);
  Vector6 all;
  all << force, place.cross(force);
  return all;
}

// Runs the textbook's equations over a log's command and compares: velocities at every second row
// of the command's grid, poses at their own.
void ExpectTheTextbooksMotion(const Log& log,
                              const Vehicle& vehicle,
                              bool by_thrusters,
                              const Eigen::Vector3d& current = Eigen::Vector3d::Zero()) {
  PlainSimulator plain(*vehicle.coupled);
  plain.current = current;
  double angle = 0.0;
  plain.more = [&](const Vector6& nu) { return RudderForce(nu, angle); };
  const double grid = 0.05;  // of which all three rates are multiples
  const auto forces = by_thrusters ? *log.thrusters : *log.command;
  for (int k = 0; k < 400; ++k) {
    const double t = k * grid;
    const auto command_row = static_cast<std::size_t>(k / 4);
    if (k % 2 == 0) {
      const auto row = static_cast<std::size_t>(k / 2);
      ASSERT_NEAR(log.velocity->time[row], t, 1e-9);
      for (std::size_t i = 0; i < 6; ++i) {
        // The steps of the simulation leave 1e-5 of a speed of about 1.
        ASSERT_NEAR(log.velocity->values[i][row], plain.nu[static_cast<int>(i)], 5e-5)
            << "column " << i << " at " << t;
      }
    }
    if (k % 5 == 0) {
      const auto row = static_cast<std::size_t>(k / 5);
      ASSERT_NEAR(log.pose->time[row], t, 1e-9);
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(
            log.pose->values[static_cast<std::size_t>(axis)][row], plain.position[axis], 2e-4);
      }
      const auto& q = log.pose->values;
      const Eigen::Quaterniond attitude(q[6][row], q[3][row], q[4][row], q[5][row]);
      ASSERT_NEAR((attitude.toRotationMatrix() - plain.world_from_body).norm(), 0.0, 3e-4);
    }
    Vector6 tau = Vector6::Zero();
    if (by_thrusters) {
      const double port = forces.values[0][command_row];
      const double starboard = 0.6 * forces.values[1][command_row];
      const double lift = forces.values[2][command_row];
      const auto push =
          [&](double thrust, const Eigen::Vector3d& at, const Eigen::Vector3d& along) {
            tau.head<3>() += thrust * along;
            tau.tail<3>() += thrust * at.cross(along);
          };
      push(port, {-0.2, -0.25, 0.05}, Eigen::Vector3d::UnitX());
      push(starboard, {-0.2, 0.3, 0.05}, Eigen::Vector3d::UnitX());
      push(lift, {0.1, 0.02, 0.0}, Eigen::Vector3d::UnitZ());
    } else {
      for (int i = 0; i < 6; ++i) tau[i] = forces.values[static_cast<std::size_t>(i)][command_row];
    }
    angle = log.fins->values[0][command_row];
    plain.Advance(tau, grid, 0.0005);
  }
}

TEST(CoupledSynthesis, MovesAsTheTextbookSaysUnderForcesOnAllAxes) {
  const Vehicle vehicle = CoupledRov();
  const Log log = Synthesize(vehicle, OnAllAxes(), 7);
  EXPECT_EQ(log.dofs.size(), 6u);
  EXPECT_EQ(log.command->columns.size(), 6u);
  EXPECT_THAT(log.velocity->columns, ElementsAre("u", "v", "w", "p", "q", "r"));
  ASSERT_EQ(log.velocity->time.size(), 200u);
  ASSERT_EQ(log.pose->time.size(), 80u);
  ExpectTheTextbooksMotion(log, vehicle, false);
}

TEST(CoupledSynthesis, MovesAsTheTextbookSaysInACurrent) {
  const Vehicle vehicle = CoupledRov();
  Experiment experiment = OnAllAxes();
  experiment.current << 0.2, -0.15;
  ExpectTheTextbooksMotion(Synthesize(vehicle, experiment, 7), vehicle, false, {0.2, -0.15, 0.0});
}

TEST(CoupledSynthesis, MovesAsTheTextbookSaysUnderThrustersAndAFin) {
  const Vehicle vehicle = CoupledRov();
  const Log log = Synthesize(
      vehicle,
      OfLines("thrusters:\n"
              "  port: {kind: random_steps, amplitude: 30, hold: [1, 3], offset: 15}\n"
              "  starboard: {kind: random_steps, amplitude: 30, hold: [1, 3], offset: 25}\n"
              "  lift: {kind: random_steps, amplitude: 20, hold: [1, 3]}\n"
              "fins: {rudder: {kind: random_steps, amplitude: 0.4, hold: [1, 3]}}\n"),
      4);
  EXPECT_THAT(log.thrusters->columns, ElementsAre("thruster_1", "thruster_2", "thruster_3"));
  EXPECT_EQ(log.thruster_unit, "N");
  EXPECT_THAT(log.fins->columns, ElementsAre("fin_rudder"));
  ExpectTheTextbooksMotion(log, vehicle, true);
}

// Surge alone: 60 du/dt = 0.9 rho D^4 n^2 (0.36 - 0.4 J) - 20 u, by small steps.
TEST(CoupledSynthesis, IsDrivenByAShaft) {
  const Vehicle vehicle = ParseVehicleFile(
      "boat.yaml",
      "name: boat\n"
      "shafts:\n"
      "  - {name: screw, position: [-1, 0, 0], diameter: 0.2, thrust: {linear: [0.36, -0.4]},\n"
      "     wake: 0.2, thrust_deduction: 0.1}\n"
      "coupled_model:\n  dofs: [surge]\n  inertia: [60, 1, 1, 1, 1, 1]\n"
      "  linear_damping: [20, 0, 0, 0, 0, 0]\n");
  const Log log = Synthesize(
      vehicle, OfLines("shafts: {screw: {kind: steps, levels: [4, 9, 6], hold: 5}}\n"), 2);
  EXPECT_FALSE(log.command);
  EXPECT_FALSE(log.fins);
  ASSERT_THAT(log.shafts->columns, ElementsAre("shaft_screw"));
  double u = 0.0, t = 0.0;
  for (std::size_t k = 0; k < log.velocity->time.size(); ++k) {
    for (; t < log.velocity->time[k] - 1e-9; t += 1e-3) {
      std::size_t row = 0;
      while (row + 1 < log.shafts->time.size() && log.shafts->time[row + 1] <= t + 1e-9) ++row;
      const double n = log.shafts->values[0][row];
      const auto rate = [&](double v) {
        const double J = 0.8 * v / (n * 0.2);
        return (0.9 * 1000.0 * 0.0016 * n * n * (0.36 - 0.4 * J) - 20.0 * v) / 60.0;
      };
      u += 1e-3 * rate(u + 0.5e-3 * rate(u));
    }
    EXPECT_NEAR(log.velocity->values[0][k], u, 1e-6) << t;
  }
}

// The reader of logs and the prediction of models take it as it is.
TEST(CoupledSynthesis, MakesALogThatItsOwnModelPredicts) {
  const Vehicle vehicle = CoupledRov();
  Experiment experiment = OnAllAxes();
  experiment.velocity->noise.fill(0.01);
  experiment.pose->position_noise = 0.01;
  experiment.pose->angle_noise = 0.005;
  const Log log = Synthesize(vehicle, experiment, 3);
  const std::vector<CoupledData> logs = {
      CoupledDataOf(log, vehicle.coupled->dofs, vehicle.thrusters, vehicle.fins)};
  const auto prediction = PredictCoupled(*vehicle.coupled, logs, 5.0);
  ASSERT_TRUE(prediction);
  for (const FitFigures& figures : prediction->figures) {
    // Runs begin at states that are measured, off by more than the noise where a step is near.
    EXPECT_LT(figures.nmae, 0.12);
  }
}

TEST(CoupledSynthesis, GivesTheSameLogForTheSameSeedAndNoStreamDependsOnAnother) {
  const Vehicle vehicle = CoupledRov();
  Experiment experiment = OnAllAxes();
  experiment.velocity->noise.fill(0.01);
  experiment.velocity->sampling.jitter = 0.01;
  const Log log = Synthesize(vehicle, experiment, 3);
  EXPECT_EQ(Synthesize(vehicle, experiment, 3).velocity->values, log.velocity->values);
  EXPECT_NE(Synthesize(vehicle, experiment, 4).command->values, log.command->values);
  experiment.pose.reset();
  EXPECT_EQ(Synthesize(vehicle, experiment, 3).velocity->values, log.velocity->values);
}

TEST(CoupledSynthesis, MeasuresTheDofsThatTheExperimentNames) {
  Experiment experiment = OfLines(StepsOn("surge", 40.0) + StepsOn("yaw", 4.0));
  EXPECT_EQ(Synthesize(CoupledRov(), experiment, 1).velocity->columns.size(), 6u);
  experiment.velocity->dofs = {Dof::kSurge, Dof::kYaw};
  const Log log = Synthesize(CoupledRov(), experiment, 1);
  EXPECT_THAT(log.velocity->columns, ElementsAre("u", "r"));
  EXPECT_THAT(log.command->columns, ElementsAre("tau_surge", "tau_yaw"));
}

TEST(CoupledSynthesis, HoldsDepthAndHeadingWhileItMovesAhead) {
  const Experiment experiment = OfLines(
      "surge: {control: open_loop, input: {kind: steps, levels: [20], hold: 20}}\n"
      "heave: {control: closed_loop, setpoint: {kind: steps, levels: [1.5], hold: 20},\n"
      "        pid: {kp: 60, ki: 6, kd: 70, limit: 100}}\n"
      "yaw: {control: closed_loop, setpoint: {kind: steps, levels: [3.5], hold: 20},\n"
      "      pid: {kp: 12, ki: 1, kd: 10, limit: 15}}\n");
  const Log log = Synthesize(CoupledRov(), experiment, 1);
  EXPECT_NEAR(log.pose->values[2].back(), 1.5, 0.1);
  // Beyond half a turn: the heading counts on, the quaternion does not.
  const auto& q = log.pose->values;
  const Eigen::Quaterniond attitude(q[6].back(), q[3].back(), q[4].back(), q[5].back());
  const Eigen::Matrix3d r = attitude.toRotationMatrix();
  EXPECT_NEAR(std::remainder(std::atan2(r(1, 0), r(0, 0)) - 3.5, 2.0 * M_PI), 0.0, 0.1);
  EXPECT_GT(std::hypot(log.pose->values[0].back(), log.pose->values[1].back()), 3.0);
}

TEST(CoupledSynthesis, ShowsACameraTheSamePlaces) {
  const Vehicle vehicle = CoupledRov();
  const Log log = Synthesize(vehicle, OnAllAxes(), 7);
  Sampling camera;
  camera.rate = 4.0;
  const Stream shown = ShownPoses(vehicle, OnAllAxes(), {}, 7, camera);
  EXPECT_EQ(shown.time, log.pose->time);
  EXPECT_EQ(shown.values, log.pose->values);
}

TEST(CoupledSynthesis, TellsItsTruthByTheNamesOfAFit) {
  const std::string truth = FormatTruth(CoupledRov(), OnAllAxes(), {}, 7);
  EXPECT_THAT(truth, HasSubstr("\"inertia.sway.roll\""));
  EXPECT_THAT(truth, HasSubstr("\"thrust_gain.starboard\""));
  EXPECT_THAT(truth, HasSubstr("\"kg m^2\""));
}

// Matrices hold the whole body, also the axes that are held.
TEST(CoupledSynthesis, TellsNoNumberOfTheTruthThatNoModelledDofFeels) {
  Vehicle rov = CoupledRov();
  rov.coupled->dofs = {Dof::kSurge, Dof::kPitch};
  const std::string truth = FormatTruth(rov, OnAllAxes(), {}, 7);
  EXPECT_THAT(truth, HasSubstr("\"inertia.surge.pitch\""));
  EXPECT_THAT(truth, HasSubstr("\"linear_damping.surge\""));
  for (const char* other : {"\"inertia.sway\"",
                            "\"inertia.surge.sway\"",
                            "\"linear_damping.yaw\"",
                            "\"linear_damping.surge.heave\""}) {
    EXPECT_THAT(truth, Not(HasSubstr(other)));
  }
}

std::string ErrorOf(const Vehicle& vehicle, const std::string& lines) {
  return ErrorFrom([&] { Synthesize(vehicle, OfLines(lines), 1); });
}

TEST(CoupledSynthesis, RefusesWhatTheVehicleCannotDo) {
  Vehicle vehicle = CoupledRov();
  const std::string rudder = "fins: {rudder: {kind: sine, amplitude: 0.2, frequency: 1}}\n";
  EXPECT_EQ(ErrorOf(vehicle, "thrusters: {bow: {kind: steps, levels: [1], hold: 1}}\n"),
            "experiment 'run': drives the thruster 'bow', which vehicle 'rov' does not have, "
            "expected a name of its `thrusters`.");
  EXPECT_THAT(ErrorOf(vehicle, "fins: {sail: {kind: sine, amplitude: 0.2, frequency: 1}}\n"),
              HasSubstr("drives the fin 'sail', which vehicle 'rov' does not have"));
  EXPECT_THAT(ErrorOf(vehicle,
                      "sway: {control: closed_loop, setpoint: {kind: steps, levels: [1], hold: 1},"
                      " pid: {kp: 1, limit: 2}}\n"),
              HasSubstr("sway is in closed loop, but the vehicle turns"));
  EXPECT_THAT(ErrorOf(vehicle,
                      "sway: {control: open_loop, input: {kind: steps, levels: [1], hold: 1},"
                      " turbulence: {force: 1, correlation_time: 2}}\n"),
              HasSubstr("sway has turbulence, expected none"));
  vehicle.coupled->dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  EXPECT_THAT(ErrorOf(vehicle, StepsOn("heave", 3.0)),
              HasSubstr("drives heave, which the coupled model of vehicle 'rov' does not move"));
  Experiment experiment = OfLines(StepsOn("surge", 3.0));
  experiment.velocity->dofs = {Dof::kRoll};
  EXPECT_THAT(ErrorFrom([&] { Synthesize(vehicle, experiment, 1); }),
              HasSubstr("measures roll, which the coupled model of vehicle 'rov' does not move"));
  vehicle.coupled.reset();
  EXPECT_THAT(ErrorOf(vehicle, rudder), HasSubstr("vehicle 'rov': has no coupled_model"));
}

TEST(CoupledSynthesis, RefusesToTurnAFinFartherThanItGoes) {
  Vehicle vehicle = CoupledRov();
  const auto with_steps_to = [](const std::string& angle) {
    return "fins: {rudder: {kind: steps, levels: [0.1, " + angle + "], hold: 1}}\n";
  };
  EXPECT_EQ(ErrorOf(vehicle, with_steps_to("-0.31")), "no error");
  vehicle.fins[0].largest_angle = 0.3;
  EXPECT_EQ(ErrorOf(vehicle, with_steps_to("-0.3")), "no error");
  EXPECT_EQ(ErrorOf(vehicle, with_steps_to("-0.31")),
            "experiment 'run': turns the fin 'rudder' to -0.31 rad, expected at most 0.3 rad to "
            "either side, its `largest_angle` in the file of vehicle 'rov'.");
}

TEST(CoupledSynthesis, RefusesAMotionThatLeavesTheFiniteNumbers) {
  EXPECT_THAT(ErrorOf(CoupledRov(), StepsOn("surge", 9e8)),
              HasSubstr("vehicle 'rov': its speed leaves the finite numbers"));
}

}  // namespace
}  // namespace fathom
