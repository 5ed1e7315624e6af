// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/robust_std.h"

#include "fathom/base/median.h"

#include <utility>

namespace fathom {

double RobustStd(std::vector<double> sizes) { return 1.4826 * Median(std::move(sizes)); }

}  // namespace fathom
