// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/process_likelihood.h"

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Dense>

namespace fathom {
namespace {

// E log density of a coordinate's states under a process, and the expected squares in it.
struct ExpectedDensity {
  double log_density = 0.0;
  double squares = 0.0;
};

ExpectedDensity DensityOf(const SecondOrderProcess& process,
                          bool is_stationary,
                          std::span<const LinearSegment> segments,
                          const std::vector<SegmentMoments>& moments,
                          int coordinate) {
  double log_determinants = 0.0;
  ExpectedDensity density;
  for (size_t r = 0; r < segments.size(); ++r) {
    for (size_t s = 0; s < segments[r].durations.size(); ++s) {
      const StepMoments& m = moments[r].steps[coordinate][s];
      const Transition t = process.Over(segments[r].durations[s]);
      const Eigen::Matrix2d cross = t.Phi * m.across.transpose();
      const Eigen::Matrix2d square =
          m.after - cross - cross.transpose() + t.Phi * m.before * t.Phi.transpose();
      log_determinants += m.count * t.log_det_Q;
      density.squares += (t.whitener * square * t.whitener.transpose()).trace();
    }
    if (!is_stationary) {
      density.squares += 2.0;  // of the first state, which its tight prior fixes
      continue;
    }
    const Eigen::Matrix2d P0 = process.StationaryCovariance();
    log_determinants += std::log(P0.determinant());
    density.squares += (P0.inverse() * moments[r].first[coordinate]).trace();
  }
  density.log_density = -0.5 * (log_determinants + density.squares);
  return density;
}

// Adds slope and minus curvature of `function` about 0 at `first`, by differences.
void Differentiate(const std::function<double(const Eigen::VectorXd&)>& function,
                   int first,
                   int size,
                   bool with_information,
                   ProcessLikelihood::Value* result) {
  constexpr double kStep = 1e-3;
  const auto at = [&](int i, double by_i, int j, double by_j) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
    x[i] += by_i * kStep;
    x[j] += by_j * kStep;
    return function(x);
  };
  const double middle = function(Eigen::VectorXd::Zero(size));
  for (int i = 0; i < size; ++i) {
    const double up = at(i, 1.0, i, 0.0), down = at(i, -1.0, i, 0.0);
    result->slope[first + i] += (up - down) / (2.0 * kStep);
    if (!with_information) continue;
    auto& information = result->complete_information;
    information(first + i, first + i) -= (up - 2.0 * middle + down) / (kStep * kStep);
    for (int j = 0; j < i; ++j) {
      const double mixed =
          (at(i, 1.0, j, 1.0) - at(i, 1.0, j, -1.0) - at(i, -1.0, j, 1.0) + at(i, -1.0, j, -1.0)) /
          (4.0 * kStep * kStep);
      information(first + i, first + j) -= mixed;
      information(first + j, first + i) -= mixed;
    }
  }
}

// A point of the likelihood, with the moments of the states there.
struct Expected {
  std::span<const LinearSegment> segments;
  const LinearJoint& joint;
  const ProcessSet& processes;
  std::vector<SegmentMoments> moments;
  bool with_information;
};

// Each of the following adds slope and information of one component to `result`, and returns the
// expected squares of its prior.

double AddModelError(const Expected& at, int excited, int index, ProcessLikelihood::Value* result) {
  const auto density = [&](const Eigen::VectorXd& log_factor) {
    SecondOrderProcess process = at.processes.ModelError();
    process.intensity *= std::exp(2.0 * log_factor[0]);
    return DensityOf(process, false, at.segments, at.moments, excited);
  };
  Differentiate([&](const Eigen::VectorXd& f) { return density(f).log_density; },
                index,
                1,
                at.with_information,
                result);
  return density(Eigen::VectorXd::Zero(1)).squares;
}

// Of held slot `j`, which is `coordinate`.
double AddWander(
    const Expected& at, int j, int coordinate, int index, ProcessLikelihood::Value* result) {
  const HeldWander w = at.processes.wander[j];
  const auto density = [&](const Eigen::VectorXd& f) {
    return DensityOf(
        SecondOrderProcess::Held(
            w.std * std::exp(f[0]), w.frequency * std::exp(f[1]), w.ratio * std::exp(f[2])),
        true,
        at.segments,
        at.moments,
        coordinate);
  };
  Differentiate([&](const Eigen::VectorXd& f) { return density(f).log_density; },
                index,
                3,
                at.with_information,
                result);
  return density(Eigen::VectorXd::Zero(3)).squares;
}

double AddResponse(const Expected& at, int j, int index, ProcessLikelihood::Value* result) {
  const double std = at.processes.response_std[j];
  double squares = 0.0, count = 0.0;
  for (size_t r = 0; r < at.segments.size(); ++r) {
    for (int term = 1; term < kResponseTerms; ++term) {
      const int column = kResponseColumns + j * kResponseTerms + term;
      const double c =
          at.segments[r].response[column - kResponseColumns] + at.joint.change(r)[column];
      squares += (c * c + at.joint.covariance(r)(column, column)) / (std * std);
      count += 1.0;
    }
  }
  result->slope[index] += squares - count;
  result->complete_information(index, index) += 2.0 * squares;
  return squares;
}

// `squares` with those of the priors that no parameter belongs to: of responses that are taken away
// and of what is known of the other globals.
double WithFixedPriors(double squares, const Expected& at, std::span<const GlobalsPrior> priors) {
  for (int column = 0; column < kNumColumns; ++column) {
    if (IsResponse(column)) {
      if (at.processes.response_std[HeldSlot(column)] > 0.0) continue;  // AddResponse()
      for (size_t r = 0; r < at.segments.size(); ++r) {
        const double before = at.segments[r].response[column - kResponseColumns];
        if (before == 0.0) continue;
        const double c = before + at.joint.change(r)[column];
        squares +=
            (c * c + at.joint.covariance(r)(column, column)) / std::pow(NoResponseStd(before), 2);
      }
      continue;
    }
    for (size_t r = 0; r < (column < kNumShared ? 1 : at.segments.size()); ++r) {
      const double std = priors[r].std[column];
      if (std == 0.0 || !std::isfinite(std)) continue;
      const double miss = priors[r].offset[column] + at.joint.change(r)[column];
      squares += (miss * miss + at.joint.covariance(r)(column, column)) / (std * std);
    }
  }
  return squares;
}

}  // namespace

