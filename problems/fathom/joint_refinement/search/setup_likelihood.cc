// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/setup_likelihood.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fathom {
namespace {

// A part of the setup: the size scale, or one of the mount's six.
double* Find(int column, JointUnknowns* unknowns) {
  return column == kSizeColumn ? &unknowns->setup.size_scale
                               : &unknowns->setup.mount[column - kMountColumns];
}

// The segments as they are when the globals move by `change` and no pose does, to first order.
void Shift(const Eigen::VectorXd& change, std::vector<LinearSegment>* segments) {
  for (LinearSegment& segment : *segments) {
    segment.rr += 2.0 * change.dot(segment.Jgr) + change.dot(segment.JgJg * change);
    segment.Jgr += segment.JgJg * change;
    for (LinearFrame& frame : segment.frames) frame.Jdr += frame.JdJg * change;
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

SetupLikelihood::SetupLikelihood(const PriorsAt& priors_at,
                                 const ProcessSet& processes,
                                 const JointUnknowns& unknowns,
                                 JointData* data)
    : priors_at_(priors_at), processes_(processes), centre_(unknowns), data_(data) {
  size_ = unknowns.setup.size_scale;
  is_usable_ = Linearise(data, unknowns, processes.corner_sigma, &linear_);
  for (const LinearSegment& segment : linear_) num_rows_ += segment.num_rows;
}

SetupLikelihood::Value SetupLikelihood::At(const Eigen::VectorXd& change) const {
  Value result;
  if (!is_usable_) return result;
  result.unknowns = centre_;
  JointUnknowns& at = result.unknowns;
  for (int column = kSizeColumn; column < kNumShared; ++column) {
    *Find(column, &at) += change[column];
  }
  if (!(at.setup.size_scale > 0.0)) return result;
  result.processes = Scaled(processes_, data_->excited, at.setup.size_scale / size_);
  std::vector<LinearSegment> linear = linear_;
  Shift(change, &linear);
  result.is_usable = FindMode(std::move(linear), &result);
  const std::vector<GlobalsPrior> priors = priors_at_(at);
  result.value -= LengthsAmong(priors, data_->excited) * std::log(at.setup.size_scale);
  for (int column = kSizeColumn; column < kNumShared; ++column) {
    const double std = priors[0].std[column];
    if (!(std > 0.0) || !std::isfinite(std)) continue;
    result.value -= 0.5 * std::pow(priors[0].offset[column] / std, 2);
  }
  return result;
}

bool SetupLikelihood::FindMode(std::vector<LinearSegment> linear, Value* result) const {
  constexpr int kMostIterations = 12;
  constexpr double kSettled = 1e-5;  // of the log-likelihood
  double last = std::numeric_limits<double>::quiet_NaN();
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    const auto priors = WithSetupHeld(priors_at_(result->unknowns));
    const LinearJoint joint(linear, priors, result->processes, data_->excited);
    if (!joint.is_usable()) return false;
    // The rows count with their weights, which hardly differ from one setup to the next: with those
    // at the centre, so that this difference does not pass for a likelihood.
    double rows = -num_rows_, clipped = 0.0;
    for (const LinearSegment& segment : linear) {
      rows += segment.num_rows;
      clipped += segment.clipped;
    }
    result->value =
        joint.log_likelihood() + rows * std::log(processes_.corner_sigma) - 0.5 * clipped;
    if (std::abs(result->value - last) < kSettled) return true;
    last = result->value;
    std::vector<Eigen::VectorXd> changes;
    std::vector<std::vector<ChainSmoother::State>> deviations;
    for (size_t r = 0; r < linear.size(); ++r) {
      changes.push_back(joint.change(r));
      deviations.push_back(joint.Deviations(r));
    }
    Step(changes, deviations, &result->unknowns);
    if (!Linearise(data_, result->unknowns, processes_.corner_sigma, &linear)) return false;
  }
  return false;
}

}  // namespace fathom
