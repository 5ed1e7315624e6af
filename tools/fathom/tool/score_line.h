// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/fitted_model.h"

#include <string>

namespace fathom {

// How well a free run predicts one part of a log: one line, or nothing where there are no samples.
// `part`: ", held out" of a log, ", another log", or nothing.
std::string ScoreLine(const char* part, const FitFigures& figures, Dof dof);

}  // namespace fathom
