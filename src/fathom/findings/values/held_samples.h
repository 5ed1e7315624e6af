// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>

namespace fathom {

// A slow sensor that was written at a higher rate: each value stands in several rows.
struct HeldSamples {
  double interval = 0.0;  // from new value to new value [s]
  double row_step = 0.0;  // from row to row [s]
};

// Looks for values that mostly stay for two rows or more and then change by several of the smallest
// steps. A coarse sensor, whose value stays because the motion is slow, changes by one.
//
// `time`: stamps of the values [s], increasing.
std::optional<HeldSamples> FindHeldSamples(std::span<const double> time,
                                           std::span<const double> values);

}  // namespace fathom
