// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/image_comparison.h"
#include "fathom/report/page.h"
#include "fathom/report/table.h"

namespace fathom {

// Value and 95 % interval of each parameter by each family.
Table IntervalTable(const ImageComparison& comparison);

// What the joint refinement found beside the model: corner error, wander and response of the held
// coordinates, and what was asked for of clock, size and mount.
Table RefinementTable(const ImageComparison& comparison);

// The page of the comparison with these tables, and the path before and after.
Page ImageComparisonPage(const MarkerLogs& logs, const ImageComparison& comparison);

}  // namespace fathom
