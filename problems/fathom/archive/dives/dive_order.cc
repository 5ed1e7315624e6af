// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dives/dive_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// The number at the begin of `text`, which is taken off, without the zeros before it.
std::string_view TakeDigits(std::string_view* text) {
  std::size_t length = 0;
  while (length < text->size() && IsDigit((*text)[length])) ++length;
  std::string_view digits = text->substr(0, length);
  text->remove_prefix(length);
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return digits;
}

}  // namespace

bool ComesBefore(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (IsDigit(a.front()) && IsDigit(b.front())) {
      const std::string_view x = TakeDigits(&a), y = TakeDigits(&b);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      continue;
    }
    if (a.front() != b.front()) {
      return static_cast<unsigned char>(a.front()) < static_cast<unsigned char>(b.front());
    }
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;
}

std::vector<std::string> InOrder(std::vector<DiveStart> dives) {
  const bool all_have_starts = std::all_of(
      dives.begin(), dives.end(), [](const DiveStart& dive) { return std::isfinite(dive.start); });
  std::sort(dives.begin(), dives.end(), [&](const DiveStart& a, const DiveStart& b) {
    if (all_have_starts && a.start != b.start) return a.start < b.start;
    return ComesBefore(a.name, b.name);
  });
  std::vector<std::string> names;
  for (DiveStart& dive : dives) names.push_back(std::move(dive.name));
  return names;
}

}  // namespace fathom
