// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/recommendation.h"

#include "fathom/simulate/free_run.h"
#include "fathom/simulate/noise_floor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace fathom {
namespace {

std::span<const Segment> Judged(const DofComparison& comparison) {
  const Signals& scored = comparison.scored;
  return scored.held_out.empty() ? scored.train : scored.held_out;
}

std::vector<FreeRun> RunsOf(const DofComparison& comparison, const Identification& row) {
  std::vector<FreeRun> runs;
  for (const Segment& segment : Judged(comparison)) {
    if (auto run = FreeRunOver(segment, {row.fitted.model})) runs.push_back(*std::move(run));
  }
  return runs;
}

int RankOf(Family family) {
  switch (family) {
    case Family::kJoint:
      return 0;
    case Family::kOutputError:
      return 1;
    case Family::kLeastSquares:
      return 2;
    case Family::kAdaptive:
      return 3;
  }
  return 4;
}

}  // namespace

double ScoreOf(const DofComparison& comparison, const Identification& row) {
  return comparison.scored.held_out.empty() ? row.fitted.train.nmae : row.fitted.held_out.nmae;
}

Recommendation Recommend(const DofComparison& comparison) {
  std::vector<const Identification*> rows;
  for (const Identification& row : comparison.rows) {
    if (row.is_usable && std::isfinite(ScoreOf(comparison, row))) rows.push_back(&row);
  }
  if (rows.empty()) return {};
  const auto score = [&](const Identification* row) { return ScoreOf(comparison, *row); };
  const Identification* least = *std::ranges::min_element(rows, {}, score);
  const std::vector<FreeRun> runs_of_least = RunsOf(comparison, *least);
  std::erase_if(rows, [&](const Identification* row) {
    return row != least && GainOf(RunsOf(comparison, *row), runs_of_least).low > 0.0;
  });
  Recommendation recommendation;
  recommendation.taken = *std::ranges::min_element(rows, {}, [&](const Identification* row) {
    return std::pair(RankOf(row->stand_in.value_or(row->family)), score(row));
  });
  for (const Identification* row : rows) {
    if (row != recommendation.taken) recommendation.as_good.push_back(row);
  }
  if (recommendation.taken != least) {
    recommendation.least = least;
    recommendation.is_chance_known =
        std::isfinite(GainOf(RunsOf(comparison, *recommendation.taken), runs_of_least).low);
  }
  return recommendation;
}

double NoiseNmae(const DofComparison& comparison) {
  const Identification* taken = Recommend(comparison).taken;
  return taken == nullptr ? std::numeric_limits<double>::quiet_NaN()
                          : NmaeOfScatter(RunsOf(comparison, *taken));
}

}  // namespace fathom
