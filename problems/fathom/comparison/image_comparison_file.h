// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/image_comparison.h"

#include <string>

namespace fathom {

// The text of a comparison file ("fathom-comparison-1") with the account of the joint refinement
// under "joint"; docs/file_formats.md.
std::string FormatImageComparison(const ImageComparison& comparison);

}  // namespace fathom
