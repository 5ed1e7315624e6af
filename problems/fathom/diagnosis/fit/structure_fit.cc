// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/structure_fit.h"

#include "fathom/noise/fit_noise.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Dense>

namespace fathom {
namespace {

constexpr double kSmallestGain = 0.01;  // of chi squared, at which a search has arrived
constexpr int kMostIterations = 40;
// Of the log-likelihood. A finer search of the noise takes twice as long and ends no less often at
// a maximum that is not the greatest.
constexpr double kNoisePrecision = 0.005;
constexpr double kMostDamping = 1e10;

// All unknowns in one vector: parameters of the baseline and the effects, then the free states.
struct Unknowns {
  Eigen::VectorXd value, lower, upper;
};

int NumParameters(const ExtendedModel& model) { return EffectSimulation::NumParameters(model); }

Unknowns Pack(const TrainingData& data,
              const ExtendedModel& model,
              std::span<const InitialState> initial) {
  const int num_parameters = NumParameters(model);
  const int size = num_parameters + data.num_states(model) * static_cast<int>(initial.size());
  const std::vector<Excess> excesses = EffectSimulation::ExcessesOf(model);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Unknowns unknowns = {Eigen::VectorXd(size),
                       Eigen::VectorXd::Constant(size, -kInfinity),
                       Eigen::VectorXd::Constant(size, kInfinity)};
  unknowns.value.head<kNumParameters>() = ToVector(model.baseline);
  unknowns.lower[kInertia] = data.least_inertia();
  unknowns.lower[kQuadraticDamping] = unknowns.lower[kLinearDamping] = 0.0;
  int i = kNumParameters;
  for (const ActiveEffect& active : model.effects) {
    for (size_t k = 0; k < active.values.size(); ++k, ++i) {
      const EffectParameter& parameter = active.effect->info().parameters[k];
      unknowns.value[i] = active.values[k];
      unknowns.lower[i] = parameter.lower;
      unknowns.upper[i] = parameter.upper;
    }
  }
  for (const InitialState& state : initial) {
    unknowns.value[i++] = state.velocity;
    if (data.has_displacement()) unknowns.value[i++] = state.position;
    for (const Excess excess : excesses) unknowns.value[i++] = state.*excess;
  }
  return unknowns;
}

void Unpack(const TrainingData& data,
            const Eigen::VectorXd& value,
            ExtendedModel* model,
            std::vector<InitialState>* initial) {
  model->baseline = ModelFromVector(value.head<kNumParameters>());
  int i = kNumParameters;
  for (ActiveEffect& active : model->effects) {
    for (double& number : active.values) number = value[i++];
  }
  const std::vector<Excess> excesses = EffectSimulation::ExcessesOf(*model);
  for (InitialState& state : *initial) {
    const double velocity = value[i++];
    state = {velocity, data.has_displacement() ? value[i++] : state.position};
    for (const Excess excess : excesses) state.*excess = value[i++];
  }
}

// Normal equations of the whitened problem.
struct Normal {
  Eigen::MatrixXd A;
  Eigen::VectorXd g;  // J' r: downhill
};

Normal NormalOf(const Whitener& whitener,
                const RowMajorMatrix& jacobian,
                const Eigen::VectorXd& residual) {
  RowMajorMatrix whitened(jacobian.rows(), jacobian.cols() + 1);
  whitened.leftCols(jacobian.cols()) = jacobian;
  whitened.rightCols(1) = residual;
  whitener.Apply(whitened, whitened);
  const auto J = whitened.leftCols(jacobian.cols());
  return {J.transpose() * J, J.transpose() * whitened.rightCols(1)};
}

double ChiSquared(const Whitener& whitener, const Eigen::VectorXd& residual) {
  Eigen::VectorXd whitened(residual.size());
  whitener.Apply(std::span(residual.data(), residual.size()),
                 std::span(whitened.data(), whitened.size()));
  return whitened.squaredNorm();
}

std::vector<int> FreeOf(const Unknowns& unknowns, const Eigen::VectorXd& downhill) {
  std::vector<int> free;
  for (int i = 0; i < unknowns.value.size(); ++i) {
    const bool presses_low = unknowns.value[i] <= unknowns.lower[i] && downhill[i] <= 0.0;
    const bool presses_high = unknowns.value[i] >= unknowns.upper[i] && downhill[i] >= 0.0;
    if (!presses_low && !presses_high) free.push_back(i);
  }
  return free;
}

// The damped step of the free unknowns; the others stay.
Eigen::VectorXd StepOf(const Normal& normal, const std::vector<int>& free, double damping) {
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd A(n, n);
  Eigen::VectorXd g(n), scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    scale[i] = 1.0 / std::sqrt(std::max(normal.A(free[i], free[i]), 1e-300));
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    g[i] = scale[i] * normal.g[free[i]];
    for (Eigen::Index j = 0; j < n; ++j) {
      A(i, j) = scale[i] * scale[j] * normal.A(free[i], free[j]);
    }
    A(i, i) += damping + 1e-12;
  }
  const Eigen::VectorXd solved = A.ldlt().solve(g);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(normal.g.size());
  for (Eigen::Index i = 0; i < n; ++i) step[free[i]] = scale[i] * solved[i];
  return step;
}

// The scaled pseudo-inverse of the normal matrix of some unknowns, and for each the share of it
// that the data tell: 1, or less where a combination with others leaves no trace.
struct Inverse {
  Eigen::MatrixXd covariance;
  Eigen::VectorXd told;
};

Inverse InverseOf(const Normal& normal, const std::vector<int>& some) {
  const auto n = static_cast<Eigen::Index>(some.size());
  Eigen::MatrixXd A(n, n);
  Eigen::VectorXd scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    scale[i] = 1.0 / std::sqrt(std::max(normal.A(some[i], some[i]), 1e-300));
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      A(i, j) = scale[i] * scale[j] * normal.A(some[i], some[j]);
    }
  }
  const Eigen::MatrixXd inverse = A.completeOrthogonalDecomposition().pseudoInverse();
  return {(scale * scale.transpose()).cwiseProduct(inverse), (inverse * A).diagonal()};
}

