// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/limits.h"

#include "fathom/diagnosis/search/screen/screen.h"
#include "fathom/diagnosis/search/screen/trials.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/noise/fit_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace fathom {
namespace {

// Chi squared that a value must lose against the best one to be 95 % excluded, to one side and to
// both.
constexpr double kOneSided = 2.706, kTwoSided = 3.841;
constexpr int kPerOctave = 32;          // of values, between the trials
constexpr double kShowsNothing = 1e-6;  // chi squared of the roundings of a limit out of reach
constexpr double kLeastLimit = 0.25;    // standard deviations

// One value that was tried, by how far it is from the null: the value less that, or one over it
// where the null is infinite.
struct Tried {
  double distance = 0.0;  // at least 0
  Screen::Response response;
};

double DistanceOf(double value, double null) {
  return std::isinf(null) ? 1.0 / value : value - null;
}

// Chi squared gained at a distance to one side: signatures grow in proportion up to the first
// trial, and between trials as their lengths and their inner products do.
double GainAt(double distance, const std::vector<Tried>& side) {
  const auto next = std::find_if(
      side.begin(), side.end(), [&](const Tried& tried) { return tried.distance >= distance; });
  if (next == side.end()) return -std::numeric_limits<double>::infinity();
  const Tried before = next == side.begin() ? Tried{} : *(next - 1);
  const double share = (distance - before.distance) / (next->distance - before.distance);
  const double inner = (1.0 - share) * before.response.inner + share * next->response.inner;
  const double length = (1.0 - share) * std::sqrt(before.response.squared) +
                        share * std::sqrt(next->response.squared);
  return 2.0 * inner - length * length;
}

// Distances along one side, fine enough to find where a gain is lost.
std::vector<double> DistancesAlong(const std::vector<Tried>& side) {
  std::vector<double> distances = {0.0};
  if (side.empty()) return distances;
  constexpr double kSmallest = 1e-4;
  const double factor = std::exp2(1.0 / kPerOctave);
  for (double d = kSmallest * side.front().distance; d < side.back().distance; d *= factor) {
    distances.push_back(d);
  }
  for (const Tried& tried : side) distances.push_back(tried.distance);
  std::sort(distances.begin(), distances.end());
  return distances;
}

// The least and the greatest signed distance that are not excluded.
struct Reach {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

// Widens a reach by what is not excluded on one side. False if that is all of it.
bool Widen(const std::vector<Tried>& side, double sign, double least_gain, Reach* reach) {
  if (side.empty()) return true;
  bool ends = false;
  for (const double d : DistancesAlong(side)) {
    ends = GainAt(d, side) < least_gain;
    if (ends) continue;
    reach->least = std::min(reach->least, sign * d);
    reach->greatest = std::max(reach->greatest, sign * d);
  }
  return ends;
}

double BestGain(const std::vector<Tried>& side) {
  double best = 0.0;
  for (const double d : DistancesAlong(side)) best = std::max(best, GainAt(d, side));
  return best;
}

// The noise whose tests are sharp on average (REML, AIC: docs/residual_noise.md); that of the
// search is cautious, and limits by it would hold too often.
NoiseModel NoiseOf(const TrainingData& data, const StructureFit& fit) {
  FitNoiseOptions options;
  options.selection = NoiseSelection::kAic;
  options.damping_rate = data.DampingRate(fit.model.baseline);
  const NoiseFit noise = FitNoise(
      data.samples(), std::span(fit.residual.data(), fit.residual.size()), fit.jacobian, options);
  return noise.IsUsable() ? noise.model : fit.noise;
}

// Of an effect whose response is in proportion to its amount.
void LimitAmount(const EffectParameter& parameter,
                 double probe,
                 const Screen::Response& response,
                 ExclusionLimit* limit) {
  if (!(response.squared > 0.0)) return;
  const double way = probe - parameter.null;
  const double best = way * response.inner / response.squared;
  const double std = std::abs(way) / std::sqrt(response.squared);
  const bool is_one_sided = parameter.lower == parameter.null;
  const double lost = std::sqrt(is_one_sided ? kOneSided : kTwoSided);
  limit->high = parameter.null + best + lost * std;
  limit->low = is_one_sided ? parameter.null : parameter.null + best - lost * std;
  // Below the null there is nothing to exclude: what little the data could tell stays.
  if (is_one_sided) limit->high = std::max(limit->high, parameter.null + kLeastLimit * std);
  limit->is_told = limit->high < parameter.upper || limit->low > parameter.lower;
  limit->high = std::min(limit->high, parameter.upper);
  limit->low = std::max(limit->low, parameter.lower);
}

// Of one whose response changes shape with its size, from the sizes that were tried.
void LimitSize(const EffectParameter& parameter,
               std::vector<Tried> above,
               std::vector<Tried> below,
               ExclusionLimit* limit) {
  const auto by_distance = [](const Tried& a, const Tried& b) { return a.distance < b.distance; };
  std::sort(above.begin(), above.end(), by_distance);
  std::sort(below.begin(), below.end(), by_distance);
  const double nothing = std::isinf(parameter.null) ? kShowsNothing : 0.0;
  auto first = std::find_if(above.begin(), above.end(), [&](const Tried& tried) {
    return tried.response.squared > nothing;
  });
  if (first == above.end()) return;
  // A limit that the run does not reach changes nothing, wherever it is. So between the last one
  // that shows nothing and the first that shows something none is excluded.
  if (std::isinf(parameter.null)) {
    constexpr double kJustBefore = 1.0 - 1e-6;
    first = above.insert(first, {.distance = kJustBefore * first->distance, .response = {}}) + 1;
  }
  const bool is_one_sided = below.empty();
  double best = std::max(BestGain(above), BestGain(below));
  double least = 0.0;
  if (is_one_sided) {
    // As if there were values beyond the null too: else a limit there would hold too often.
    const auto& [inner, squared] = first->response;
    if (inner < 0.0) best = std::max(best, inner * inner / squared);
    least = kLeastLimit * first->distance / std::sqrt(squared);
  }
  const double least_gain = best - (is_one_sided ? kOneSided : kTwoSided);
  Reach reach;
  if (!Widen(above, 1.0, least_gain, &reach) || !Widen(below, -1.0, least_gain, &reach)) return;
  const double up = is_one_sided ? std::max(reach.greatest, least) : reach.greatest;
  if (up >= above.back().distance) return;
  limit->is_told = true;
  if (std::isinf(parameter.null)) {
    limit->low = 1.0 / up;
    limit->high = parameter.null;
  } else {
    limit->low = is_one_sided ? parameter.null : parameter.null + reach.least;
    limit->high = parameter.null + up;
  }
}

// The trials of one suspect, on both sides of the null.
ExclusionLimit LimitOf(const Suspect& suspect,
                       int index,
                       const Trials& trials,
                       const Screen& screen) {
  const EffectParameter& parameter = suspect.effect->info().parameters.front();
  ExclusionLimit limit = {
      .effect = suspect.effect, .setting = suspect.setting, .label = LabelOf(suspect)};
  std::vector<Tried> above, below;
  for (size_t t = 0; t < trials.trials.size(); ++t) {
    const Trial& trial = trials.trials[t];
    if (trial.suspect != index) continue;
    const Screen::Response& response = screen.response(static_cast<int>(t));
    if (parameter.search == Search::kAmount) {
      LimitAmount(parameter, trial.values.front(), response, &limit);
      return limit;
    }
    const double distance = DistanceOf(trial.values.front(), parameter.null);
    (distance > 0.0 ? above : below).push_back({std::abs(distance), response});
  }
  LimitSize(parameter, std::move(above), std::move(below), &limit);
  return limit;
}

}  // namespace

std::vector<ExclusionLimit> LimitsOf(const TrainingData& data,
                                     const StructureFit& fit,
                                     const std::vector<Suspect>& suspects) {
  std::vector<Suspect> left;
  for (const Suspect& suspect : suspects) {
    const auto& parameters = suspect.effect->info().parameters;
    if (parameters.size() == 1 && PlaceIn(fit.model, suspect) < 0) left.push_back(suspect);
  }
  std::vector<ExclusionLimit> limits;
  const Trials trials = TrialsAbout(data, fit, left);
  if (trials.trials.empty()) return limits;
  const Screen screen(fit, &trials, Whitener(NoiseOf(data, fit), data.samples()));
  for (size_t k = 0; k < left.size(); ++k) {
    limits.push_back(LimitOf(left[k], static_cast<int>(k), trials, screen));
  }
  return limits;
}

}  // namespace fathom
