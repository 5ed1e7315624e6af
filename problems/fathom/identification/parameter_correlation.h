// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/table.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>
#include <string>

namespace fathom {

// Two parameters of a larger correlation are hardly told apart.
inline constexpr double kHardlyToldApart = 0.95;

// The correlation of each two of the four parameters, a row and a column each, the lower triangle.
// Nothing where the covariance does not hold them.
std::optional<Table> CorrelationTable(const FittedModel& fitted);

// A sentence on those of more than kHardlyToldApart in size, or that there are none; empty without
// a table.
std::string CorrelationSentence(const FittedModel& fitted);

}  // namespace fathom
