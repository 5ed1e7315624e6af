// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/structure_comparison.h"
#include "fathom/report/page.h"

namespace fathom {

// The models as a table, and their free runs over each DOF's measured motion. Its origin is left
// open.
Page StructurePage(const StructureComparison& comparison);

}  // namespace fathom
