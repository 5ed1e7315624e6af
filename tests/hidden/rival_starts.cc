// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "rival_starts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>

namespace fathom::hidden {
namespace {

using Values = std::vector<double>;

constexpr std::size_t kMostStarts = 3;

double NaturalSize(const Quantity& quantity, const ActiveEffect& effect, const RunScales& scales) {
  const int dof = Index(effect.setting.dof);
  return std::pow(scales.force[dof], quantity.force) * std::pow(scales.speed[dof], quantity.speed);
}

// Frequencies at which the residual has most of a sine; the response to a force is a sine too.
Values LikelyFrequencies(const KnownRun& run,
                         const KnownNoiseFit& fitted,
                         const RunScales& scales) {
  Eigen::VectorXd residual;
  if (!run.Residual(fitted.model, fitted.initial, &residual)) return {};
  const double spacing = 0.7 * std::numbers::pi / scales.train_duration;
  std::vector<std::pair<double, double>> peaks;
  constexpr int kBlock = 32;
  for (double first = 2.0 * spacing; first < 4.0; first += kBlock * spacing) {
    const RowMajorMatrix columns = run.WhitenedColumns(2 * kBlock, [&](double t, int j) {
      const double phase = (first + (j / 2) * spacing) * t;
      return j % 2 == 0 ? std::sin(phase) : std::cos(phase);
    });
    for (int k = 0; k < kBlock; ++k) {
      const double s = columns.col(2 * k).dot(residual), c = columns.col(2 * k + 1).dot(residual);
      const double power =
          s * s / columns.col(2 * k).squaredNorm() + c * c / columns.col(2 * k + 1).squaredNorm();
      peaks.push_back({power, first + k * spacing});
    }
  }
  std::sort(peaks.rbegin(), peaks.rend());
  Values frequencies;
  for (const auto& [power, frequency] : peaks) {
    if (frequencies.size() == 4) break;
    const bool is_new = std::all_of(frequencies.begin(), frequencies.end(), [&](double other) {
      return std::abs(other - frequency) > 2.5 * spacing;
    });
    if (is_new) frequencies.push_back(frequency);
  }
  return frequencies;
}

// All values to be tried, each with its amounts at null where another parameter is searched.
std::vector<Values> Trials(const KnownRun& run,
                           const KnownNoiseFit& fitted,
                           const RunScales& scales,
                           const ActiveEffect& effect) {
  const EffectInfo& info = effect.effect->info();
  Values null;
  for (const EffectParameter& parameter : info.parameters) {
    null.push_back(std::isfinite(parameter.null) ? parameter.null : 0.0);
  }
  std::vector<Values> trials;
  bool is_searched = false;
  for (std::size_t i = 0; i < null.size(); ++i) {
    const EffectParameter& parameter = info.parameters[i];
    Values choices;
    if (parameter.search == Search::kTimeOfRun) {
      for (int k = 1; k < 30; ++k) {
        choices.push_back(run.start() - run.time_zero() + k / 30.0 * (run.end() - run.start()));
      }
    } else if (parameter.search == Search::kFrequencyOfRun) {
      choices = LikelyFrequencies(run, fitted, scales);
    } else if (parameter.search != Search::kAmount) {
      for (const double trial : parameter.trials) {
        choices.push_back(trial * NaturalSize(parameter.quantity, effect, scales));
      }
      if (info.name == "thrust_saturation") {
        for (const double share : {0.5, 0.7, 0.85, 0.93, 0.98}) {
          choices.push_back(share * scales.most_force);
        }
      }
    }
    is_searched = is_searched || !choices.empty();
    for (const double choice : choices) {
      trials.push_back(null);
      trials.back()[i] = choice;
    }
  }
  if (!is_searched) trials.push_back(null);
  return trials;
}

// The model a linear step on, in the amounts alone, and what chi2 that promises.
double Forecast(const KnownRun& run,
                const KnownNoiseFit& fitted,
                const ActiveEffect& effect,
                ExtendedModel* model) {
  Eigen::VectorXd residual;
  RowMajorMatrix sensitivity;
  if (!run.Linearise(*model, fitted.initial, &residual, &sensitivity)) {
    return std::numeric_limits<double>::infinity();
  }
  const Eigen::VectorXd norms = sensitivity.colwise().norm();
  for (Eigen::Index j = 0; j < norms.size(); ++j) {
    if (norms[j] > 0.0) sensitivity.col(j) /= norms[j];
  }
  Eigen::MatrixXd information = sensitivity.transpose() * sensitivity;
  information.diagonal().array() += 1e-9;
  const Eigen::VectorXd gradient = sensitivity.transpose() * residual;
  const Eigen::VectorXd step = information.ldlt().solve(gradient);
  int column = EffectSimulation::kFirstEffectColumn;
  for (ActiveEffect& active : model->effects) {
    for (std::size_t i = 0; i < active.values.size(); ++i, ++column) {
      const EffectParameter& parameter = active.effect->info().parameters[i];
      const bool is_ours =
          active.effect == effect.effect && active.setting.partner == effect.setting.partner;
      // Where another parameter has no meaning without an amount, the amount must leave its null.
      const bool is_amount = parameter.search == Search::kAmount && active.values.size() > 1;
      if (!is_ours || !is_amount || norms[column] == 0.0) continue;
      active.values[i] = std::clamp(
          active.values[i] + step[column] / norms[column], parameter.lower, parameter.upper);
    }
  }
  return residual.squaredNorm() - gradient.dot(step);
}

}  // namespace

std::vector<ExtendedModel> StartsFor(const KnownRun& run,
                                     const KnownNoiseFit& fitted,
                                     const RunScales& scales,
                                     const ActiveEffect& effect) {
  std::vector<std::pair<double, ExtendedModel>> starts;
  for (Values& values : Trials(run, fitted, scales, effect)) {
    ActiveEffect tried = effect;
    tried.values = std::move(values);
    ExtendedModel model = WithEffect(fitted.model, tried);
    const double forecast = Forecast(run, fitted, tried, &model);
    if (std::isfinite(forecast)) starts.emplace_back(forecast, std::move(model));
  }
  std::stable_sort(
      starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ExtendedModel> best;
  for (auto& [forecast, model] : starts) {
    if (best.size() < kMostStarts) best.push_back(std::move(model));
  }
  return best;
}

}  // namespace fathom::hidden
