// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dives/named_few.h"

#include "fathom/base/listed.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {

std::string NamedFew(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> parts(names.begin(), names.begin() + std::min(names.size(), kMost));
  if (names.size() > kMost) parts.push_back(fmt::format("{} more", names.size() - kMost));
  return Listed(parts);
}

}  // namespace fathom
