// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

namespace fathom {

// Which samples of a residual are single wild ones: those further from the median of their ten
// neighbours and their own than six of the residual's robust spreads (Hampel's identifier). A step
// or a slow structure moves the median along and is not wild. `variance`: of each sample's noise
// over the usual; empty: all alike. Of fewer than eleven samples none is wild.
//
// F. R. Hampel, The influence curve and its role in robust estimation, JASA 69, 1974.
std::vector<bool> WildSamples(std::span<const double> residual,
                              std::span<const double> variance = {});

}  // namespace fathom