ProcessLikelihood::ProcessLikelihood(std::span<const LinearSegment> segments,
                                     std::span<const GlobalsPrior> priors,
                                     const ProcessParameters& parameters,
                                     int excited)
    : segments_(segments),
      priors_(priors),
      parameters_(parameters),
      excited_(excited),
      centre_(parameters.ToVector()) {
  width_ = Eigen::VectorXd::Constant(parameters.size(), 4.0);
  width_[parameters.corner_sigma()] = std::numeric_limits<double>::infinity();
  for (int j = 0; j < kNumHeld; ++j) {
    const int i = parameters.wander(j);
    if (i < 0) continue;
    centre_[i + 1] = std::log(0.5);  // [rad/s]
    width_[i + 1] = 1.5;
    centre_[i + 2] = 0.0;  // critical damping
    width_[i + 2] = 1.0;
  }
}

ProcessLikelihood::Value ProcessLikelihood::At(const Eigen::VectorXd& x,
                                               bool with_information,
                                               double least) const {
  ++num_evaluations_;
  const int n = parameters_.size();
  Value result;
  const ProcessSet set = parameters_.FromVector(x);
  const LinearJoint joint(segments_, priors_, set, excited_);
  if (!joint.is_usable()) return result;
  const Eigen::ArrayXd z = (x - centre_).array() / width_.array();
  result.value = joint.log_likelihood() - 0.5 * z.square().sum();
  if (!(result.value > least)) return result;
  result.slope = -z / width_.array();
  result.complete_information = Eigen::MatrixXd::Zero(n, n);
  result.complete_information.diagonal() = width_.array().square().inverse();
  Expected at = {segments_, joint, set, {}, with_information};
  for (size_t r = 0; r < segments_.size(); ++r) at.moments.push_back(joint.Moments(r));

  double prior_squares = 0.0, num_rows = 0.0;
  for (const LinearSegment& segment : segments_) num_rows += segment.num_rows;
  for (int i = 0, j = 0; i < 6; ++i) {
    if (i == excited_) {
      const int index = parameters_.model_error();
      if (index >= 0) prior_squares += AddModelError(at, i, index, &result);
      continue;
    }
    if (const int index = parameters_.wander(j); index >= 0) {
      prior_squares += AddWander(at, j, i, index, &result);
    }
    if (const int index = parameters_.response(j); index >= 0) {
      prior_squares += AddResponse(at, j, index, &result);
    }
    ++j;
  }
  prior_squares = WithFixedPriors(prior_squares, at, priors_);
  // The expected squares of all residuals together are twice the cost plus one for each unknown;
  // what is not the priors' is the corners'.
  const double corner_squares = 2.0 * joint.cost() + joint.num_unknowns() - prior_squares;
  const int sigma = parameters_.corner_sigma();
  result.slope[sigma] += corner_squares - num_rows;
  result.complete_information(sigma, sigma) += 2.0 * num_rows;
  result.is_usable = std::isfinite(result.value) && result.slope.allFinite();
  return result;
}

}  // namespace fathom
