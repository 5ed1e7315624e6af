// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/findings/finding.h"
#include "fathom/vehicle/fitted_model.h"

#include <array>
#include <optional>

namespace fathom {

// What logs hold, and so what may be in a wrong unit beside the motion itself.
struct LoggedQuantities {
  bool force = false;           // in command.csv
  bool thruster_speed = false;  // in its place
  bool velocity = false;        // velocity.csv, not poses alone
};

// What is known of a vehicle's body, and what the logs hold that it is held against.
struct Body {
  double mass = 0.0;                               // dry [kg], above 0
  std::optional<std::array<double, 3>> size = {};  // length, width, height [m], above 0
  LoggedQuantities logged = {};
};

// The most inertia [kg] that a body may have along surge, sway or heave.
//
//   max(5 m, 2 (m + rho pi/4 a^2 b))                                       docs/findings.md (5)
//
//   m     dry mass                                                         [kg]
//   a, b  shorter and longer side of the face across the motion            [m]
//   rho   1000                                                             [kg/m^3]
//
// rho pi/4 a^2 b is the added mass of a plate a b at most (DNV-RP-H103, Table A-2: times 0.58 for a
// square, 1 for a long one). A box pushes up to 1.5 times that (there, a cube), and frames hold
// water that no one weighs: hence the 2. Without a size, five masses.
double MostInertia(Dof dof, const Body& body);

// The most that is usual: three masses, or with a size m + rho pi/4 a^2 b where that is more. What
// lies between that and MostInertia() is no mistake by itself.
double UsualInertia(Dof dof, const Body& body);

// An inertia against the body of the vehicle: a warning of code "inertia" if its 95 % interval lies
// below the dry mass, or above MostInertia(). A vehicle cannot move with less than its mass, and
// the water that a body takes along adds once or twice that. The sentence names the mistakes that
// would explain it: units of what the logs hold, and the mass itself.
//
// A moment of inertia, where the size is known: a warning if it lies below a tenth of m (a^2 + b^2)
// / 12, a box of even density, or above 30 times that. No vehicle has its mass within a third of
// its reach, and degrees read as radians make the moment 57 times too small.
std::optional<Finding> CheckInertia(Dof dof, double inertia, double std, const Body& body);

// The same of a model; nothing where the body is not known, or the force is not in newton: the
// inertia is then not in kg.
std::optional<Finding> CheckInertia(const FittedModel& model, const std::optional<Body>& body);

}  // namespace fathom
