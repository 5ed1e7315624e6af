// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A propeller's thrust in open water, by its advance: straight lines between points.
struct OpenWaterCurve {
  std::vector<double> advance;  // J, the first 0, strictly increasing
  std::vector<double> thrust;   // K_T, as many; the first above 0
};

// A shaft with a propeller that pushes along the vehicle's x, and whose revolutions are known.
//
//   T = rho n |n| D^4 K_T(J),   J = (1 - w) u / (n D)        docs/fins.md (2)
//
//   T    thrust of the propeller; on the vehicle acts (1 - t) T  [N]
//   n    revolutions, above 0 ahead                          [Hz]
//   D    diameter                                            [m]
//   u    speed of the vehicle along x at the propeller       [m/s]
//   w    wake fraction; t: thrust deduction
//   rho  of fresh water, 1000 kg/m^3
//
// Beyond the curve's last point its last line goes on. Where propeller and speed go against each
// other (n u < 0) K_T is that at rest, K_T(0). Astern (n < 0, u < 0) the curve is that of ahead.
//
// It fails where a propeller stalls or sucks air, and astern where its blades are made for ahead.
struct Shaft {
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // of the propeller, body frame [m]
  double diameter = 1.0;                               // D, above 0

  // Where known. Without the curve K_T is 1, and what it is in truth is the gain of the thrust.
  std::optional<OpenWaterCurve> curve;
  std::optional<double> wake;              // w, below 1; absent: 0
  std::optional<double> thrust_deduction;  // t, below 1; absent: 0, and part of the gain

  // Whether newtons follow from revolutions.
  bool IsThrustKnown() const { return curve.has_value() && thrust_deduction.has_value(); }
};

// T and its derivative by u.
struct ShaftThrust {
  double thrust = 0.0;    // [N]
  double by_speed = 0.0;  // [N s/m]
};

// Of the propeller, without the thrust deduction.
ShaftThrust ShaftThrustAt(const Shaft& shaft, double revolutions, double speed);

}  // namespace fathom
