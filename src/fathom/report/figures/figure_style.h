// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/format_value.h"

#include <string>
#include <string_view>

namespace fathom {

// What all plots of gnuplot share: no box, a pale grid, grey numbers.
inline constexpr std::string_view kFigureStyle = R"(
set border 3 lc rgb '#9aa3af' lw 0.7
set grid lc rgb '#e2e6ec' lw 0.6 lt 1
set tics nomirror out scale 0.5 textcolor rgb '#5d6776'
)";

}  // namespace fathom
