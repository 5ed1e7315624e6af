// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// Gains of a controller of one position; units for a DOF along which it moves (about which it
// turns).
struct PidGains {
  double kp = 0.0;     // [N/m] ([N m/rad]), above 0
  double ki = 0.0;     // [N/(m s)] ([N m/(rad s)]), at least 0
  double kd = 0.0;     // [N s/m] ([N m s/rad]), at least 0
  double limit = 0.0;  // largest force, either sign [N] ([N m]), above 0
};

// A PID controller that is called every `period` seconds.
//
//   tau = kp e + ki I + kd de/dt,   |tau| <= limit            docs/synthesize.md (7)
//
//   e      setpoint less measured position                    [m] or [rad]
//   I      integral of e up to now, by the trapezoidal rule   [m s] or [rad s]
//   de/dt  slope from the last call to this one; 0 at first   [m/s] or [rad/s]
//
// The integral stands still while the force is at its limit and e would drive it further.
class Pid {
 public:
  Pid(const PidGains& gains, double period);

  double Force(double setpoint, double position);

 private:
  PidGains gains_;
  double period_;
  double integral_ = 0.0;
  double last_error_ = 0.0;
  bool is_first_ = true;
};

}  // namespace fathom
