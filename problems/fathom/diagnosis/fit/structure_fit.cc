// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/structure_fit.h"

#include "fathom/diagnosis/fit/normal_equations.h"
#include "fathom/diagnosis/fit/start_price.h"
#include "fathom/diagnosis/fit/unknowns.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

constexpr std::size_t kMostIterations = 100;
constexpr double kMostDamping = 1e10;

// A search that after some steps gains less than a share of the error over the last ones creeps.
constexpr std::size_t kCreepAfter = 30;
constexpr std::size_t kCreepOver = 10;
constexpr double kCreepShare = 0.003;

// A search that is not there after so many steps follows a valley that bends: steps bend with it.
constexpr std::size_t kStraightSteps = 5;
constexpr double kProbe = 0.1;      // of a step, by which its bend is measured
constexpr double kMostBend = 0.75;  // of a step's length

double ChiSquared(const Whitener& whitener, const Eigen::VectorXd& residual) {
  Eigen::VectorXd whitened(residual.size());
  whitener.Apply(std::span(residual.data(), residual.size()),
                 std::span(whitened.data(), whitened.size()));
  return whitened.squaredNorm();
}

// Fills residual and Jacobian of a fit at its model; no Jacobian if it cannot be simulated.
bool LineariseAt(const TrainingData& data, StructureFit* fit) {
  auto at = data.Linearise(fit->model, fit->initial);
  fit->jacobian = at ? std::move(at->jacobian) : RowMajorMatrix();
  if (at) fit->residual = data.measured() - at->simulated;
  return at.has_value();
}

// Where a search stands.
struct Descent {
  StructureFit fit;
  Unknowns unknowns;
  Normal normal;
  double damping = 1e-4;
  bool was_refused = false;  // some step that was tried before the last one taken
  bool bends = false;        // its steps
};

// How far a step has to bend for the residual to stay as a straight model has it: geodesic
// acceleration, M. K. Transtrum and J. P. Sethna, arXiv:1201.5885. Zero where it bends too much, or
// cannot be told.
Eigen::VectorXd BendOf(const TrainingData& data,
                       const Whitener& whitener,
                       const Descent& at,
                       const std::vector<int>& free,
                       const Eigen::VectorXd& step) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(step.size());
  StructureFit probe;
  probe.model = at.fit.model;
  probe.initial = at.fit.initial;
  Unpack(
      data,
      (at.unknowns.value + kProbe * step).cwiseMax(at.unknowns.lower).cwiseMin(at.unknowns.upper),
      &probe.model,
      &probe.initial);
  const auto simulated = data.Simulate(probe.model, probe.initial);
  if (!simulated) return none;
  const Eigen::VectorXd residual = data.measured() - *simulated;
  const Eigen::VectorXd second =
      2.0 / (kProbe * kProbe) * (residual - at.fit.residual + kProbe * at.fit.jacobian * step);
  const Normal normal{at.normal.A, NormalOf(whitener, at.fit.jacobian, second).g};
  const Eigen::VectorXd bend = 0.5 * StepOf(normal, free, at.damping);
  const auto length = [&](const Eigen::VectorXd& way) {
    return std::sqrt(way.cwiseAbs2().dot(at.normal.A.diagonal()));
  };
  return 2.0 * length(bend) <= kMostBend * length(step) ? bend : none;
}

// Runs a trial with its derivatives and fills its error, if that is below `most`. Without
// derivatives a run costs a sixth: it goes first where the trial is not likely to be lower.
bool IsLower(const TrainingData& data,
             const Whitener& whitener,
             double most,
             bool is_likely,
             StructureFit* trial) {
  if (!is_likely) {
    const auto simulated = data.Simulate(trial->model, trial->initial);
    if (!simulated || !(ChiSquared(whitener, data.measured() - *simulated) < most)) return false;
  }
  if (!LineariseAt(data, trial)) return false;
  trial->chi_squared = ChiSquared(whitener, trial->residual);
  return trial->chi_squared < most;
}

