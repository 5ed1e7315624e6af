// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/negative_damping.h"

#include "fathom/vehicle/parameters.h"

#include <algorithm>

#include <fmt/format.h>

namespace fathom {
namespace {

std::string Beginning(int index) {
  return fmt::format("{} is negative", kParameterInfo[index].name);
}

}  // namespace

std::string CaveatOnNegativeDamping(int index, std::string_view value) {
  return fmt::format(
      "{} ({}), which is unphysical. The fit takes another term or an unmodelled effect for "
      "damping.",
      Beginning(index),
      value);
}

bool IsSaidToBeNegative(int index, const std::vector<std::string>& caveats) {
  return std::any_of(caveats.begin(), caveats.end(), [&](const std::string& caveat) {
    return caveat.starts_with(Beginning(index));
  });
}

}  // namespace fathom
