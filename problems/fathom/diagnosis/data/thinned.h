// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"

#include <vector>

namespace fathom {

// A vehicle answers the mean of a command over so short a time as it answers the command [s].
inline constexpr double kFineWidth = 0.1;

// The segments with commands and samples that come faster averaged over `width` [s], so that a
// search among many models costs what it must. Beyond kFineWidth runs are integrated as coarsely.
std::vector<MeasuredSegment> Thinned(const std::vector<MeasuredSegment>& segments, double width);

}  // namespace fathom
