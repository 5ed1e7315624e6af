// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace fathom {

// A number that stands for "no reading".
struct Sentinel {
  double value = 0.0;
  std::size_t num_rows = 0;
  std::size_t first = 0;  // the first of these rows
};

// Looks for the value furthest from the middle one where it stands alone, far from all others, and
// is one that sensors and their drivers are known to write (32767 and 32768 or 65535 with the point
// anywhere, 99..., 1e6 and above), or stands in several rows.
std::optional<Sentinel> FindSentinel(std::span<const double> values);

}  // namespace fathom
