// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/structure_comparison.h"

#include <string>

namespace fathom {

// JSON of the schema "fathom-structures-1", docs/file_formats.md. Numbers that are not known are
// null.
std::string FormatStructures(const StructureComparison& comparison);

}  // namespace fathom
