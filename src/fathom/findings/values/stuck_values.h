// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/values/equal_runs.h"

#include <optional>
#include <span>

namespace fathom {

// A sensor that stood still.
struct StuckValues {
  std::size_t num_rows = 0;
  EqualRun longest;
};

// Looks for one value over at least a second that
//
// - the values before or after it are far from, by the usual step from row to row; or that
// - lasts five seconds, is not 0, and stands in a column that otherwise changes in every row.
//
// Nothing of that is a value in which the column comes to rest by ever smaller steps.
//
// `time`: stamps of the values [s], increasing.
std::optional<StuckValues> FindStuckValues(std::span<const double> time,
                                           std::span<const double> values);

}  // namespace fathom
