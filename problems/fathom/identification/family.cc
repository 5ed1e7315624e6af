// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/family.h"

#include "fathom/base/input_error.h"

#include <span>

namespace fathom {

std::string_view Name(Family family) {
  constexpr std::array<std::string_view, 4> kNames = {
      "least_squares", "adaptive", "output_error", "joint"};
  return kNames[static_cast<size_t>(family)];
}

namespace {

Family ParseAmong(std::span<const Family> families, const std::string& name) {
  std::string names;
  for (const Family family : families) {
    if (Name(family) == name) return family;
    names += names.empty() ? "" : ", ";
    names += Name(family);
  }
  throw InputError("is '" + name + "', expected one of " + names + ".");
}

}  // namespace

Family ParseFamily(const std::string& name) { return ParseAmong(kAllFamilies, name); }

Family ParseSignalFamily(const std::string& name) { return ParseAmong(kSignalFamilies, name); }

}  // namespace fathom
