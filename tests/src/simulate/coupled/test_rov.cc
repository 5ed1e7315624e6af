// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "test_rov.h"

#include <cmath>

#include <Eigen/Geometry>

namespace fathom {

CoupledModel Rov() {
  CoupledModel model;
  model.dofs.assign(kAllDofs.begin(), kAllDofs.end());
  model.inertia.diagonal() << 40.0, 60.0, 70.0, 2.0, 3.0, 4.0;
  model.inertia(1, 5) = model.inertia(5, 1) = 2.0;
  model.inertia(0, 4) = model.inertia(4, 0) = -1.5;
  model.linear_damping.diagonal() << 5.0, 8.0, 9.0, 0.5, 0.6, 0.8;
  model.linear_damping(1, 5) = 0.7;
  model.linear_damping(5, 1) = -0.4;
  model.quadratic_damping.diagonal() << 30.0, 60.0, 80.0, 1.0, 1.2, 1.5;
  model.offset << 0.3, -0.2, 0.0, 0.01, -0.02, 0.03;
  model.net_buoyancy = 2.0;
  model.righting_roll = 6.0;
  model.righting_pitch = 7.0;
  model.thrust_gain = {{"port", 0.8}};
  model.coriolis = true;
  return model;
}

CoupledModel RovWithEffects() {
  CoupledModel model = Rov();
  model.effects["coulomb_friction"] << 2.0, 0.0, 1.0, 0.0, 0.0, 0.3;
  model.effects["cubic_damping"] << 30.0, 0.0, 0.0, 1.0, 0.0, 0.0;
  model.effects["damping_asymmetry"] << 0.7, 0.3, 0.0, 0.0, 0.0, 0.4;
  model.effects["thrust_dead_zone"] << 2.0, 1.0, 0.0, 0.0, 0.0, 0.2;
  model.effects["thrust_asymmetry"] << 0.2, 0.0, 0.3, 0.0, 0.0, 0.1;
  return model;
}

CoupledInputs Steps(int num_steps) {
  CoupledInputs inputs;
  CoupledCommand& command = inputs.command;
  command.thrusters = {{"port", Vector6(1.0, 0.1, 0.0, 0.02, 0.0, 0.25), {}},
                       {"starboard", Vector6(1.0, -0.1, 0.05, 0.0, 0.03, -0.25), {}}};
  for (int k = 0; k < num_steps; ++k) {
    command.time.push_back(2.0 * k);
    command.thrusters[0].thrust.push_back(8.0 * std::sin(1.3 * k * k));
    command.thrusters[1].thrust.push_back(8.0 * std::cos(0.7 * k * k));
    Vector6 force = Vector6::Zero();
    force[2] = 6.0 * std::sin(0.9 * k * k);
    force[3] = 1.5 * std::sin(2.1 * k);
    command.force.push_back(force);
  }
  return inputs;
}

Vector6 ForceOf(const CoupledModel& model, const CoupledInputs& inputs, std::size_t row) {
  Vector6 tau = inputs.command.force[row];
  for (const CommandedThruster& thruster : inputs.command.thrusters) {
    const auto gain = model.thrust_gain.find(thruster.name);
    tau += (gain == model.thrust_gain.end() ? 1.0 : gain->second) * thruster.thrust[row] *
           thruster.push;
  }
  return tau;
}

CoupledState Moving() {
  CoupledState start;
  start.nu << 0.3, -0.1, 0.05, 0.1, -0.2, 0.15;
  start.attitude =
      Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, -1).normalized())).coeffs();
  start.position << 1.0, -2.0, 3.0;
  return start;
}

Fin Rudder() {
  Fin fin;
  fin.name = "rudder";
  fin.position << -0.6, 0.05, 0.02;
  fin.behind = "port";
  return fin;
}

Fin SternPlane() {
  Fin fin;
  fin.name = "plane";
  fin.position << -0.5, 0.2, 0.0;
  fin.axis = Eigen::Vector3d::UnitY();
  return fin;
}

Fin StuckPlane() {
  Fin fin;
  fin.name = "stuck";
  fin.position << -0.5, -0.25, 0.03;
  fin.axis = -Eigen::Vector3d::UnitY();
  return fin;
}

CoupledModel FinnedRov() {
  CoupledModel model = Rov();
  model.lift(1, 1) = 20.0;
  model.lift(1, 5) = -3.0;
  model.lift(5, 1) = 6.0;
  model.fin_force = {{"rudder", 30.0}, {"plane", 25.0}, {"stuck", 20.0}};
  model.fin_race = {{"rudder", 0.04}};
  model.fin_neutral = {{"rudder", 0.03}};
  model.fin_stuck = {{"stuck", 0.15}};
  return model;
}

CoupledInputs FinnedSteps(int num_steps) {
  CoupledInputs inputs = Steps(num_steps);
  CoupledCommand& command = inputs.command;
  command.fins = {{"rudder", ArmsOf(Rudder()), {}, "port"},
                  {"plane", ArmsOf(SternPlane()), {}},
                  {"stuck", ArmsOf(StuckPlane()), {}}};
  for (int k = 0; k < num_steps; ++k) {
    command.fins[0].angle.push_back(0.4 * std::sin(1.1 * k * k));
    command.fins[1].angle.push_back(0.3 * std::cos(1.7 * k));
    command.fins[2].angle.push_back(-0.2 * std::cos(1.3 * k));
  }
  return inputs;
}

Shaft Screw() {
  Shaft shaft;
  shaft.name = "screw";
  shaft.position << -0.5, 0.1, -0.05;
  shaft.diameter = 0.2;
  shaft.curve = OpenWaterCurve{{0.0, 0.5, 0.9}, {0.36, 0.2, 0.0}};
  shaft.wake = 0.3;
  shaft.thrust_deduction = 0.15;
  return shaft;
}

CoupledModel ScrewedRov() {
  CoupledModel model = FinnedRov();
  model.thrust_gain["screw"] = 0.7;
  return model;
}

CoupledInputs ScrewedSteps(int num_steps) {
  CoupledInputs inputs = FinnedSteps(num_steps);
  inputs.command.fins[0].behind = "screw";
  inputs.command.shafts = {CommandedShaftOf(Screw())};
  for (int k = 0; k < num_steps; ++k) {
    inputs.command.shafts[0].turns.push_back(k % 4 == 3 ? 0.0 : 2.0 + 4.0 * std::sin(2.3 * k));
  }
  return inputs;
}

}  // namespace fathom
