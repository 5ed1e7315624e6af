// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/integration/memory_before.h"
#include "fathom/simulate/integration/water_integrator.h"

namespace fathom {

// One step of a run with both its ends, for the outputs in between. Times are on the command's
// clock.
template <typename T>
struct RunStep {
  T begin{0.0};
  T duration{0.0};
  double end = 0.0;
  double command = 0.0;        // held over the step [N] or [N m]
  T force{0.0};                // its mean, behind the thrusters
  ThrusterStates<T> thrust{};  // at the begin
  ThrusterStates<T> thrust_after{};
  RunState<T> before;
  RunState<T> after;
  RunState<T> slope;        // at the begin
  double stiff_rate = 0.0;  // of a stiff step [1/s], 0 of others
};

// A cubic from (y0, slope0) to (y1, slope1) at the share `x` of `h`.
template <typename T, typename X>
T Cubic(const T& y0, const T& slope0, const T& y1, const T& slope1, const T& h, const X& x) {
  const X x2 = x * x;
  const X x3 = x2 * x;
  return y0 + (y1 - y0) * X(3.0 * x2 - 2.0 * x3) + h * slope0 * X(x - 2.0 * x2 + x3) +
         h * slope1 * X(x3 - x2);
}

}  // namespace fathom
