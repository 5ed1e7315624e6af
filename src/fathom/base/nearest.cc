// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/nearest.h"

#include <algorithm>
#include <cstddef>

namespace fathom {
namespace {

// Letters to change, add, drop or swap with their neighbour until `a` is `b` (optimal string
// alignment: no part is changed twice).
std::size_t LettersBetween(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

}  // namespace

std::string Nearest(std::string_view text, const std::vector<std::string>& candidates) {
  const std::size_t most = std::max<std::size_t>(1, text.size() / 3);
  std::string nearest;
  std::size_t fewest = most + 1;
  for (const std::string& candidate : candidates) {
    std::size_t letters = most + 1;
    if (text.size() >= 2 && candidate.starts_with(text)) {
      letters = 1;
    } else if (text.size() <= candidate.size() + most && candidate.size() <= text.size() + most) {
      letters = LettersBetween(text, candidate);
    }
    // A text of one letter is near to every other one.
    if (letters < fewest && letters < text.size()) {
      fewest = letters;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace fathom
