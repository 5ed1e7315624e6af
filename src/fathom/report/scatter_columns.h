// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/panel.h"

#include <cstddef>
#include <string>

namespace fathom {

// More points than this are thinned: every k-th is drawn. Means are of all of them.
inline constexpr std::size_t kMostPoints = 1500;

// That k, 1 or more.
std::size_t DrawnEvery(std::size_t num_points);

// The points that a scatter chart draws, as JSON for csv.js: a list of columns {name, values}.
std::string ScatterColumnsJson(const ScatterPanel& panel);

}  // namespace fathom
