// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "score_board.h"

#include <algorithm>
#include <cmath>

namespace fathom::hidden {
namespace {

constexpr double kLeastGain = 0.02;  // of the oracle, for a ratio to mean anything

EffectRow& RowOf(const std::string& effect, std::vector<EffectRow>* rows) {
  for (EffectRow& row : *rows) {
    if (row.effect == effect) return row;
  }
  rows->emplace_back();
  rows->back().effect = effect;
  return rows->back();
}

void AddNothing(const LogScore& score, ScoreBoard* board) {
  ++board->nothing;
  if (score.HasCause()) ++board->false_causes;
  if (score.HasCertainCause()) ++board->false_certain_causes;
  if (score.verdict != Verdict::kConsistent) ++board->not_consistent;
  board->null_model_parameters.Add(score.model_parameters);
}

void AddUnlisted(const LogScore& score, ScoreBoard* board) {
  board->unlisted.Add(score);
  if (score.HasCertainCause()) ++board->unlisted_certain;
  if (!score.oracle.IsClear()) return;
  ++board->unlisted_clear;
  if (score.HasCertainCause()) ++board->unlisted_clear_certain;
  if (score.verdict == Verdict::kConsistent) ++board->unlisted_clear_unseen;
}

void AddEffects(const LogScore& score, ScoreBoard* board) {
  const bool is_sure = score.oracle.IsClear() && score.oracle.IsSeparable();
  if (score.oracle.IsClear() && score.oracle_gain > kLeastGain) {
    board->gain_ratios.push_back(score.gain / score.oracle_gain);
  }
  if (score.hidden == HiddenClass::kTwoEffects) {
    board->all_two.Add(score);
    if (is_sure) board->separable_two.Add(score);
    return;
  }
  board->all_one.Add(score);
  if (is_sure) board->separable_one.Add(score);
  board->effect_parameters.Add(score.effect_parameters);
  board->model_parameters.Add(score.model_parameters);
  EffectRow& row = RowOf(score.effects.front(), &board->effects);
  row.all.Add(score);
  if (score.oracle.IsClear()) ++row.clear;
  if (is_sure) {
    ++row.separable;
    row.separable_tally.Add(score);
  }
  row.effect_parameters.Add(score.effect_parameters);
  row.model_parameters.Add(score.model_parameters);
}

}  // namespace

void Tally::Add(const LogScore& score) {
  ++logs;
  ++outcomes[static_cast<int>(score.outcome)];
}

double ScoreBoard::MedianGainRatio() const {
  if (gain_ratios.empty()) return std::nan("");
  std::vector<double> sorted = gain_ratios;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t n = sorted.size();
  return n % 2 == 1 ? sorted[n / 2] : 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]);
}

ScoreBoard BoardOf(const std::vector<LogScore>& scores) {
  ScoreBoard board;
  for (const LogScore& score : scores) {
    switch (score.hidden) {
      case HiddenClass::kNothing:
        AddNothing(score, &board);
        break;
      case HiddenClass::kUnlisted:
        AddUnlisted(score, &board);
        break;
      default:
        AddEffects(score, &board);
    }
    board.diagnosis_seconds += score.seconds;
    board.slowest_diagnosis = std::max(board.slowest_diagnosis, score.seconds);
    if (score.oracle.seconds > 0.0) board.oracle_seconds += score.oracle.seconds;
  }
  return board;
}

}  // namespace fathom::hidden
