// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace fathom {

// A factor of one column of velocity.csv: -1 turns its sign round.
struct Correction {
  std::string column;   // "p"
  double factor = 1.0;  // finite and not 0
};

}  // namespace fathom
