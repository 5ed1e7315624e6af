// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/structure_comparison.h"
#include "fathom/report/table.h"

#include <string>
#include <vector>

namespace fathom {

// "full", "auto: coriolis", "one DOF each, output error".
std::string ModelName(const StructureRow& row);

// A row for each model, with its errors over data that were not fitted, against the best models of
// one DOF each. What was taken is flagged kept.
Table UnseenTable(const StructureComparison& comparison);

// The same rows with their errors over the data of the fit, and over what is held out, if anything.
Table FittedTable(const StructureComparison& comparison);

// Which structure is taken, whether it beats models of one DOF each, and which others beat it.
std::string StructureSentence(const StructureComparison& comparison);

// Why rows are not usable, and remarks on the logs, a line each.
std::vector<std::string> CommentsOn(const StructureComparison& comparison);

}  // namespace fathom
