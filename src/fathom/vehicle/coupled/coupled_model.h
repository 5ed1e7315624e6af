// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/coupled/six_vector.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// Several degrees of freedom of a vehicle, in still water or a steady current.
//
//   M dnu/dt + C(nu) nu + D(nu) nu + g(eta) + o = B(kappa) T + F(nu, angles)   docs/coupled.md (1)
//
//   nu   velocities, body frame                               [m/s], [rad/s]
//   M    `inertia`: rigid body plus added mass, symmetric     [kg], [kg m], [kg m^2]
//   C    Coriolis and centripetal forces of M, if `coriolis`  coriolis.h
//   D    D_L + D_Q |nu|: the force along i is
//        sum_j (D_L,ij + D_Q,ij |nu_j| + L_ij u) nu_j
//   g    net buoyancy and righting moments, by the body's down in the world: coupled.md (4)
//        and `effects` of the water: friction, a drag that grows faster or differs astern
//   o    `offset`: what a thrust that is off, or a trim, adds [N], [N m]
//   T    thrusts [N] (B: the allocation, kappa: the gains), or the six forces, turned by
//        `thrust_angle`, behind their command by `thruster_lag`; of shafts by nu; what `effects`
//        and `thruster_effects` of the thrust leave of them
//   F    forces of the fins, each by its `fin_force`            fin_force.h
//
// Rows and columns by Index(Dof). Rows of DOFs outside `dofs` are no equations; a column there
// tells what a measured partner does. Entries that are not known are 0.
//
// In a current nu is the velocity through the water; that over ground has the current beside it.
//
// It fails in waves, near walls, and where thrust depends on the inflow but for that
// of shafts, shaft.h.
struct CoupledModel {
  std::vector<Dof> dofs;  // those that it moves, in the order of Dof, each once

  Matrix6 inertia = Matrix6::Zero();
  Matrix6 linear_damping = Matrix6::Zero();     // D_L [kg/s], [kg m/s], [kg m^2/s]
  Matrix6 quadratic_damping = Matrix6::Zero();  // D_Q [kg/m], [kg], [kg m], [kg m^2]
  Matrix6 lift = Matrix6::Zero();               // L [kg/m], [kg], [kg m]: grows with u
  Vector6 offset = Vector6::Zero();             // o

  double net_buoyancy = 0.0;    // buoyancy less weight [N]; above 0 the vehicle floats up
  double righting_roll = 0.0;   // moment at sin(phi) = 1, theta = 0 [N m]; above 0 it rights itself
  double righting_pitch = 0.0;  // moment at sin(theta) = 1 [N m]

  // How far the forces of wrench and thrusters are turned about z, against the axes of the
  // velocity [rad]; above 0 to starboard. A compass or an IMU that stands askew does the same.
  double thrust_angle = 0.0;

  // How late wrench, thrusters, fins and shafts take their command [s]; below 0: early.
  double time_offset = 0.0;

  // Time constant with which the forces of wrench and thrusters follow it [s]; at least 0.
  double thruster_lag = 0.0;

  std::map<std::string, double> thrust_gain = {};  // kappa by thruster or shaft; absent: 1
  std::map<std::string, double> fin_force = {};    // f by fin [N s^2/m^2 a radian]; absent: 0
  std::map<std::string, double> fin_race = {};     // k by fin [m^2/(s^2 N)]; absent: 0
  std::map<std::string, double> fin_neutral = {};  // angle at which it is straight [rad]; absent: 0
  std::map<std::string, double> fin_stuck = {};    // angle of a fin that no command turns [rad]
  std::map<std::string, double> fin_lag = {};      // time constant of a fin's angle [s]; absent: 0

  // How fast the angle of a fin without a lag follows its command at most [rad/s], above 0; absent:
  // at once.
  std::map<std::string, double> fin_rate_limit = {};

  // The angle of attack from which a fin's lift grows no more [rad], above 0 and below pi/2;
  // absent: it grows on.
  std::map<std::string, double> fin_stall = {};

  // Effects along one DOF, coupled_effects.h: the number of each by its name and Index(Dof), 0
  // where it is not there. Those of the thrust are of the forces that are commanded along the DOF.
  std::map<std::string, Vector6> effects = {};

  // Those of the thrust of every thruster, alike, by name.
  std::map<std::string, double> thruster_effects = {};

  // The steady current of a run by the name of its log: along x (north) and y (east) of the world
  // [m/s]; absent: 0.
  std::map<std::string, Eigen::Vector2d> current = {};

  // What a run adds to `offset`, by the name of its log [N], [N m]; absent: 0.
  std::map<std::string, Vector6> run_offset = {};

  bool coriolis = false;
};

// A fin that has both a lag and a limited rate, which a model does not hold; nothing if none has.
std::optional<std::string> FinWithLagAndRateLimit(const CoupledModel& model);

// True if the part of `matrix` that these DOFs share is positive definite. Of a model's inertia, or
// of that less what the rigid body has of it.
bool IsPositiveDefinite(const Matrix6& matrix, const std::vector<Dof>& dofs);

// True if the damping of the modelled DOFs takes energy at every velocity, as far as that can be
// told entry by entry: the symmetric part of D_L is positive semidefinite, and no diagonal entry of
// D_Q is below 0. Off-diagonal entries of D_Q are not looked at.
bool IsPassive(const CoupledModel& model);

}  // namespace fathom
