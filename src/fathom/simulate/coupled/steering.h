// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/vehicle/coupled/coupled_model.h"

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The fin that turns the vehicle most by its place; nothing if none does.
std::optional<std::size_t> RudderOf(const std::vector<CommandedFin>& fins);

// Small motions about a straight track at a steady speed, docs/fins.md (4):
//
//   M dx/dt = F x + f angle,   x = (v, r), or r alone where the model moves no sway
//
// F holds the forces of hull, fins and C(nu): Y_v, Y_r - m u, N_v, N_r - m x_G u of naval
// architects. `angle` is positive to starboard.
struct SteeringEquations {
  Eigen::MatrixXd inertia;  // M, of sway and yaw [kg], [kg m], [kg m^2]
  Eigen::MatrixXd force;    // F [kg/s], [kg m/s], [kg m^2/s]
  Eigen::VectorXd rudder;   // f [N/rad], [N m/rad]

  bool HasSway() const { return inertia.rows() == 2; }
};

// At a speed ahead [m/s], under a thrust in whose race the rudder may stand [N]. Nothing if no fin
// turns the vehicle, the model moves no yaw, or its inertia is not positive definite.
std::optional<SteeringEquations> SteeringOf(const CoupledModel& model,
                                            const std::vector<CommandedFin>& fins,
                                            double ahead,
                                            double thrust);

// What is left of them for slow rudders: T dr/dt + r = K angle. With sway, T is T_1 + T_2 - T_3 of
// the transfer function from angle to r.
//
// Nomoto et al., On the steering qualities of ships, International Shipbuilding Progress 4, 1957.
struct Nomoto {
  double K = 0.0;            // [1/s]; below 0 the vehicle does not hold a straight track
  double T = 0.0;            // [s]
  double growth_rate = 0.0;  // of the slowest motion [1/s]; above 0 it leaves the straight track
};
Nomoto NomotoOf(const SteeringEquations& equations);

}  // namespace fathom
