// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/process_fit.h"

#include "fathom/joint_refinement/search/process_likelihood.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Dense>

namespace fathom {
namespace {

// The symmetric matrix with its eigenvalues at least `least`, inverted.
Eigen::MatrixXd InverseOf(const Eigen::MatrixXd& information, double least) {
  const SymmetricEigen eigen = EigenOf(information);
  const Eigen::VectorXd inverse = eigen.values.cwiseMax(least).cwiseInverse();
  return eigen.vectors * inverse.asDiagonal() * eigen.vectors.transpose();
}

// Quasi-Newton ascent (BFGS) in the metric of the complete information, which is an upper bound of
// the curvature: its first steps are those of the EM algorithm.
ProcessFit Maximise(std::span<const LinearSegment> segments,
                    std::span<const GlobalsPrior> priors,
                    const ProcessSet& start,
                    int excited) {
  constexpr int kMostIterations = 60;
  constexpr int kNumEmSteps = 3;    // before BFGS learns
  constexpr double kLongest = 1.0;  // change of a logarithm in a step
  constexpr double kEnough = 0.02;  // expected gain of log-likelihood
  const ProcessParameters parameters(start);
  const ProcessLikelihood likelihood(segments, priors, parameters, excited);
  Eigen::VectorXd x = parameters.ToVector();
  ProcessLikelihood::Value now = likelihood.At(x, true);
  ProcessFit fit;
  fit.processes = start;
  if (!now.is_usable) return fit;
  Eigen::MatrixXd inverse = InverseOf(now.complete_information, 1e-2);
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    Eigen::VectorXd step = inverse * now.slope;
    if (0.5 * step.dot(now.slope) < kEnough) {
      fit.converged = true;
      break;
    }
    const double longest = step.cwiseAbs().maxCoeff();
    if (longest > kLongest) step *= kLongest / longest;
    const bool is_em = iteration < kNumEmSteps;
    ProcessLikelihood::Value next;
    constexpr int kMostHalvings = 8;
    int halvings = 0;
    for (; halvings < kMostHalvings; ++halvings, step *= 0.4) {
      next = likelihood.At(x + step, is_em, now.value + 1e-4 * step.dot(now.slope));
      if (next.is_usable) break;
    }
    if (halvings == kMostHalvings) {
      // No ascent along a direction of ascent: good enough if little was to be gained.
      fit.converged =
          0.5 * now.slope.dot(InverseOf(now.complete_information, 1e-2) * now.slope) < 1.0;
      break;
    }
    x += step;
    if (is_em) {
      inverse = InverseOf(next.complete_information, 1e-2);
    } else {
      const Eigen::VectorXd y = now.slope - next.slope;
      const double curvature = y.dot(step);
      if (curvature > 1e-10) {
        const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(x.size(), x.size());
        const Eigen::MatrixXd left = I - step * y.transpose() / curvature;
        inverse = left * inverse * left.transpose() + step * step.transpose() / curvature;
      }
      next.complete_information = now.complete_information;
    }
    now = next;
  }
  fit.processes = parameters.FromVector(x);
  fit.log_likelihood = LinearJoint(segments, priors, fit.processes, excited).log_likelihood();
  fit.num_evaluations = likelihood.num_evaluations() + 1;
  return fit;
}

// Standard deviation that explains an estimate `c` of covariance T best as a draw from a zero-mean
// normal distribution plus its error, and what log-likelihood that gains over none.
struct Spread {
  double std = 0.0;
  double gain = 0.0;
};
using Coefficients = Eigen::Vector<double, kNumRegressors>;
using CoefficientCovariance = Eigen::Matrix<double, kNumRegressors, kNumRegressors>;
Spread SpreadOf(const Coefficients& c, const CoefficientCovariance& T) {
  const auto log_density = [&](double std) {
    const Eigen::LLT<CoefficientCovariance> S(T + std * std * CoefficientCovariance::Identity());
    return -S.matrixLLT().diagonal().array().log().sum() - 0.5 * c.dot(S.solve(c));
  };
  Spread best;
  const double none = log_density(0.0);
  for (double std = 10.0; std > 1e-6; std *= 0.8) {
    const double gain = log_density(std) - none;
    if (gain > best.gain) best = {std, gain};
  }
  return best;
}

// Responses that the data ask for beyond those that are there, each with its spread.
bool AddResponses(std::span<const LinearSegment> segments,
                  std::span<const GlobalsPrior> priors,
                  int excited,
                  ProcessSet* processes) {
  ProcessSet free = *processes;
  constexpr double kAnything = 1.0;  // [m] or [rad]
  for (double& std : free.response_std) {
    if (std == 0.0) std = kAnything;
  }
  const LinearJoint joint(segments, priors, free, excited);
  if (!joint.is_usable()) return false;
  bool is_changed = false;
  for (int j = 0; j < kNumHeld; ++j) {
    if (processes->response_std[j] > 0.0) continue;
    Spread best;
    for (size_t r = 0; r < segments.size(); ++r) {
      const int first = kResponseColumns + j * kResponseTerms + 1;
      const Coefficients c =
          segments[r].response.segment<kNumRegressors>(first - kResponseColumns) +
          joint.change(r).segment<kNumRegressors>(first);
      const Spread spread =
          SpreadOf(c, joint.covariance(r).block<kNumRegressors, kNumRegressors>(first, first));
      if (spread.gain > best.gain) best = spread;
    }
    constexpr double kWorthATrial = 1.0;  // whether it stays, all segments together say
    if (best.gain < kWorthATrial) continue;
    processes->response_std[j] = best.std;
    is_changed = true;
  }
  return is_changed;
}

}  // namespace

ProcessFit FitProcesses(std::span<const LinearSegment> segments,
                        std::span<const GlobalsPrior> priors,
                        const ProcessSet& start,
                        int excited) {
  int num_evaluations = 0;
  ProcessFit fit;
  const auto maximise = [&](const ProcessSet& from) {
    fit = Maximise(segments, priors, from, excited);
    num_evaluations += fit.num_evaluations;
    fit.num_evaluations = num_evaluations;
    return std::isfinite(fit.log_likelihood);
  };
  ProcessSet from = start;
  AddResponses(segments, priors, excited, &from);
  if (!maximise(from)) return fit;
  if (AddResponses(segments, priors, excited, &fit.processes) && !maximise(fit.processes))
    return fit;

  bool is_changed = false;
  const auto try_without = [&](const std::function<void(ProcessSet*)>& remove) {
    // A response or a model error that is not there widens the intervals several times over, and at
    // a price of one chance keeps one in every tenth log or so. A wander has three parameters.
    constexpr double kPrice = 3.0;
    ProcessSet without = fit.processes;
    remove(&without);
    const double value = LinearJoint(segments, priors, without, excited).log_likelihood();
    ++num_evaluations;
    if (!(value > fit.log_likelihood - kPrice)) return;
    fit.processes = without;
    fit.log_likelihood = value;
    is_changed = true;
  };
  if (fit.processes.model_error > 0.0) {
    try_without([](ProcessSet* set) { set->model_error = 0.0; });
  }
  for (int j = 0; j < kNumHeld; ++j) {
    if (fit.processes.response_std[j] == 0.0) continue;
    try_without([&](ProcessSet* set) { set->response_std[j] = 0.0; });
  }
  for (int j = 0; j < kNumHeld; ++j) {
    if (!fit.processes.wander[j].IsPresent()) continue;
    try_without([&](ProcessSet* set) { set->wander[j].std = 0.0; });
  }
  if (is_changed) maximise(fit.processes);
  return fit;
}

}  // namespace fathom
