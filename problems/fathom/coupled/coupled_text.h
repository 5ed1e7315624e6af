// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_identification.h"
#include "fathom/report/table.h"

#include <string>
#include <vector>

namespace fathom {

// The identified numbers with their intervals.
Table CoupledEntryTable(const FittedCoupledModel& fitted);

// Inertia and damping as matrices, rows and columns by DOF; only those that hold more than 0.
std::vector<Table> CoupledMatrixTables(const FittedCoupledModel& fitted);

// How near free runs are, a row for each DOF.
Table CoupledFigureTable(const FittedCoupledModel& fitted);

// What was tried, a row for each rung; errors are of data that were not fitted.
Table LadderTable(const Ladder& ladder, const std::vector<Dof>& dofs);

// The structures that were not fitted, and why; empty of none.
std::string NotFittedSentence(const Ladder& ladder);

// What the data show beyond a diagonal model, in a sentence or several.
std::string LadderSentence(const Ladder& ladder);

// All of it for a terminal.
std::string FormatCoupledIdentification(const CoupledIdentification& identified);

}  // namespace fathom