// Takes the first step that lowers the error, damped as much as that needs. False where no step
// promises enough, or, as far as the arithmetic can tell, none leads lower.
bool StepDown(const TrainingData& data,
              const Whitener& whitener,
              const FitPrecision& precision,
              Descent* at) {
  const std::vector<int> free = FreeOf(at->unknowns, at->normal.g);
  double growth = 10.0;  // faster each time: where nothing is lower, that is soon known
  bool is_refused = false;
  while (at->damping < kMostDamping) {
    const Eigen::VectorXd step = StepOf(at->normal, free, at->damping);
    Eigen::VectorXd value =
        (at->unknowns.value + step).cwiseMax(at->unknowns.lower).cwiseMin(at->unknowns.upper);
    const Eigen::VectorXd way = value - at->unknowns.value;
    const double promised = 2.0 * at->normal.g.dot(way) - way.dot(at->normal.A * way);
    const double enough = std::max(precision.gain, precision.share * at->fit.chi_squared);
    if (!(std::abs(promised) > enough)) return false;
    if (at->bends) {
      value = (value + BendOf(data, whitener, *at, free, way))
                  .cwiseMax(at->unknowns.lower)
                  .cwiseMin(at->unknowns.upper);
    }
    StructureFit next;
    next.model = at->fit.model;
    next.initial = at->fit.initial;
    next.noise = at->fit.noise;
    Unpack(data, value, &next.model, &next.initial);
    const bool is_likely = !is_refused && !at->was_refused;
    if (!IsLower(data, whitener, at->fit.chi_squared, is_likely, &next)) {
      at->damping *= growth;
      growth *= 2.0;
      is_refused = true;
      continue;
    }
    const double gained = at->fit.chi_squared - next.chi_squared;
    at->damping = std::max(1e-9, gained > 0.5 * promised ? 0.1 * at->damping : at->damping);
    at->was_refused = is_refused;
    at->unknowns.value = value;
    at->normal = NormalOf(whitener, next.jacobian, next.residual);
    at->fit = std::move(next);
    return true;
  }
  return false;
}

// Whether the last steps lead nowhere soon: along a valley that bends.
bool Creeps(std::span<const double> errors) {
  return errors.size() > kCreepAfter &&
         errors[errors.size() - 1 - kCreepOver] < (1.0 + kCreepShare) * errors.back();
}

// What a search says of where it ended.
StructureFit Concluded(const TrainingData& data, Descent end, const Whitener& whitener) {
  StructureFit fit = std::move(end.fit);
  const std::vector<int> free = FreeOf(end.unknowns, end.normal.g);
  const int num_parameters = EffectSimulation::NumParameters(fit.model);
  fit.covariance = CovarianceOf(end.normal, free, num_parameters);
  fit.start_gains.clear();
  if (!EffectSimulation::ExcessesOf(fit.model).empty()) {
    const auto size = static_cast<int>(end.normal.g.size());
    fit.start_gains =
        StartGainsOf(data, fit.model, fit.initial, CovarianceOf(end.normal, free, size).diagonal());
  }
  fit.is_on_bound.assign(num_parameters, true);
  for (const int i : free) {
    if (i < num_parameters) fit.is_on_bound[i] = false;
  }
  fit.log_likelihood = whitener.LogLikelihood(std::span(fit.residual.data(), fit.residual.size()));
  return fit;
}

}  // namespace

StructureFit FitStructure(const TrainingData& data,
                          StructureFit start,
                          const Whitener& whitener,
                          const FitPrecision& precision) {
  Descent at;
  at.fit = std::move(start);
  at.fit.converged = false;
  at.unknowns = Pack(data, at.fit.model, at.fit.initial);
  at.fit.chi_squared = ChiSquared(whitener, at.fit.residual);
  at.normal = NormalOf(whitener, at.fit.jacobian, at.fit.residual);
  std::vector<double> errors = {at.fit.chi_squared};
  while (errors.size() <= kMostIterations && !at.fit.converged && !Creeps(errors)) {
    at.bends = errors.size() > kStraightSteps;
    at.fit.converged = !StepDown(data, whitener, precision, &at);
    errors.push_back(at.fit.chi_squared);
  }
  return Concluded(data, std::move(at), whitener);
}

StructureFit FitStructure(const TrainingData& data,
                          const ExtendedModel& start,
                          std::span<const InitialState> initial,
                          const Whitener& whitener,
                          const FitPrecision& precision) {
  StructureFit fit;
  fit.model = start;
  fit.initial.assign(initial.begin(), initial.end());
  const Unknowns unknowns = Pack(data, start, initial);
  Unpack(data,
         unknowns.value.cwiseMax(unknowns.lower).cwiseMin(unknowns.upper),
         &fit.model,
         &fit.initial);
  if (!LineariseAt(data, &fit)) return fit;
  return FitStructure(data, std::move(fit), whitener, precision);
}

}  // namespace fathom
