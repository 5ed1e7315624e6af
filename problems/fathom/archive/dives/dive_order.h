// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A dive and when it began.
struct DiveStart {
  std::string name;
  double start = std::numeric_limits<double>::quiet_NaN();  // [s since 1970]; NaN: not known
};

// Whether name `a` comes before `b`, where numbers in them count as numbers: "dive 9" before
// "dive 10".
bool ComesBefore(std::string_view a, std::string_view b);

// The names in their order: by start where every dive has one, else by name.
std::vector<std::string> InOrder(std::vector<DiveStart> dives);

}  // namespace fathom
