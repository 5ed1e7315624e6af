// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

// Rows first ... last, all of one value, with another value before and after them.
struct EqualRun {
  std::size_t first = 0;
  std::size_t last = 0;

  std::size_t NumRows() const { return last - first + 1; }
};

// A column cut into such runs, in their order.
std::vector<EqualRun> EqualRunsOf(std::span<const double> values);

}  // namespace fathom
