// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/comparison.h"

#include <vector>

namespace fathom {

// The NMAE of a model that stands still. One with more is not to be taken.
inline constexpr double kScoreAtRest = 1.0;

// Which model to take, of the usable ones that can be simulated. They are judged by their NMAE on
// held-out data, if any were held out.
struct Recommendation {
  const Identification* taken = nullptr;  // null if there is none

  // Others whose error differs by no more than chance: GainOf()'s 95 % interval over blocks holds
  // 0.
  std::vector<const Identification*> as_good;

  // The row of the least error, where another one is taken. Whether an interval says that its lead
  // may be chance; false: the data are too few for one.
  const Identification* least = nullptr;
  bool is_chance_known = false;
};

// Takes, of the model of the least error and those that are as good, the one whose parameters are
// determined best. That is told by the family, not by the width of the intervals: joint and output
// error weigh all noise, and their intervals hold; those of least squares leave out the noise of
// the motion; those of the adaptive law are no standard errors. Among equals the least error
// counts.
Recommendation Recommend(const DofComparison& comparison);

// What a model is judged by. NaN: it cannot predict these data.
double ScoreOf(const DofComparison& comparison, const Identification& row);

// The NMAE that scatter from sample to sample alone gives on the data that decide, by the
// recommended row (noise_floor.h). NaN where there is no such row.
double NoiseNmae(const DofComparison& comparison);

}  // namespace fathom
