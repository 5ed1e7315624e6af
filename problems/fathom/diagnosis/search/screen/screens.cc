// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/screens.h"

#include "fathom/diagnosis/fit/residual_noise.h"

#include <algorithm>
#include <numeric>

namespace fathom {
namespace {

std::vector<double> ScoresOf(const Screens& screens, const SearchTask& task) {
  std::vector<double> scores(task.suspects.size(), 0.0);
  if (!screens.own) return scores;
  const double sharpest = screens.sharp ? screens.sharp->BestScore() : 0.0;
  const double strongest = std::max(screens.own->BestScore(), task.options.sharpest);
  const double scale = sharpest > 0.0 ? std::min(1.0, strongest / sharpest) : 0.0;
  for (int suspect = 0; suspect < task.num_suspects(); ++suspect) {
    scores[suspect] = screens.own->Score(suspect);
    if (!screens.sharp) continue;
    scores[suspect] = std::max(scores[suspect], scale * screens.sharp->Score(suspect));
  }
  return scores;
}

}  // namespace

Screens ScreensAbout(const SearchTask& task,
                     const std::shared_ptr<const FitAndTrials>& about,
                     const NoiseModel& noise,
                     Sharpness sharpness) {
  Screens screens;
  if (!about->trials.trials.empty()) {
    const auto& samples = task.data.samples();
    screens.own.emplace(task.data, task.suspects, about, Whitener(noise, samples));
    // The noise of free runs is white already: nothing passes for a disturbance.
    if (sharpness == Sharpness::kWithSensor && task.options.criterion == Criterion::kLearnedNoise) {
      const NoiseModel sensor = SensorNoiseOnly(task.data, about->fit.residual);
      screens.sharp.emplace(task.data, task.suspects, about, Whitener(sensor, samples));
    }
  }
  screens.scores = ScoresOf(screens, task);
  return screens;
}

std::shared_ptr<const FitAndTrials> WithTrials(const SearchTask& task, const StructureFit& fit) {
  return std::make_shared<const FitAndTrials>(
      FitAndTrials{fit, TrialsAbout(task.data, fit, task.suspects)});
}

std::vector<int> InOrder(const std::vector<double>& scores) {
  std::vector<int> order(scores.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return scores[a] > scores[b]; });
  return order;
}

}  // namespace fathom
