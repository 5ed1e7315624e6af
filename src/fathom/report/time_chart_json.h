// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/palette.h"
#include "fathom/report/panel.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fathom {

// More stamps than this are thinned (thinning.h).
inline constexpr std::size_t kMostStamps = 20000;

// Throws away nothing, but refuses (CHECK) a panel whose series differ in length from its stamps or
// whose stamps decrease.
void CheckPanel(const TimePanel& panel);

// Measured minus response, stamp by stamp.
std::vector<double> Residual(const Series& measured, const Series& response);

// What page.js draws from, as JSON. Values keep seven digits. Stamps that count from an epoch
// (beyond 1e6 s) lose a whole number of seconds, `time_offset`, so that the axis can be read.
std::string TimeChartJson(const TimePanel& panel, Palette& palette);

}  // namespace fathom
