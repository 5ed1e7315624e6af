// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom::hidden {

struct Interval {
  double low = 0.0;
  double high = 1.0;
};

// Chance of at most `count` successes of `trials`, each of probability p.
double AtMost(int count, int trials, double p);

// Interval of Clopper and Pearson for p after `count` of `trials`: too high or too low with
// probability at most (1 - confidence) / 2 each. No trials: [0, 1].
Interval ClopperPearson(int count, int trials, double confidence = 0.95);

// The greatest count such that fewer successes are less likely than `error` if each has
// probability p: what a sample of `trials` must reach if p is to be held.
int FewestExpected(int trials, double p, double error);

// The least count such that more are less likely than `error`.
int MostExpected(int trials, double p, double error);

}  // namespace fathom::hidden
