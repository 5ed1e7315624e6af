// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace fathom {

// Rows that hold exactly 0 while the vehicle moves: no reading, written as a number.
struct LostValues {
  std::size_t num_rows = 0;
  std::size_t first = 0;  // the first of these rows
};

// Looks for zeros between values that are far from 0, by the usual step from row to row. Nothing if
// they are too few to matter: fewer than three rows.
std::optional<LostValues> FindLostValues(std::span<const double> values);

}  // namespace fathom
