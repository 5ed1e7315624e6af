// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace fathom {

// An effect at certain values, and what it adds to the outputs. An effect of several amounts (the
// two of `periodic_force`) has a column for each.
struct Trial {
  int suspect = 0;             // index
  std::vector<double> values;  // all the effect's parameters; amounts at their probes
  std::vector<int> amounts;    // which parameter each column probes
  bool any_sign = false;       // true: the amount may as well be negative
  int first_column = 0;
  int num_columns = 1;
};

}  // namespace fathom
