// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace fathom {

// What puts one column of velocity.csv right.
struct Correction {
  std::string column;   // "p"
  double factor = 1.0;  // finite and not 0; -1 turns its sign round
  double late = 0.0;    // by how long its values come too late [s]; below 0: too early
};

}  // namespace fathom
