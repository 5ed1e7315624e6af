// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/comparison.h"

#include <string>

namespace fathom {

// The text of a comparison file, schema "fathom-comparison-1"; docs/file_formats.md.
std::string FormatComparison(const Comparison& comparison);

}  // namespace fathom
