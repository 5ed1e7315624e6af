// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// From `from` up to, not including, `to` [s].
struct TimeInterval {
  double from = 0.0;
  double to = 0.0;

  bool Contains(double t) const { return from <= t && t < to; }
};

}  // namespace fathom
