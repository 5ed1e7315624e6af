// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/six_vector.h"
#include "fathom/vehicle/coupled/stalled_sine.h"
#include "fathom/vehicle/fin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace fathom {

// What a fin does to a vehicle, docs/fins.md (1): a force normal to its plane, by the water's speed
// V there and the angle between fin and water.
//
//   F_N = f V^2 sin(angle - atan2(w, s)) = f V (s sin(angle) - w cos(angle)),   V^2 = s^2 + w^2
//   s   = u, or in a propeller's race sqrt(u^2 + k T)
//
//   f     `fin_force`                                          [N s^2/m^2 a radian]
//   u, w  the fin's own velocity along x and across            [m/s]
//   k     `fin_race`; 8 / (pi rho D^2) behind a disc of the diameter D  [m^2/(s^2 N)]
//   T     the propeller's thrust ahead, at least 0             [N]
//
// From an angle of attack, `fin_stall`, on the sine grows no more: stalled_sine.h. It fails deep in
// stall, without one beyond stall, and in the race while the vehicle moves astern.

// Generalised forces of 1 N at the fin. Times nu they are the fin's own velocity.
struct FinArms {
  Vector6 along = Vector6::Zero();   // along x
  Vector6 across = Vector6::Zero();  // along AcrossFin()
};

inline FinArms ArmsOf(const Fin& fin) {
  const auto arm = [&](const Eigen::Vector3d& direction) {
    Vector6 force;
    force << direction, fin.position.cross(direction);
    return force;
  };
  return {arm(Eigen::Vector3d::UnitX()), arm(AcrossFin(fin))};
}

// F_N and where it acts, for f = 1, with their derivatives.
struct FinLoad {
  double load = 0.0;
  Vector6 load_by_nu = Vector6::Zero();
  double load_by_angle = 0.0;
  double load_by_race = 0.0;  // by k T
  double load_by_stall = 0.0;
  Vector6 push = Vector6::Zero();  // generalised force of a load of 1
  Vector6 push_by_angle = Vector6::Zero();

  Vector6 Force() const { return load * push; }
  Vector6 ForceByAngle() const { return load_by_angle * push + load * push_by_angle; }
};

// `race`: k T [m^2/s^2]; 0 outside of one. `stall`: the angle of attack [rad] at which it stalls,
// below pi/2; infinite, or beyond: it does not.
inline FinLoad FinLoadAt(const FinArms& arms,
                         const Vector6& nu,
                         double angle,
                         double race = 0.0,
                         double stall = std::numeric_limits<double>::infinity()) {
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const double u = arms.along.dot(nu), w = arms.across.dot(nu);
  const bool is_in_race = race != 0.0;
  const double ahead = is_in_race ? std::sqrt(std::max(u * u + race, 1e-9)) : u;
  const double ahead_by_u = is_in_race ? u / ahead : 1.0;
  const double speed = std::hypot(ahead, w), turned = ahead * sine - w * cosine;
  FinLoad at;
  at.load = speed * turned;
  double by_speed = turned, by_turned = speed;
  if (stall < 0.5 * std::numbers::pi && speed > 0.0) {
    const StalledSine kept = StalledSineOf(turned / speed, std::sin(stall));
    at.load = speed * speed * kept.value;
    at.load_by_stall = speed * speed * kept.by_limit * std::cos(stall);
    by_speed = 2.0 * speed * kept.value - kept.by_sine * turned;
    by_turned = kept.by_sine * speed;
  }
  const double by_ahead = speed > 0.0 ? ahead / speed * by_speed + by_turned * sine : 0.0;
  const double by_w = speed > 0.0 ? w / speed * by_speed - by_turned * cosine : 0.0;
  at.load_by_angle = by_turned * (ahead * cosine + w * sine);
  at.load_by_nu = by_ahead * ahead_by_u * arms.along + by_w * arms.across;
  at.load_by_race = 0.5 * by_ahead / (is_in_race || u == 0.0 ? std::max(ahead, 1e-6) : std::abs(u));
  at.push = cosine * arms.across - sine * arms.along;
  at.push_by_angle = -sine * arms.across - cosine * arms.along;
  return at;
}

}  // namespace fathom