// Inverse of the normal matrix of the free unknowns, its leading parameters. A parameter that is
// held has the variance it would have without its bound; NaN where the data then tell nothing of
// it.
Eigen::MatrixXd CovarianceOf(const Normal& normal,
                             const std::vector<int>& free,
                             int num_parameters) {
  const auto n = static_cast<Eigen::Index>(free.size());
  const Eigen::MatrixXd of_free = InverseOf(normal, free).covariance;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(num_parameters, num_parameters);
  for (Eigen::Index i = 0; i < n && free[i] < num_parameters; ++i) {
    for (Eigen::Index j = 0; j < n && free[j] < num_parameters; ++j) {
      covariance(free[i], free[j]) = of_free(i, j);
    }
  }
  if (n == normal.g.size()) return covariance;
  constexpr double kTold = 0.999;
  std::vector<int> all(normal.g.size());
  std::iota(all.begin(), all.end(), 0);
  const Inverse of_all = InverseOf(normal, all);
  for (int i = 0; i < num_parameters; ++i) {
    if (std::count(free.begin(), free.end(), i) > 0) continue;
    covariance(i, i) =
        of_all.told[i] > kTold ? of_all.covariance(i, i) : std::numeric_limits<double>::quiet_NaN();
  }
  return covariance;
}

// StructureFit::start_gains of a fit.
std::vector<double> StartGainsOf(const TrainingData& data,
                                 const StructureFit& fit,
                                 const Normal& normal,
                                 const std::vector<int>& free) {
  std::vector<double> gains;
  const std::vector<Excess> excesses = EffectSimulation::ExcessesOf(fit.model);
  if (excesses.empty()) return gains;
  const auto size = static_cast<int>(normal.g.size());
  const Eigen::VectorXd variance = CovarianceOf(normal, free, size).diagonal();
  int next = NumParameters(fit.model);
  for (const InitialState& state : fit.initial) {
    next += data.num_states(fit.model);
    int i = next - static_cast<int>(excesses.size());
    for (const Excess excess : excesses) {
      const double value = state.*excess;
      gains.push_back(variance[i] > 0.0 ? value * value / variance[i] : 0.0);
      ++i;
    }
  }
  return gains;
}

// Fills residual and Jacobian of a fit at its model; no Jacobian if it cannot be simulated.
bool LineariseAt(const TrainingData& data, StructureFit* fit) {
  auto at = data.Linearise(fit->model, fit->initial);
  fit->jacobian = at ? std::move(at->jacobian) : RowMajorMatrix();
  if (at) fit->residual = data.measured() - at->simulated;
  return at.has_value();
}

