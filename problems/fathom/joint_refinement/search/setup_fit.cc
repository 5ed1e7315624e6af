// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/setup_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Dense>

namespace fathom {
namespace {

// A part of the setup: the size scale, or one of the mount's six.
double* Find(int column, JointUnknowns* unknowns) {
  return column == kSizeColumn ? &unknowns->setup.size_scale
                               : &unknowns->setup.mount[column - kMountColumns];
}

// The runs as they are when the globals move by `change` and no pose does, to first order.
void Shift(const Eigen::VectorXd& change, std::vector<LinearRun>* runs) {
  for (LinearRun& run : *runs) {
    run.rr += 2.0 * change.dot(run.Jgr) + change.dot(run.JgJg * change);
    run.Jgr += run.JgJg * change;
    for (LinearFrame& frame : run.frames) frame.Jdr += frame.JdJg * change;
  }
}

bool IsTranslation(int coordinate) { return coordinate < 3; }

// The logarithm of the volume that the globals with a flat prior take up grows by this much times
// log(factor) when lengths grow by `factor`. They are flat in units of the world's size: what a
// length is called must not speak for one size or another.
double LengthsAmong(const std::vector<GlobalsPrior>& priors, int excited) {
  double lengths = 0.0;
  if (IsTranslation(excited)) {
    // Force = quadratic damping speed^2 = linear damping speed.
    if (priors[0].std[kQuadraticDamping] > 0.0) lengths -= 2.0;
    if (priors[0].std[kLinearDamping] > 0.0) lengths -= 1.0;
  }
  const double of_start = IsTranslation(excited) ? 2.0 : 0.0;
  const double of_means = IsTranslation(excited) ? 2.0 : 3.0;
  return lengths + static_cast<double>(priors.size()) * (of_start + of_means);
}

// The restricted likelihood of the setup under given processes.
class SetupLikelihood {
 public:
  SetupLikelihood(const PriorsAt& priors_at,
                  const ProcessSet& processes,
                  const JointUnknowns& unknowns,
                  JointData* data)
      : priors_at_(priors_at), processes_(processes), centre_(unknowns), data_(data) {
    size_ = unknowns.setup.size_scale;
    is_usable_ = Linearise(data, unknowns, processes.corner_sigma, &linear_);
    for (const LinearRun& run : linear_) num_rows_ += run.num_rows;
  }

  struct Value {
    bool is_usable = false;
    double value = 0.0;
    JointUnknowns unknowns;  // at their mode
    ProcessSet processes;
  };

  // With the setup moved by `change`, kNumColumns numbers of which the others are 0. The mode over
  // everything else is searched by Gauss and Newton from where the linear problem expects it.
  Value At(const Eigen::VectorXd& change) const {
    Value result;
    if (!is_usable_) return result;
    result.unknowns = centre_;
    JointUnknowns& at = result.unknowns;
    for (int column = kSizeColumn; column < kNumShared; ++column) {
      *Find(column, &at) += change[column];
    }
    if (!(at.setup.size_scale > 0.0)) return result;
    result.processes = Scaled(processes_, data_->excited, at.setup.size_scale / size_);
    std::vector<LinearRun> linear = linear_;
    Shift(change, &linear);
    double last = std::numeric_limits<double>::quiet_NaN();
    constexpr int kMostIterations = 12;
    constexpr double kSettled = 1e-5;  // of the log-likelihood
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      const auto priors = WithSetupHeld(priors_at_(at));
      const LinearJoint joint(linear, priors, result.processes, data_->excited);
      if (!joint.is_usable()) return result;
      // The rows count with their weights, which hardly differ from one setup to the next: with
      // those at the centre, so that this difference does not pass for a likelihood.
      double rows = -num_rows_, clipped = 0.0;
      for (const LinearRun& run : linear) {
        rows += run.num_rows;
        clipped += run.clipped;
      }
      result.value =
          joint.log_likelihood() + rows * std::log(processes_.corner_sigma) - 0.5 * clipped;
      if (std::abs(result.value - last) < kSettled) {
        result.is_usable = true;
        break;
      }
      last = result.value;
      std::vector<Eigen::VectorXd> changes;
      std::vector<std::vector<ChainSmoother::State>> deviations;
      for (size_t r = 0; r < linear.size(); ++r) {
        changes.push_back(joint.change(r));
        deviations.push_back(joint.Deviations(r));
      }
      Step(changes, deviations, &at);
      if (!Linearise(data_, at, processes_.corner_sigma, &linear)) return result;
    }
    const std::vector<GlobalsPrior> priors = priors_at_(at);
    result.value -= LengthsAmong(priors, data_->excited) * std::log(at.setup.size_scale);
    for (int column = kSizeColumn; column < kNumShared; ++column) {
      const double std = priors[0].std[column];
      if (!(std > 0.0) || !std::isfinite(std)) continue;
      result.value -= 0.5 * std::pow(priors[0].offset[column] / std, 2);
    }
    return result;
  }

