// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/family.h"

#include "fathom/base/input_error.h"

namespace fathom {

std::string_view Name(Family family) {
  constexpr std::array<std::string_view, 4> kNames = {
      "least_squares", "adaptive", "output_error", "joint"};
  return kNames[static_cast<size_t>(family)];
}

Family ParseFamily(const std::string& name) {
  for (const Family family : kAllFamilies) {
    if (Name(family) == name) return family;
  }
  throw InputError("is '" + name + "', expected one of least_squares, adaptive, output_error.");
}

}  // namespace fathom
