// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/thinned_search.h"

#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/fit/least_inertia.h"
#include "fathom/diagnosis/fit/residual_noise.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

bool IsInertiaOpen(const StructureFit& fit) {
  const double std = std::sqrt(fit.covariance(kInertia, kInertia));
  return !fit.is_on_bound[kInertia] && !(std < fit.model.baseline.inertia);
}

std::vector<Suspect> OfTheVehicle(std::vector<Suspect> suspects) {
  std::erase_if(suspects, [](const Suspect& suspect) {
    return suspect.effect->info().scope != Scope::kVehicle;
  });
  return suspects;
}

// Share of the samples that count where a residual is alike from one to the next: n over the sum of
// its autocorrelation, up to where that is no longer above 0.
double EffectiveShare(const TrainingData& data, const Eigen::VectorXd& residual) {
  constexpr double kLeast = 0.1;
  double most = 1.0;
  for (const NoiseChannel channel : {NoiseChannel::kVelocity, NoiseChannel::kDisplacement}) {
    std::vector<double> values;
    for (int i = 0; i < data.bins().size(); ++i) {
      if (data.samples()[i].channel == channel) values.push_back(residual[i]);
    }
    double power = 0.0;
    for (const double value : values) power += value * value;
    double sum = 1.0;
    for (size_t lag = 1; lag < values.size() / 2; ++lag) {
      double product = 0.0;
      for (size_t i = lag; i < values.size(); ++i) product += values[i] * values[i - lag];
      if (!(product > 0.05 * power)) break;
      sum += 2.0 * product / power;
    }
    most = std::max(most, sum);
  }
  return std::max(kLeast, 1.0 / most);
}

}  // namespace

WeighedSearch SearchByLikelihood(const Prepared& prepared,
                                 const std::vector<Suspect>& suspects,
                                 const DiagnosisOptions& wanted,
                                 const EndsSearch& ends) {
  const StructureFit& baseline = prepared.baseline;
  const double inertia =
      std::min(baseline.model.baseline.inertia, prepared.users.model.baseline.inertia);
  const double share = IsInertiaOpen(baseline) ? kLeastInertiaIfOpen : kLeastInertia;
  TrainingData thinned(prepared.thinned, baseline.model.baseline, share * inertia);
  StructureFit rough =
      FitStructureAndNoise(thinned, baseline.model, baseline.initial, baseline.noise);
  if (!rough.IsSimulated()) rough = baseline;
  SearchResult found = SearchCauses(thinned, rough, suspects, wanted, wanted.search, ends);
  WeighedSearch search = {
      Criterion::kLearnedNoise, suspects, std::move(found), std::move(thinned), baseline};
  // A noise that the search found for the baseline may be the likelier one of all data too.
  const StructureFit& refitted = search.found.book.baseline().fit;
  if (!(refitted.log_likelihood > rough.log_likelihood)) return search;
  StructureFit again =
      FitBy(Criterion::kLearnedNoise, prepared.data, baseline, {&refitted.noise, 1});
  if (again.IsUsable() && again.log_likelihood > baseline.log_likelihood) {
    search.baseline = std::move(again);
  }
  return search;
}

WeighedSearch SearchByFreeRuns(const Prepared& prepared,
                               const std::vector<Suspect>& suspects,
                               const DiagnosisOptions& wanted,
                               const std::function<bool(const WeighedSearch&, int size)>& ends) {
  constexpr double kLeastOfMomentums = 0.05;  // inertia
  const StartedModel& users = prepared.users;
  const double inertia = std::min(users.model.baseline.inertia, prepared.inertia_by_momentum);
  TrainingData thinned(prepared.thinned, users.model.baseline, kLeastOfMomentums * inertia);
  const auto fitted = [&](const TrainingData& data) {
    return FitBy(Criterion::kFreeRun,
                 data,
                 users.model,
                 users.initial,
                 WhiteNoise(prepared.data, users.residual));
  };
  const StructureFit rough = fitted(thinned);
  SearchOptions options = wanted.search;
  options.criterion = Criterion::kFreeRun;
  options.effective_share = EffectiveShare(thinned, rough.residual);
  options.precision.share = kRoughShareOfFreeRun;
  options.precision.gain /= options.effective_share;
  options.precision.turn /= options.effective_share;
  options.most_work *= 0.5;
  options.beam = 2;
  const std::vector<Suspect> of_the_vehicle = OfTheVehicle(suspects);
  const StructureFit baseline = fitted(prepared.data);
  const auto search_of = [&](SearchResult found) -> WeighedSearch {
    return {Criterion::kFreeRun, of_the_vehicle, std::move(found), thinned, baseline};
  };
  const auto ends_with = [&](const HypothesisBook& book, int size) {
    return ends(search_of({.book = book, .scores = {}}), size);
  };
  return search_of(SearchCauses(thinned, rough, of_the_vehicle, wanted, options, ends_with));
}

}  // namespace fathom
