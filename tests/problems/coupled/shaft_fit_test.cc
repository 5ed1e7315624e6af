// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/block_fit.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "drawn_vehicle.h"
#include "plain_simulator.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kHelmForce = 30.0;  // f [N s^2/m^2 a radian]
constexpr double kHelmRace = 0.02;   // k [m^2/(s^2 N)]

Shaft DrivingShaft() {
  Shaft shaft;
  shaft.name = "screw";
  shaft.position << -0.7, 0.0, 0.0;
  shaft.diameter = 0.2;
  shaft.curve = OpenWaterCurve{{0.0, 0.9}, {0.36, 0.0}};
  shaft.wake = 0.2;
  shaft.thrust_deduction = 0.1;
  return shaft;
}

// docs/fins.md (2), of the propeller.
double ThrustByHand(double n, double u) {
  const double J = 0.8 * u / (n * 0.2);
  return 1000.0 * n * n * 0.0016 * (0.36 - 0.4 * J);
}

FinArms HelmArms() {
  Fin fin;
  fin.position << -0.8, 0.0, 0.0;
  return ArmsOf(fin);
}

// 150 s at 10 Hz with white noise of 0.003, driven by revolutions alone and a rudder in the race,
// by another integrator than Fathom's and the laws by hand.
CoupledLogs DrawnShaftLog(const CoupledModel& model, double gain, std::mt19937* random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(*random);
  };
  std::normal_distribution<double> noise(0.0, 0.003);
  CoupledData data;
  data.log = "shaft";
  data.dofs = model.dofs;
  data.force_unit = "N";
  data.has_velocity[0] = data.has_velocity[1] = data.has_velocity[5] = true;
  CoupledCommand& command = data.inputs.command;
  command.fins = {{"rudder", HelmArms(), {}, "screw"}};
  command.shafts = {CommandedShaftOf(DrivingShaft())};
  CoupledSegment segment;
  PlainSimulator plain(model);
  plain.nu[0] = 0.8;
  double turns = 0.0, angle = 0.0, next_change = 0.0;
  plain.more = [&](const Vector6& nu) -> Vector6 {
    const double thrust = ThrustByHand(turns, nu[0]);
    const double w = nu[1] - 0.8 * nu[5];
    const double s = std::sqrt(nu[0] * nu[0] + kHelmRace * std::max(thrust, 0.0));
    const double load = kHelmForce * (s * s + w * w) * std::sin(angle - std::atan2(w, s));
    Vector6 force = Vector6::Zero();
    force[0] = gain * 0.9 * thrust - load * std::sin(angle);
    force[1] = load * std::cos(angle);
    force[5] = -0.8 * load * std::cos(angle);
    return force;
  };
  for (int k = 0; k <= 1500; ++k) {
    const double t = 0.1 * k;
    Vector6 measured = plain.nu;
    for (const Dof dof : model.dofs) measured[Index(dof)] += noise(*random);
    segment.time.push_back(t);
    segment.velocity.push_back(measured);
    if (t >= next_change - 1e-9) {
      turns = between(4.0, 10.0);
      angle = between(-0.4, 0.4);
      command.time.push_back(t);
      command.shafts[0].turns.push_back(turns);
      command.fins[0].angle.push_back(angle);
      next_change = t + std::round(10.0 * between(2.0, 6.0)) / 10.0;
    }
    plain.Advance(Vector6::Zero(), 0.1, 0.005);
  }
  data.segments.push_back(segment);
  CoupledLogs logs;
  logs.data = {data};
  return logs;
}

CoupledModel ShaftDrivenVehicle(std::mt19937* random) {
  CoupledModel model = DrawnPlanarVehicle(random);
  model.offset.setZero();
  return model;
}

void ExpectWithinFour(const CoupledSummary& fit, const CoupledModel& truth) {
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  for (std::size_t k = 0; k < fit.entries.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    const double std = std::sqrt(fit.covariance(at, at));
    EXPECT_NEAR(ValueIn(fit.model, fit.entries[k]), ValueIn(truth, fit.entries[k]), 4.0 * std)
        << NameOf(fit.entries[k]);
  }
}

// Newtons come from the shaft alone.
TEST(FitCoupled, FindsAVehicleThatAShaftDrives) {
  std::mt19937 random(7);
  CoupledModel truth = ShaftDrivenVehicle(&random);
  truth.fin_race = {{"rudder", kHelmRace}};
  truth.fin_force = {{"rudder", kHelmForce}};
  const CoupledLogs logs = DrawnShaftLog(truth, 1.0, &random);
  MotionStructure structure =
      StructureOf(StandardStructure::kCoriolis, truth.dofs, {{"rudder", false, true}});
  structure.entries.push_back(FinRaceEntry("rudder"));
  const CoupledSummary fit = FitBlocks(logs, structure, {});
  ExpectWithinFour(fit, truth);
  const auto& entries = fit.entries;
  const auto inertia =
      std::find(entries.begin(), entries.end(), InertiaEntry(Dof::kSurge, Dof::kSurge));
  const auto at = inertia - entries.begin();
  EXPECT_LT(std::sqrt(fit.covariance(at, at)), 0.1 * truth.inertia(0, 0));
}

// Newtons come from the rudder; the shaft gives 0.6 of what its file says.
TEST(FitCoupled, FindsTheGainOfAShaft) {
  std::mt19937 random(9);
  CoupledModel truth = ShaftDrivenVehicle(&random);
  truth.thrust_gain = {{"screw", 0.6}};
  truth.fin_race = {{"rudder", kHelmRace}};
  truth.fin_force = {{"rudder", kHelmForce}};
  const CoupledLogs logs = DrawnShaftLog(truth, 0.6, &random);
  CoupledFitOptions options;
  options.held.fin_force = truth.fin_force;
  options.held.fin_race = truth.fin_race;
  const MotionStructure structure =
      StructureOf(StandardStructure::kCoriolis, truth.dofs, {{"rudder", true, false}}, {"screw"});
  const CoupledSummary fit = FitBlocks(logs, structure, options);
  ExpectWithinFour(fit, truth);
  EXPECT_NEAR(ValueIn(fit.model, ThrustGainEntry("screw")), 0.6, 0.1);
}

}  // namespace
}  // namespace fathom
