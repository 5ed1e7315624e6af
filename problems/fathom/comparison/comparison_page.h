// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/comparison.h"
#include "fathom/report/page.h"
#include "fathom/report/table.h"

#include <string>
#include <vector>

namespace fathom {

// The paper's Table II for one DOF, with 95 % intervals' standard deviations and held-out figures.
// The usable row with the least error on unseen data (or, where none is held out, on the training
// data) is flagged best.
Table ParameterTable(const DofComparison& comparison);

// What is to be said beside that table, a line each: what its mark means, notes on the data, why a
// row is unusable, and what the usable ones do not cover.
std::vector<std::string> CommentsOn(const DofComparison& comparison);

// All of it on one page.
Page ComparisonPage(const Comparison& comparison);

}  // namespace fathom
