// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"

namespace fathom {

// Takes single wild samples out of the segments: those further from the median of their ten
// neighbours' residuals than six of the residuals' robust spreads (Hampel's identifier). A step or
// a slow structure moves the median along and stays. Returns how many were taken out.
int RemoveOutliers(const ExtendedModel& model,
                   const std::vector<InitialState>& initial,
                   std::vector<MeasuredSegment>* segments);

}  // namespace fathom