// Searches on from a fit whose residual and Jacobian are those of its model.
StructureFit SearchFrom(const TrainingData& data,
                        StructureFit fit,
                        const Whitener& whitener,
                        double smallest_share) {
  fit.converged = false;
  Unknowns unknowns = Pack(data, fit.model, fit.initial);
  fit.chi_squared = ChiSquared(whitener, fit.residual);
  Normal normal = NormalOf(whitener, fit.jacobian, fit.residual);
  double damping = 1e-4;
  for (int iteration = 0; iteration < kMostIterations && !fit.converged; ++iteration) {
    const std::vector<int> free = FreeOf(unknowns, normal.g);
    bool moved = false;
    double growth = 10.0;  // faster each time: where nothing is lower, that is soon known
    while (!moved && !fit.converged && damping < kMostDamping) {
      const Eigen::VectorXd step = StepOf(normal, free, damping);
      const Eigen::VectorXd value =
          (unknowns.value + step).cwiseMax(unknowns.lower).cwiseMin(unknowns.upper);
      const Eigen::VectorXd way = value - unknowns.value;
      const double promised = 2.0 * normal.g.dot(way) - way.dot(normal.A * way);
      if (!(std::abs(promised) > std::max(kSmallestGain, smallest_share * fit.chi_squared))) {
        fit.converged = true;
        break;
      }
      ExtendedModel model = fit.model;
      std::vector<InitialState> states = fit.initial;
      Unpack(data, value, &model, &states);
      const auto simulated = data.Simulate(model, states);
      const double chi_squared = simulated ? ChiSquared(whitener, data.measured() - *simulated)
                                           : std::numeric_limits<double>::infinity();
      if (!(chi_squared < fit.chi_squared)) {
        damping *= growth;
        growth *= 2.0;
        continue;
      }
      moved = true;
      const double gained = fit.chi_squared - chi_squared;
      damping = std::max(1e-9, gained > 0.5 * promised ? 0.1 * damping : damping);
      unknowns.value = value;
      fit.model = std::move(model);
      fit.initial = std::move(states);
    }
    if (!moved) {
      fit.converged = true;  // nowhere lower, as far as the arithmetic can tell
      break;
    }
    if (!LineariseAt(data, &fit)) return fit;
    fit.chi_squared = ChiSquared(whitener, fit.residual);
    normal = NormalOf(whitener, fit.jacobian, fit.residual);
  }
  const std::vector<int> free = FreeOf(unknowns, normal.g);
  const int num_parameters = NumParameters(fit.model);
  fit.covariance = CovarianceOf(normal, free, num_parameters);
  fit.start_gains = StartGainsOf(data, fit, normal, free);
  fit.is_on_bound.assign(num_parameters, true);
  for (const int i : free) {
    if (i < num_parameters) fit.is_on_bound[i] = false;
  }
  fit.log_likelihood = whitener.LogLikelihood(std::span(fit.residual.data(), fit.residual.size()));
  return fit;
}

}  // namespace

double PriceOfStarts(const TrainingData& data, const StructureFit& fit) {
  const double most = std::log(static_cast<double>(data.bins().size()));
  double price = 0.0;
  for (const double gain : fit.start_gains) price += std::min(gain, most);
  return price;
}

StructureFit FitStructure(const TrainingData& data,
                          const ExtendedModel& start,
                          std::span<const InitialState> initial,
                          const Whitener& whitener,
                          double smallest_share) {
  StructureFit fit;
  fit.model = start;
  fit.initial.assign(initial.begin(), initial.end());
  const Unknowns unknowns = Pack(data, start, initial);
  Unpack(data,
         unknowns.value.cwiseMax(unknowns.lower).cwiseMin(unknowns.upper),
         &fit.model,
         &fit.initial);
  if (!LineariseAt(data, &fit)) return fit;
  return SearchFrom(data, std::move(fit), whitener, smallest_share);
}

NoiseModel LearnNoise(const TrainingData& data,
                      const StructureFit& fit,
                      const std::optional<NoiseModel>& start) {
  FitNoiseOptions options;
  options.damping_rate = data.DampingRate(fit.model.baseline);
  options.start = start;
  options.precision = kNoisePrecision;
  const NoiseFit learned = FitNoise(
      data.samples(), std::span(fit.residual.data(), fit.residual.size()), fit.jacobian, options);
  // Too few samples, or a channel without any error.
  if (!std::isfinite(learned.log_likelihood)) return SensorNoiseOnly(data, fit.residual);
  return learned.model;
}

