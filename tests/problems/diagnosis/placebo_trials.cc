// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// How often a column that cannot be a cause is named: placebo_trials [count, 200 by default].
// Exit 1 if any is.

#include <cstdio>
#include <cstdlib>

#include "placebo.h"

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 200;
  int num_named = 0, num_alternatives = 0, num_offered = 0;
  for (int seed = 0; seed < count; ++seed) {
    const fathom::PlaceboResult result = fathom::TryPlacebo(seed);
    num_offered += result.is_offered;
    num_named += result.is_named;
    num_alternatives += result.is_alternative && !result.is_named;
    if (result.is_alternative) std::printf("trial %d: %s\n", seed, result.text.c_str());
  }
  std::printf("%d trials, placebos offered in %d: named in %d, said to be no worse in %d more\n",
              count,
              num_offered,
              num_named,
              num_alternatives);
  return num_named == 0 && num_offered == count ? 0 : 1;
}
