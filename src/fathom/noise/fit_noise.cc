// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/fit_noise.h"

#include "fathom/noise/noise_search.h"
#include "fathom/noise/noise_structure.h"
#include "fathom/noise/restricted_likelihood.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace fathom {
namespace {

using Result = NoiseSearch::Result;

// So much coarser are fits that only compare components.
constexpr double kCoarser = 20.0;

// One call of FitNoise().
class Fitting {
 public:
  Fitting(const RestrictedLikelihood& likelihood,
          const NoiseSampling& sampling,
          const FitNoiseOptions& options)
      : likelihood_(likelihood), sampling_(sampling), options_(options), search_(likelihood) {}

  int num_evaluations() const { return search_.num_evaluations(); }

  // One component after another, the best first, for as long as each is worth its price.
  Result FromNothing() {
    NoiseModel white;
    white.velocity.white_std = likelihood_.RootMeanSquare(NoiseChannel::kVelocity);
    white.displacement.white_std = likelihood_.RootMeanSquare(NoiseChannel::kDisplacement);
    const NoiseStructure structure = Structure({});
    Result best = search_.From(structure, structure.Parameters(white), options_.precision);
    for (;;) {
      std::optional<Result> next;
      for (const NoiseComponent component : Missing(best.structure.components())) {
        Result result = Extended(best, component);
        if (!next || result.log_likelihood() > next->log_likelihood()) next = std::move(result);
      }
      if (!next || !(next->log_likelihood() - best.log_likelihood() > Price())) {
        return search_.From(best.structure, best.best.parameters, options_.precision);
      }
      best = *std::move(next);
    }
  }

  // The components that `start` has, from its values.
  Result FromModel(NoiseModel start) {
    std::vector<NoiseComponent> components;
    if (sampling_.has_velocity && start.velocity.coloured.IsPresent()) {
      components.push_back(NoiseComponent::kVelocityColour);
    }
    if (sampling_.has_displacement && start.displacement.coloured.IsPresent()) {
      components.push_back(NoiseComponent::kDisplacementColour);
    }
    if (start.disturbance.IsPresent()) components.push_back(NoiseComponent::kDisturbance);
    start.damping_rate = options_.damping_rate;
    const NoiseStructure structure = Structure(std::move(components));
    return search_.From(structure, structure.Parameters(start), options_.precision);
  }

  // Noise that is coloured over hardly more than a sample, beside nearly no white noise, is about
  // white noise: a maximum of its own, from which no step leads to the other. Goes over to that one
  // where it is likelier.
  Result LikelierInWhite(Result found) {
    const NoiseModel model = found.structure.Model(found.best.parameters);
    std::optional<NoiseSearch::Point> start;
    for (SensorNoise NoiseModel::*sensor : {&NoiseModel::velocity, &NoiseModel::displacement}) {
      const SensorNoise& noise = model.*sensor;
      const bool is_nearly_white = noise.coloured.IsPresent() &&
                                   noise.coloured.time < 3.0 * sampling_.median_step &&
                                   noise.white_std < 0.3 * noise.coloured.std;
      if (!is_nearly_white) continue;
      for (const double share : {1.0, 0.8, 0.6}) {
        NoiseModel white = model;
        (white.*sensor).white_std = share * noise.coloured.std;
        (white.*sensor).coloured.std *= 0.01;
        NoiseSearch::Point point = search_.At(found.structure, found.structure.Parameters(white));
        const bool is_likelier = !start || point.value.log_likelihood > start->value.log_likelihood;
        if (is_likelier) start = std::move(point);
      }
    }
    if (!start) return found;
    Result other = search_.From(found.structure, start->parameters, options_.precision);
    return other.log_likelihood() > found.log_likelihood() ? other : found;
  }

 private:
  NoiseStructure Structure(std::vector<NoiseComponent> components) const {
    return {sampling_, std::move(components), options_.damping_rate, options_.longest_time};
  }

  // The components that are not there yet, and may be.
  std::vector<NoiseComponent> Missing(const std::vector<NoiseComponent>& present) const {
    std::vector<NoiseComponent> missing;
    const auto add = [&](NoiseComponent component) {
      const auto found = std::find(present.begin(), present.end(), component);
      if (found == present.end()) missing.push_back(component);
    };
    if (sampling_.has_velocity) add(NoiseComponent::kVelocityColour);
    if (sampling_.has_displacement) add(NoiseComponent::kDisplacementColour);
    add(NoiseComponent::kDisturbance);
    return missing;
  }

  // The best fit with one component more. The one let in last had to stand in for both: its time
  // lies between theirs. So there are two searches, with its time kept and much shorter, each from
  // the best of a grid of the new one's size and time.
  Result Extended(const Result& result, NoiseComponent component) {
    std::vector<NoiseComponent> components = result.structure.components();
    // Only the disturbance shares a channel with the others.
    const bool may_stand_in =
        !components.empty() && (component == NoiseComponent::kDisturbance ||
                                components.back() == NoiseComponent::kDisturbance);
    components.push_back(component);
    const NoiseStructure structure = Structure(std::move(components));
    std::optional<Result> best;
    for (const bool is_shorter : {false, true}) {
      if (is_shorter && !may_stand_in) break;
      Eigen::VectorXd parameters = result.best.parameters;
      if (is_shorter) parameters.tail(2) -= Eigen::Vector2d(0.7, 2.0);  // logarithms: size, time
      Result next =
          search_.From(structure, BestOfGrid(structure, parameters), kCoarser * options_.precision);
      if (!best || next.log_likelihood() > best->log_likelihood()) best = std::move(next);
    }
    return *std::move(best);
  }

