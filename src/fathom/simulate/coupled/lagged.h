// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

namespace fathom {

// A value that follows its command as a first-order lag does,
//
//   lag dx/dt + x = target,
//
// while the target holds; with its derivative by the lag. T: double, or a vector of Eigen.
template <typename T>
struct Lagged {
  T target;        // what the command asks for
  T begun;         // x where the target began to hold
  T begun_by_lag;  // its derivative [1/s]

  // After `t` s of this target. A lag of 0 s follows at once.
  T At(double t, double lag) const {
    if (lag <= 0.0) return target;
    return target + std::exp(-t / lag) * (begun - target);
  }

  // By the lag [1/s], which is above 0.
  T ByLag(double t, double lag) const {
    return std::exp(-t / lag) * (begun_by_lag + t / (lag * lag) * (begun - target));
  }

  // By the time [1/s]; lag above 0.
  T Rate(double t, double lag) const { return std::exp(-t / lag) / lag * (target - begun); }

  // Another target from here on, `t` s after this one.
  void Retarget(const T& next, double t, double lag) {
    if (lag > 0.0) {
      const T by_lag = ByLag(t, lag);
      begun = At(t, lag);
      begun_by_lag = by_lag;
    }
    target = next;
  }
};

}  // namespace fathom