 private:
  const PriorsAt& priors_at_;
  const ProcessSet processes_;
  const JointUnknowns centre_;
  JointData* const data_;
  double size_ = 1.0;
  double num_rows_ = 0.0;
  std::vector<LinearRun> linear_;
  bool is_usable_ = false;
};

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

}  // namespace

std::vector<GlobalsPrior> WithSetupHeld(std::vector<GlobalsPrior> priors) {
  for (GlobalsPrior& prior : priors) {
    std::fill_n(prior.std.begin() + kSizeColumn, kSetupColumns, 0.0);
  }
  return priors;
}

ProcessSet Scaled(const ProcessSet& processes, int excited, double factor) {
  ProcessSet scaled = processes;
  for (int j = 0; j < kNumHeld; ++j) {
    const bool is_length = IsTranslation(j < excited ? j : j + 1);
    if (is_length) scaled.wander[j].std *= factor;
    // Per unit of the excited motion over a fixed scale of it.
    if (is_length && !IsTranslation(excited)) scaled.response_std[j] *= factor;
    if (!is_length && IsTranslation(excited)) scaled.response_std[j] /= factor;
  }
  if (IsTranslation(excited)) scaled.model_error *= factor * factor;
  return scaled;
}

SetupFit FitSetup(const PriorsAt& priors_at,
                  const SetupFit& earlier,
                  JointData* data,
                  ProcessSet* processes,
                  JointUnknowns* unknowns) {
  SetupFit fit;
  std::vector<int> columns;
  const auto priors = priors_at(*unknowns);
  for (int column = kSizeColumn; column < kNumShared; ++column) {
    if (priors[0].std[column] > 0.0) columns.push_back(column);
  }
  if (columns.empty()) {
    fit.converged = true;
    return fit;
  }
  // Half of what is left in doubt, and no more than leaves the corners nearly linear (a hundredth
  // of the size, centimetres, half a degree).
  constexpr double kLongest = 0.02;
  const auto n = static_cast<Eigen::Index>(columns.size());
  Eigen::VectorXd step(n);
  std::vector<LinearRun> linear;
  if (!Linearise(data, *unknowns, processes->corner_sigma, &linear)) {
    fit.message = "a marker falls behind the camera.";
    return fit;
  }
  const LinearJoint joint(linear, priors, *processes, data->excited);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double std =
        joint.is_usable() ? std::sqrt(joint.covariance(0)(columns[i], columns[i])) : kLongest;
    step[i] = std::min(0.5 * std, kLongest);
  }

  constexpr int kMostIterations = 10;
  constexpr double kEnough = 0.002;   // expected gain of log-likelihood
  constexpr double kFarthest = 0.15;  // move at once
  // Of a direction: what is left in doubt is then thirty steps.
  constexpr double kLeastInformation = 1e-3;
  constexpr double kNearby = 2.0;  // steps
  Eigen::MatrixXd information;     // in steps, from nearby; else empty
  if (earlier.converged) {
    information.resize(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        information(i, j) =
            earlier.information(columns[i] - kSizeColumn, columns[j] - kSizeColumn) * step[i] *
            step[j];
      }
    }
  }
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    const SetupLikelihood likelihood(priors_at, *processes, *unknowns, data);
    const Expansion expansion = Expand(likelihood, columns, step, information);
    if (!expansion.is_usable) {
      fit.message = "the likelihood of the setup cannot be computed.";
      return fit;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(expansion.information);
    const Eigen::VectorXd floored = eigen.eigenvalues().cwiseMax(kLeastInformation);
    Eigen::VectorXd move = eigen.eigenvectors() * floored.cwiseInverse().asDiagonal() *
                           eigen.eigenvectors().transpose() * expansion.slope;
    const bool is_there = 0.5 * move.dot(expansion.slope) < kEnough;
    if (is_there) {
      if (eigen.eigenvalues().minCoeff() < kLeastInformation) {
        fit.message = "some unknown leaves no trace in the corners.";
        return fit;
      }
      for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
          fit.information(columns[i] - kSizeColumn, columns[j] - kSizeColumn) =
              expansion.information(i, j) / (step[i] * step[j]);
        }
      }
      fit.converged = true;
      return fit;
    }
    const double farthest = move.cwiseProduct(step).cwiseAbs().maxCoeff();
    if (farthest > kFarthest) move *= kFarthest / farthest;
    bool is_better = false;
    for (int halvings = 0; halvings < 6 && !is_better; ++halvings, move *= 0.5) {
      Eigen::VectorXd change = Eigen::VectorXd::Zero(kNumColumns);
      for (Eigen::Index i = 0; i < n; ++i) change[columns[i]] = move[i] * step[i];
      auto next = likelihood.At(change);
      if (!next.is_usable || !(next.value > expansion.value)) continue;
      *unknowns = std::move(next.unknowns);
      *processes = next.processes;
      is_better = fit.moved = true;
      const bool is_nearby = move.cwiseAbs().maxCoeff() < kNearby;
      information = is_nearby ? expansion.information : Eigen::MatrixXd();
    }
    if (!is_better) break;
  }
  fit.message = "the search for the size scale and the mount did not converge.";
  return fit;
}

}  // namespace fathom