  // The likeliest of several sizes and times of the last component, the rest as given.
  Eigen::VectorXd BestOfGrid(const NoiseStructure& structure, const Eigen::VectorXd& rest) {
    const Eigen::Index m = structure.num_parameters();
    const double shortest = structure.lower()[m - 1], longest = structure.upper()[m - 1];
    std::optional<NoiseSearch::Point> best;
    for (const double ratio : {0.25, 1.0}) {
      for (const double share : {0.15, 0.4, 0.65, 0.9}) {
        Eigen::VectorXd parameters(m);
        parameters << rest, std::log(ratio), shortest + share * (longest - shortest);
        parameters = parameters.cwiseMax(structure.lower()).cwiseMin(structure.upper());
        NoiseSearch::Point point = search_.At(structure, std::move(parameters));
        if (!best || point.value.log_likelihood > best->value.log_likelihood) {
          best = std::move(point);
        }
      }
    }
    return best->parameters;
  }

  // What a component must add to the log-likelihood to be let in: by AIC half of what that asks for
  // its two parameters.
  double Price() const {
    return options_.selection == NoiseSelection::kAic ? 2.0
                                                      : -std::numeric_limits<double>::infinity();
  }

  const RestrictedLikelihood& likelihood_;
  const NoiseSampling& sampling_;
  const FitNoiseOptions& options_;
  NoiseSearch search_;
};

// Whether a design hardly matters to what the noise consists of.
bool ArePlenty(std::span<const NoiseSample> samples,
               const Eigen::Ref<const RowMajorMatrix>& design) {
  constexpr Eigen::Index kSamplesPerColumn = 40;
  return std::ssize(samples) >= kSamplesPerColumn * design.cols();
}

// The components are chosen with the residual alone, and fitted with the design: its columns are
// what takes the time, and choosing takes many looks.
NoiseFit FitBegunAlone(std::span<const NoiseSample> samples,
                       std::span<const double> residual,
                       const Eigen::Ref<const RowMajorMatrix>& design,
                       FitNoiseOptions options) {
  const NoiseFit alone = FitNoise(samples, residual, RowMajorMatrix(design.rows(), 0), options);
  if (!std::isfinite(alone.log_likelihood)) return alone;
  options.start = alone.model;
  NoiseFit fit = FitNoise(samples, residual, design, options);
  fit.num_evaluations += alone.num_evaluations;
  return fit;
}

}  // namespace

std::vector<std::string> FitNoiseOptions::Problems() const {
  std::vector<std::string> problems;
  if (!(damping_rate > 0.0)) problems.push_back("damping_rate must be above 0.");
  if (!(longest_time > 0.0)) problems.push_back("longest_time must be above 0.");
  if (!(precision > 0.0)) problems.push_back("precision must be above 0.");
  if (start && start->velocity.white_std <= 0.0 && start->displacement.white_std <= 0.0) {
    problems.push_back("start must have white noise.");
  }
  return problems;
}

NoiseFit FitNoise(std::span<const NoiseSample> samples,
                  std::span<const double> residual,
                  const Eigen::Ref<const RowMajorMatrix>& design,
                  const FitNoiseOptions& options) {
  if (!options.start && design.cols() > 0 && ArePlenty(samples, design)) {
    return FitBegunAlone(samples, residual, design, options);
  }
  NoiseFit fit;
  const std::vector<std::string> problems = options.Problems();
  if (!problems.empty()) {
    fit.message = problems.front();
    return fit;
  }
  const RestrictedLikelihood likelihood(samples, residual, design);
  const NoiseSampling sampling(samples);
  constexpr int kLeastFreedom = 20;
  const int num_free = static_cast<int>(samples.size()) - likelihood.rank();
  if (num_free < kLeastFreedom || !(sampling.median_step > 0.0)) {
    fit.message = "Too few samples for a noise model: " + std::to_string(samples.size()) +
                  " for a design of rank " + std::to_string(likelihood.rank()) + ".";
    return fit;
  }
  const bool is_silent =
      (sampling.has_velocity && !(likelihood.RootMeanSquare(NoiseChannel::kVelocity) > 0.0)) ||
      (sampling.has_displacement &&
       !(likelihood.RootMeanSquare(NoiseChannel::kDisplacement) > 0.0));
  if (is_silent) {
    fit.message = "A channel of the residual is zero throughout, or not a number.";
    return fit;
  }
  Fitting fitting(likelihood, sampling, options);
  Result result = options.start ? fitting.FromModel(*options.start) : fitting.FromNothing();
  if (options.is_thorough) result = fitting.LikelierInWhite(std::move(result));
  fit.converged = result.converged && std::isfinite(result.log_likelihood());
  fit.message = fit.converged ? "Converged." : "No maximum of the likelihood was reached.";
  fit.model = Scaled(result.structure.Model(result.best.parameters), result.best.value.factor);
  fit.log_likelihood = result.log_likelihood();
  fit.num_parameters = result.structure.num_parameters() + 1;
  fit.num_evaluations = fitting.num_evaluations();
  return fit;
}

}  // namespace fathom
