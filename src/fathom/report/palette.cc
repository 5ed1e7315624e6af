// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/palette.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace fathom {
namespace {

constexpr std::array<std::string_view, 7> kColors = {
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};

}  // namespace

std::string_view Palette::ColorOf(const std::string& name) {
  const auto found = std::ranges::find(names_, name);
  const auto index = static_cast<std::size_t>(found - names_.begin());
  if (found == names_.end()) names_.push_back(name);
  return kColors[index % kColors.size()];
}

}  // namespace fathom