NoiseModel SensorNoiseOnly(const TrainingData& data, const Eigen::VectorXd& residual) {
  NoiseModel noise;
  for (const NoiseChannel channel : {NoiseChannel::kVelocity, NoiseChannel::kDisplacement}) {
    std::vector<double> values, factors;
    for (int i = 0; i < data.bins().size(); ++i) {
      if (data.samples()[i].channel != channel) continue;
      values.push_back(residual[i]);
      factors.push_back(data.samples()[i].variance_factor);
    }
    // Of one or two the values themselves.
    double sum = 0.0, count = 6.0 * (static_cast<double>(values.size()) - 2.0);
    for (size_t i = 2; i < values.size(); ++i) {
      const double d = values[i] - 2.0 * values[i - 1] + values[i - 2];
      sum += d * d * 6.0 / (factors[i - 2] + 4.0 * factors[i - 1] + factors[i]);
    }
    if (values.size() < 3) {
      count = std::max<double>(1.0, static_cast<double>(values.size()));
      for (const double value : values) sum += value * value;
    }
    const double std = std::sqrt(sum / count);
    (channel == NoiseChannel::kVelocity ? noise.velocity : noise.displacement).white_std =
        std::max(std, 1e-12);
  }
  return noise;
}

StructureFit FitBaseline(const TrainingData& data,
                         const ExtendedModel& start,
                         std::span<const InitialState> initial) {
  const auto simulated = data.Simulate(start, initial);
  if (!simulated) return {};
  const Whitener sensor(SensorNoiseOnly(data, data.measured() - *simulated), data.samples());
  const StructureFit first = FitStructure(data, start, initial, sensor);
  if (first.jacobian.size() == 0) return first;
  return FitStructureAndNoise(data, first);
}

NoiseModel WhiteNoise(const TrainingData& data, const Eigen::VectorXd& residual) {
  double velocity = 0.0, displacement = 0.0;
  int num_velocities = 0, num_displacements = 0;
  for (int i = 0; i < data.bins().size(); ++i) {
    const bool is_velocity = data.samples()[i].channel == NoiseChannel::kVelocity;
    (is_velocity ? velocity : displacement) +=
        residual[i] * residual[i] / data.samples()[i].variance_factor;
    ++(is_velocity ? num_velocities : num_displacements);
  }
  NoiseModel noise;
  noise.velocity.white_std = std::max(1e-12, std::sqrt(velocity / std::max(1, num_velocities)));
  noise.displacement.white_std =
      std::max(1e-12, std::sqrt(displacement / std::max(1, num_displacements)));
  return noise;
}

StructureFit FitStates(const TrainingData& data,
                       const ExtendedModel& model,
                       std::span<const InitialState> initial) {
  StructureFit fit;
  fit.model = model;
  fit.initial.assign(initial.begin(), initial.end());
  if (!LineariseAt(data, &fit)) return fit;
  constexpr int kNumSteps = 3;
  const Eigen::Index num_parameters = NumParameters(model);
  for (int step = 0; step < kNumSteps; ++step) {
    const Whitener white(WhiteNoise(data, fit.residual), data.samples());
    const Normal normal =
        NormalOf(white, fit.jacobian.rightCols(fit.jacobian.cols() - num_parameters), fit.residual);
    Unknowns unknowns = Pack(data, fit.model, fit.initial);
    unknowns.value.tail(normal.g.size()) += normal.A.ldlt().solve(normal.g);
    Unpack(data, unknowns.value, &fit.model, &fit.initial);
    if (!LineariseAt(data, &fit)) break;
  }
  return fit;
}

NoiseModel FirstNoise(const TrainingData& data, const StructureFit& fit) {
  return LearnNoise(data, fit, std::nullopt);
}

namespace {

// Learns noise and parameters in turn, from a fit under a first noise.
StructureFit LearnOn(const TrainingData& data, StructureFit fit, NoiseModel noise) {
  constexpr int kMostTurns = 5;
  double previous = -std::numeric_limits<double>::infinity();
  for (int turn = 0; fit.jacobian.size() > 0; ++turn) {
    fit.noise = noise;
    if (fit.log_likelihood < previous + 0.1 || turn + 1 == kMostTurns) break;
    previous = fit.log_likelihood;
    noise = LearnNoise(data, fit, noise);
    fit = SearchFrom(data, std::move(fit), Whitener(noise, data.samples()), 0.0);
  }
  return fit;
}

}  // namespace

StructureFit FitStructureAndNoise(const TrainingData& data,
                                  const ExtendedModel& start,
                                  std::span<const InitialState> initial,
                                  const NoiseModel& noise) {
  return LearnOn(data, FitStructure(data, start, initial, Whitener(noise, data.samples())), noise);
}

StructureFit FitStructureAndNoise(const TrainingData& data, const StructureFit& start) {
  const NoiseModel noise = FirstNoise(data, start);
  return LearnOn(data, SearchFrom(data, start, Whitener(noise, data.samples()), 0.0), noise);
}

}  // namespace fathom
