// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/marker_size_and_mount.h"

#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Core>

namespace fathom {
namespace {

// Value, slope and minus curvature at the likelihood's centre, in steps as units; by differences.
// Where `information` is known already from nearby, off its diagonal it is taken from there: the
// differences of pairs are most of the work.
struct Expansion {
  bool is_usable = false;
  double value = 0.0;
  Eigen::VectorXd slope;
  Eigen::MatrixXd information;
};

Expansion Expand(const SetupLikelihood& likelihood,
                 const std::vector<int>& columns,
                 const Eigen::VectorXd& step,
                 const Eigen::MatrixXd& information) {
  const auto n = static_cast<Eigen::Index>(columns.size());
  Expansion result;
  result.is_usable = true;
  const auto at = [&](Eigen::Index i, double by_i, Eigen::Index j, double by_j) {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(kNumColumns);
    change[columns[i]] += by_i * step[i];
    change[columns[j]] += by_j * step[j];
    const auto value = likelihood.At(change);
    if (!value.is_usable) result.is_usable = false;
    return value.value;
  };
  result.value = at(0, 0.0, 0, 0.0);
  result.slope.resize(n);
  result.information.resize(n, n);
  Eigen::VectorXd both(n);
  for (Eigen::Index i = 0; i < n && result.is_usable; ++i) {
    const double up = at(i, 1.0, i, 0.0), down = at(i, -1.0, i, 0.0);
    result.slope[i] = 0.5 * (up - down);
    both[i] = up + down;
    result.information(i, i) = 2.0 * result.value - both[i];
    for (Eigen::Index j = 0; j < i; ++j) {
      if (information.size() > 0) {
        result.information(i, j) = result.information(j, i) = information(i, j);
        continue;
      }
      const double mixed = at(i, 1.0, j, 1.0) + at(i, -1.0, j, -1.0);
      result.information(i, j) = result.information(j, i) =
          0.5 * (both[i] + both[j] - 2.0 * result.value - mixed);
    }
  }
  return result;
}

// The parts of the setup that the priors do not hold.
std::vector<int> FreeColumns(const GlobalsPrior& prior) {
  std::vector<int> columns;
  for (int column = kSizeColumn; column < kNumShared; ++column) {
    if (prior.std[column] > 0.0) columns.push_back(column);
  }
  return columns;
}

// Steps of the differences: half of what is left in doubt, and no more than leaves the corners
// nearly linear (a hundredth of the size, centimetres, half a degree).
Eigen::VectorXd StepsOf(const std::vector<int>& columns, const LinearJoint& joint) {
  constexpr double kLongest = 0.02;
  Eigen::VectorXd step(static_cast<Eigen::Index>(columns.size()));
  for (Eigen::Index i = 0; i < step.size(); ++i) {
    const double std =
        joint.is_usable() ? std::sqrt(joint.covariance(0)(columns[i], columns[i])) : kLongest;
    step[i] = std::min(0.5 * std, kLongest);
  }
  return step;
}

// Of the free columns, in steps.
Eigen::MatrixXd InSteps(const SetupInformation& information,
                        const std::vector<int>& columns,
                        const Eigen::VectorXd& step) {
  Eigen::MatrixXd in_steps(step.size(), step.size());
  for (Eigen::Index i = 0; i < step.size(); ++i) {
    for (Eigen::Index j = 0; j < step.size(); ++j) {
      in_steps(i, j) =
          information(columns[i] - kSizeColumn, columns[j] - kSizeColumn) * step[i] * step[j];
    }
  }
  return in_steps;
}

SetupInformation FromSteps(const Eigen::MatrixXd& in_steps,
                           const std::vector<int>& columns,
                           const Eigen::VectorXd& step) {
  SetupInformation information = SetupInformation::Zero();
  for (Eigen::Index i = 0; i < step.size(); ++i) {
    for (Eigen::Index j = 0; j < step.size(); ++j) {
      information(columns[i] - kSizeColumn, columns[j] - kSizeColumn) =
          in_steps(i, j) / (step[i] * step[j]);
    }
  }
  return information;
}

// Of a direction: what is left in doubt is then thirty steps.
constexpr double kLeastInformation = 1e-3;

// Where Newton's method goes from an expansion, in steps.
struct NewtonMove {
  Eigen::VectorXd move;
  double least_information = 0.0;  // of any direction

