// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/fit_with_noise.h"

#include "fathom/diagnosis/fit/residual_noise.h"
#include "fathom/noise/fit_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace fathom {
namespace {

// Of the log-likelihood. A finer search of the noise takes twice as long and ends no less often at
// a maximum that is not the greatest.
constexpr double kNoisePrecision = 0.005;
constexpr int kMostTurns = 5;

// What is missing makes neighbouring errors of a free run alike, so that they tell far less than
// their number: a step that promises less than this share of them is none.
constexpr double kLeastShareOfFreeRun = 1e-4;

// Whether other maxima of the noise are looked for: what begins from nothing has to find the
// greatest, and what begins from a noise that was found so keeps to it.
enum class Look { kNear, kThorough };

// The noise of what a fit leaves, its parameters free (`design`: its Jacobian) or as they are (a
// design without columns).
NoiseModel LearnNoise(const TrainingData& data,
                      const StructureFit& fit,
                      const Eigen::Ref<const RowMajorMatrix>& design,
                      const std::optional<NoiseModel>& start,
                      Look look) {
  FitNoiseOptions options;
  options.damping_rate = data.DampingRate(fit.model.baseline);
  options.start = start;
  options.precision = kNoisePrecision;
  options.is_thorough = look == Look::kThorough;
  const NoiseFit learned = FitNoise(
      data.samples(), std::span(fit.residual.data(), fit.residual.size()), design, options);
  data.CountLikelihoods(learned.num_evaluations);
  // Too few samples, or a channel without any error.
  if (!std::isfinite(learned.log_likelihood)) return SensorNoiseOnly(data, fit.residual);
  const NoiseModel quietest = QuietestSensors(data);
  NoiseModel noise = learned.model;
  noise.velocity.white_std = std::max(noise.velocity.white_std, quietest.velocity.white_std);
  noise.displacement.white_std =
      std::max(noise.displacement.white_std, quietest.displacement.white_std);
  return noise;
}

// The likeliest of noises that were learned with other models and of ones of the same kind that are
// smaller: a better model leaves less to the disturbance and to slow sensor errors.
NoiseModel LikeliestSize(const TrainingData& data,
                         const StructureFit& fit,
                         std::span<const NoiseModel> known) {
  const std::span<const double> residual(fit.residual.data(), fit.residual.size());
  NoiseModel best;
  double most = -std::numeric_limits<double>::infinity();
  for (const NoiseModel& size : known) {
    for (const double of_disturbance : {1.0, 0.3, 0.1, 0.03}) {
      for (const double of_coloured : {1.0, 0.3, 0.1}) {
        NoiseModel noise = size;
        noise.disturbance.std *= of_disturbance;
        noise.velocity.coloured.std *= of_coloured;
        noise.displacement.coloured.std *= of_coloured;
        const double log_likelihood = Whitener(noise, data.samples()).LogLikelihood(residual);
        if (!(log_likelihood > most)) continue;
        most = log_likelihood;
        best = noise;
      }
    }
  }
  return best;
}

// True if a fit leaves far more than its noise allows. That noise was learned from what the model's
// derivatives leave, and the model itself does not get there.
bool IsUnreached(const StructureFit& fit) {
  constexpr double kMost = 10.0;  // of the chi-square's expectation
  return fit.chi_squared > kMost * static_cast<double>(fit.residual.size());
}

// Learns noise and parameters in turn, from a fit under a first noise.
StructureFit LearnOn(const TrainingData& data,
                     StructureFit fit,
                     NoiseModel noise,
                     const FitPrecision& precision,
                     Look look) {
  const RowMajorMatrix none(fit.residual.size(), 0);
  StructureFit likeliest;
  double previous = -std::numeric_limits<double>::infinity();
  for (int turn = 0; fit.IsSimulated(); ++turn) {
    fit.noise = noise;
    const bool is_unreached = IsUnreached(fit);
    if (fit.log_likelihood < previous + precision.turn && !is_unreached) break;
    if (turn + 1 == kMostTurns || fit.log_likelihood < precision.least) break;
    if (turn == 0 || fit.log_likelihood > likeliest.log_likelihood) likeliest = fit;
    previous = fit.log_likelihood;
    noise = LearnNoise(data, fit, is_unreached ? none : fit.jacobian, noise, look);
    fit = FitStructure(data, std::move(fit), Whitener(noise, data.samples()), precision);
  }
  const bool ended_badly = (IsUnreached(fit) || !fit.converged) && likeliest.IsSimulated();
  return ended_badly && likeliest.log_likelihood > fit.log_likelihood ? likeliest : fit;
}

// The same with each channel's noise as large as its residual.
StructureFit FitFreeRun(const TrainingData& data, StructureFit fit, FitPrecision precision) {
  precision.share = std::max(precision.share, kLeastShareOfFreeRun);
  double previous = -std::numeric_limits<double>::infinity();
  for (int turn = 0; fit.IsSimulated(); ++turn) {
    fit.noise = WhiteNoise(data, fit.residual);
    const Whitener whitener(fit.noise, data.samples());
    fit.log_likelihood =
        whitener.LogLikelihood(std::span(fit.residual.data(), fit.residual.size()));
    if (fit.log_likelihood < previous + precision.turn || turn == kMostTurns) break;
    if (turn > 0 && fit.log_likelihood < precision.least) break;
    previous = fit.log_likelihood;
    fit = FitStructure(data, std::move(fit), whitener, precision);
  }
  return fit;
}

}  // namespace

