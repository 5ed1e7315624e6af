// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/series_model.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

constexpr int kMostRounds = 6;
constexpr double kGainThatMoves = 1e-6;

ScanResult ScanOf(const SeriesModel& model, int num_dives) {
  return Scan(MakeScanDesign(model.series, AllColumns(model), num_dives), model.series.value);
}

double LogLikelihood(const SeriesModel& model, int num_dives) {
  return ScanOf(model, num_dives).log_likelihood;
}

// True if the model has changed.
bool TryAgain(std::size_t index, double threshold, int num_dives, SeriesModel* model) {
  SeriesModel without = *model;
  without.found.erase(without.found.begin() + index);
  const ScanDesign design = MakeScanDesign(model->series, AllColumns(without), num_dives);
  const ScanResult scan = Scan(design, model->series.value);
  const ScanCandidate best = BestChange(scan);
  if (best.statistic < threshold) {
    *model = without;
    return true;
  }
  const int own = CandidateOf(model->series, model->found[index].column);
  const bool is_own = own >= 0 && own < design.num_dives;
  if (is_own && best.statistic <= scan.statistic(own) + kGainThatMoves) return false;
  model->found[index].column = ColumnOf(model->series, best.index);
  return true;
}

bool TryTrendForSteps(double threshold, int num_dives, SeriesModel* model) {
  const std::vector<Column> columns = AllColumns(*model);
  const bool has_trend = std::any_of(columns.begin(), columns.end(), [](const Column& column) {
    return column.kind == ChangeKind::kTrend;
  });
  if (has_trend) return false;
  const double both = LogLikelihood(*model, num_dives);
  for (std::size_t i = 0; i < model->found.size(); ++i) {
    for (std::size_t j = i + 1; j < model->found.size(); ++j) {
      SeriesModel with_trend = *model;
      with_trend.found[i].column = {ChangeKind::kTrend, model->series.dive.front()};
      with_trend.found.erase(with_trend.found.begin() + j);
      const double loss = both - LogLikelihood(with_trend, num_dives);
      if (2.0 * loss >= threshold) continue;
      *model = with_trend;
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<Column> AllColumns(const SeriesModel& model) {
  std::vector<Column> columns = model.known;
  for (const FoundColumn& found : model.found) columns.push_back(found.column);
  return columns;
}

SeriesModel Reconsidered(SeriesModel model, double threshold, int num_dives) {
  for (int round = 0; round < kMostRounds; ++round) {
    bool has_changed = TryTrendForSteps(threshold, num_dives, &model);
    for (std::size_t i = 0; i < model.found.size(); ++i) {
      has_changed = TryAgain(i, threshold, num_dives, &model) || has_changed;
    }
    if (!has_changed) break;
  }
  return model;
}

}  // namespace fathom
