// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/calibration.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

Significance SignificanceOf(const SearchTask& task, const Starts& starts) {
  std::vector<int> num_amounts(task.suspects.size(), 1);
  std::vector<double> caution(task.suspects.size(), 1.0);
  for (const Trial& trial : starts.trials().trials) {
    num_amounts[trial.suspect] = trial.num_columns;
    const bool is_searched = trial.values.size() > trial.amounts.size();
    const bool has_partner = task.suspects[trial.suspect].effect->info().has_partner();
    caution[trial.suspect] = task.options.caution_of_learned_noise *
                             (is_searched ? task.options.caution_between_the_grid : 1.0) *
                             (has_partner ? task.options.caution_with_a_partner : 1.0);
  }
  return Significance(
      starts.screen().NullMaxima(task.options.null_draws, task.num_suspects(), task.wanted.seed),
      std::move(num_amounts),
      caution,
      task.wanted.false_alarm_rate);
}

}  // namespace

double Calibration::ThresholdOf(const std::vector<int>& suspects) const {
  double sum = 0.0, most_spared = 0.0;
  for (const int suspect : suspects) {
    sum += thresholds_beside[suspect];
    most_spared = std::max(most_spared, thresholds_beside[suspect] - thresholds[suspect]);
  }
  return sum - most_spared;  // one of them came first
}

Calibration CalibrationOf(const SearchTask& task, const Screens& about_baseline) {
  Calibration calibration;
  if (!about_baseline.own) return calibration;
  calibration.significance = SignificanceOf(task, *about_baseline.own);
  const Significance& significance = calibration.significance;
  const double log_num_data = std::log(static_cast<double>(task.data.bins().size()));
  for (int k = 0; k < task.num_suspects(); ++k) {
    const double paid =
        log_num_data * static_cast<double>(task.suspects[k].effect->info().parameters.size());
    calibration.thresholds.push_back(std::max(significance.Threshold(k), paid));
    calibration.thresholds_beside.push_back(std::max(significance.ThresholdBeside(k), paid));
  }
  return calibration;
}

}  // namespace fathom
