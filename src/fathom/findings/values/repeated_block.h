// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace fathom {

// Rows that occur twice.
struct RepeatedBlock {
  std::size_t first = 0;   // where the block begins
  std::size_t second = 0;  // where it begins again
  std::size_t num_rows = 0;
};

// The longest block of at least 100 values, half of them different from each other, that comes
// again later to the last digit, in a column with noise, in which no two stretches are the same, or
// with a jump where it begins or ends again. A simulation without noise repeats itself as its
// command does.
std::optional<RepeatedBlock> FindRepeatedBlock(std::span<const double> values);

}  // namespace fathom
