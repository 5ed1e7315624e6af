// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/report/table.h"
#include "fathom/vehicle/fitted_model.h"

#include <limits>
#include <span>
#include <string>

namespace fathom {

// The offset (buoyancy) of one of several logs that each have their own.
struct LogOffset {
  std::string log;                                          // its name
  double value = std::numeric_limits<double>::quiet_NaN();  // [N] or [N m]
  double std = std::numeric_limits<double>::quiet_NaN();    // of the fit
  FitFigures train;  // of the model with this offset over the log's training data
};

// A row each.
Table OffsetTable(std::span<const LogOffset> offsets, Dof dof, const std::string& force_unit);

// How far they scatter, a sentence. Empty for fewer than two.
std::string RemarkOnOffsets(std::span<const LogOffset> offsets, const std::string& force_unit);

}  // namespace fathom
