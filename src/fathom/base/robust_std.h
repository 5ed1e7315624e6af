// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace fathom {

// The standard deviation of errors of mean zero from their sizes |e|, at least one: 1.4826 times
// the median, as it is of normal ones. A few that are far off do not matter.
double RobustStd(std::vector<double> sizes);

}  // namespace fathom
