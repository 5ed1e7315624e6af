// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

namespace fathom {

// One DOF's command as logged: value[i] holds from time[i] until time[i + 1], the last one for
// ever.
struct HeldCommand {
  std::vector<double> time;   // [s], strictly increasing
  std::vector<double> value;  // [N] or [N m]

  // The value that holds at `t`. Before the first stamp nothing was commanded: 0.
  double At(double t) const;

  // The values that hold at these stamps, which must not fall.
  std::vector<double> At(std::span<const double> stamps) const;

  // What acts from `from` to `to`: the stamp whose value holds at `from`, and those up to `to`.
  HeldCommand Between(double from, double to) const;
};

}  // namespace fathom