  // Of the log-likelihood.
  double ExpectedGain(const Expansion& from) const { return 0.5 * move.dot(from.slope); }
};

NewtonMove MoveFrom(const Expansion& expansion) {
  const SymmetricEigen eigen = EigenOf(expansion.information);
  const Eigen::VectorXd floored = eigen.values.cwiseMax(kLeastInformation);
  return {eigen.vectors * floored.cwiseInverse().asDiagonal() * eigen.vectors.transpose() *
              expansion.slope,
          eigen.values.minCoeff()};
}

// A point that is better than the likelihood's centre, and the move that leads there, in steps.
struct BetterPoint {
  SetupLikelihood::Value at;
  Eigen::VectorXd move;
};

// Along `move`, which is shortened until it is one; nothing if it never is.
std::optional<BetterPoint> Improve(const SetupLikelihood& likelihood,
                                   double value,
                                   Eigen::VectorXd move,
                                   const std::vector<int>& columns,
                                   const Eigen::VectorXd& step) {
  constexpr double kFarthest = 0.15;  // at once
  constexpr int kMostHalvings = 6;
  const double farthest = move.cwiseProduct(step).cwiseAbs().maxCoeff();
  if (farthest > kFarthest) move *= kFarthest / farthest;
  for (int halvings = 0; halvings < kMostHalvings; ++halvings, move *= 0.5) {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(kNumColumns);
    for (Eigen::Index i = 0; i < step.size(); ++i) change[columns[i]] = move[i] * step[i];
    SetupLikelihood::Value next = likelihood.At(change);
    if (next.is_usable && next.value > value) return BetterPoint{std::move(next), move};
  }
  return std::nullopt;
}

}  // namespace

SetupFit FitMarkerSizeAndMount(const PriorsAt& priors_at,
                               const SetupFit& earlier,
                               JointData* data,
                               ProcessSet* processes,
                               JointUnknowns* unknowns) {
  constexpr int kMostIterations = 10;
  constexpr double kEnough = 0.002;  // expected gain of log-likelihood
  constexpr double kNearby = 2.0;    // steps
  SetupFit fit;
  const auto priors = priors_at(*unknowns);
  const std::vector<int> columns = FreeColumns(priors[0]);
  if (columns.empty()) {
    fit.converged = true;
    return fit;
  }
  std::vector<LinearSegment> linear;
  if (!Linearise(data, *unknowns, processes->corner_sigma, &linear)) {
    fit.message = "a marker falls behind the camera.";
    return fit;
  }
  const Eigen::VectorXd step =
      StepsOf(columns, LinearJoint(linear, priors, *processes, data->excited));
  Eigen::MatrixXd information;  // in steps, from nearby; else empty
  if (earlier.converged) information = InSteps(earlier.information, columns, step);
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    const SetupLikelihood likelihood(priors_at, *processes, *unknowns, data);
    const Expansion expansion = Expand(likelihood, columns, step, information);
    if (!expansion.is_usable) {
      fit.message = "the likelihood of the setup cannot be computed.";
      return fit;
    }
    const NewtonMove newton = MoveFrom(expansion);
    if (newton.ExpectedGain(expansion) < kEnough) {
      if (newton.least_information < kLeastInformation) {
        fit.message = "the corners do not determine some unknown.";
        return fit;
      }
      fit.information = FromSteps(expansion.information, columns, step);
      fit.converged = true;
      return fit;
    }
    auto better = Improve(likelihood, expansion.value, newton.move, columns, step);
    if (!better) break;
    *unknowns = std::move(better->at.unknowns);
    *processes = better->at.processes;
    fit.moved = true;
    const bool is_nearby = better->move.cwiseAbs().maxCoeff() < kNearby;
    information = is_nearby ? expansion.information : Eigen::MatrixXd();
  }
  fit.message = "the search for the size scale and the mount did not converge.";
  return fit;
}

}  // namespace fathom