StructureFit FitBy(Criterion criterion,
                   const TrainingData& data,
                   const StructureFit& start,
                   std::span<const NoiseModel> known,
                   const FitPrecision& precision) {
  if (criterion == Criterion::kFreeRun) return FitFreeRun(data, start, precision);
  const NoiseModel noise =
      LearnNoise(data, start, start.jacobian, LikeliestSize(data, start, known), Look::kNear);
  return LearnOn(data,
                 FitStructure(data, start, Whitener(noise, data.samples()), precision),
                 noise,
                 precision,
                 Look::kNear);
}

StructureFit FitBy(Criterion criterion,
                   const TrainingData& data,
                   const ExtendedModel& start,
                   std::span<const InitialState> initial,
                   const NoiseModel& noise,
                   const FitPrecision& precision) {
  if (criterion == Criterion::kLearnedNoise) {
    return FitStructureAndNoise(data, start, initial, noise, precision);
  }
  const Whitener whitener(noise, data.samples());
  return FitFreeRun(data, FitStructure(data, start, initial, whitener, precision), precision);
}

StructureFit FitStructureAndNoise(const TrainingData& data,
                                  const ExtendedModel& start,
                                  std::span<const InitialState> initial,
                                  const NoiseModel& noise,
                                  const FitPrecision& precision) {
  const Whitener whitener(noise, data.samples());
  return LearnOn(
      data, FitStructure(data, start, initial, whitener, precision), noise, precision, Look::kNear);
}

StructureFit FitStructureAndNoise(const TrainingData& data,
                                  const StructureFit& start,
                                  const FitPrecision& precision) {
  const NoiseModel noise = FirstNoise(data, start);
  const Whitener whitener(noise, data.samples());
  return LearnOn(
      data, FitStructure(data, start, whitener, precision), noise, precision, Look::kThorough);
}

StructureFit FitBaseline(const TrainingData& data,
                         const ExtendedModel& start,
                         std::span<const InitialState> initial) {
  const auto simulated = data.Simulate(start, initial);
  if (!simulated) return {};
  const Whitener sensor(SensorNoiseOnly(data, data.measured() - *simulated), data.samples());
  const StructureFit first = FitStructure(data, start, initial, sensor);
  if (!first.IsSimulated()) return first;
  return FitStructureAndNoise(data, first);
}

NoiseModel FirstNoise(const TrainingData& data, const StructureFit& fit) {
  return LearnNoise(data, fit, fit.jacobian, std::nullopt, Look::kThorough);
}

}  // namespace fathom
