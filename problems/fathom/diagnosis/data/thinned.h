// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"

#include <vector>

namespace fathom {

// The segments at about 10 Hz: commands and samples that come faster are averaged over a tenth of a
// second, so that a search among many models costs what it must. A vehicle answers the mean of a
// command over so short a time as it answers the command; docs/diagnosis.md (2).
std::vector<MeasuredSegment> Thinned(const std::vector<MeasuredSegment>& segments);

}  // namespace fathom
