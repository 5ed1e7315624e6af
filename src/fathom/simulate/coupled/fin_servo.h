// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/lagged.h"
#include "fathom/simulate/coupled/slewed.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <cmath>
#include <limits>

namespace fathom {

// How the angle of a fin follows its command: at once, with a lag, or no faster than a rate.
struct FinServo {
  double lag = 0.0;                                       // [s]; 0 beside a rate
  double rate = std::numeric_limits<double>::infinity();  // [rad/s]

  Lagged<double> lagged = {0.0, 0.0, 0.0};  // of a servo without a limited rate
  Slewed slewed = {};                       // of one with it

  bool IsLimited() const { return rate > 0.0 && std::isfinite(rate); }
  bool IsAtOnce() const { return lag <= 0.0 && !IsLimited(); }

  // After `t` s of a command, not beyond the arrival of a limited one [rad].
  double At(double t) const { return IsLimited() ? slewed.At(t, rate) : lagged.At(t, lag); }

  // By the time [rad/s], of one that is not at once.
  double Speed(double t) const { return IsLimited() ? slewed.Speed(rate) : lagged.Rate(t, lag); }

  // By a number of this fin, of one that is not at once.
  double By(FreeEntry::Kind kind, double t) const {
    if (kind == FreeEntry::Kind::kFinRateLimit && IsLimited()) return slewed.ByRate(t);
    if (kind == FreeEntry::Kind::kFinLag && !IsLimited()) return lagged.ByLag(t, lag);
    return 0.0;
  }

  // Another command from here on, `t` s after this one.
  void Retarget(double angle, double t) {
    if (IsLimited()) {
      slewed.Retarget(angle, t, rate);
    } else {
      lagged.Retarget(angle, t, lag);
    }
  }
};

}  // namespace fathom
