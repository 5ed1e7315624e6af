// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// What the columns of the tables mean that need a word: a line each of those whose heading stands
// in `tables`, the printed text; empty where there are none.
std::string LegendOf(std::string_view tables);

}  // namespace fathom
