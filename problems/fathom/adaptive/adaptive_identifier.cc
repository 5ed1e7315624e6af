// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/adaptive_identifier.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kSmallestAlpha = 1e-5;  // [1/kg]; no vehicle weighs more than 100 t

template <typename State>
State Moved(const State& state, double h, const State& derivative) {
  State moved;
  for (size_t k = 0; k < state.size(); ++k) moved[k] = state[k] + h * derivative[k];
  return moved;
}

}  // namespace

std::string_view Name(AdaptiveIntegrator integrator) {
  return integrator == AdaptiveIntegrator::kEuler ? "euler" : "runge_kutta";
}

AdaptiveIntegrator ParseAdaptiveIntegrator(const std::string& name) {
  for (const auto integrator : {AdaptiveIntegrator::kEuler, AdaptiveIntegrator::kRungeKutta}) {
    if (name == Name(integrator)) return integrator;
  }
  throw InputError(fmt::format("is '{}', expected euler or runge_kutta.", name));
}

std::vector<std::string> AdaptiveOptions::Problems() const {
  return gains ? gains->Problems() : std::vector<std::string>{};
}

AdaptiveIdentifier::AdaptiveIdentifier(const AdaptiveOptions& options)
    : integrator_(options.integrator) {
  if (!options.gains) throw InputError("The adaptive identifier needs gains: a_m and Lambda.");
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(fmt::format("The gains of the adaptive identifier cannot be used: {}",
                                 fmt::join(problems, "; ")));
  }
  gains_ = *options.gains;
}

AdaptiveIdentifier::AdaptiveIdentifier(const AdaptiveOptions& options, const AdaptiveState& state)
    : AdaptiveIdentifier(options) {
  state_ = {
      state.estimated_velocity, state.lumped[0], state.lumped[1], state.lumped[2], state.lumped[3]};
  CHECK(std::all_of(state_.begin(), state_.end(), [](double x) { return std::isfinite(x); }));
  t_ = state.t;
  force_ = state.force;
  velocity_ = state.velocity;
  num_samples_ = state.num_samples;
  segment_started_ = state.segment_started;
}

AdaptiveState AdaptiveIdentifier::state() const {
  return {state_[0], lumped(), t_, force_, velocity_, num_samples_, segment_started_};
}

void AdaptiveIdentifier::StartSegment() { segment_started_ = false; }

// docs/adaptive.md (1) and (2).
AdaptiveIdentifier::State AdaptiveIdentifier::Derivative(const State& state,
                                                         double force,
                                                         double velocity) const {
  const auto& [v_hat, alpha, beta, mu, nu] = state;
  const double drag = v_hat * std::abs(v_hat);
  const double dv = v_hat - velocity;
  return {gains_.a_m * dv + alpha * force + beta * drag + mu * v_hat + nu,
          -gains_.lambda[0] * dv * force,
          -gains_.lambda[1] * dv * drag,
          -gains_.lambda[2] * dv * v_hat,
          -gains_.lambda[3] * dv};
}

void AdaptiveIdentifier::StepEuler(double h) {
  state_ = Moved(state_, h, Derivative(state_, force_, velocity_));
}

void AdaptiveIdentifier::StepRungeKutta(double h, double velocity) {
  const double middle = 0.5 * (velocity_ + velocity);
  const State k1 = Derivative(state_, force_, velocity_);
  const State k2 = Derivative(Moved(state_, 0.5 * h, k1), force_, middle);
  const State k3 = Derivative(Moved(state_, 0.5 * h, k2), force_, middle);
  const State k4 = Derivative(Moved(state_, h, k3), force_, velocity);
  for (size_t k = 0; k < state_.size(); ++k) {
    state_[k] += h / 6.0 * (k1[k] + 2.0 * (k2[k] + k3[k]) + k4[k]);
  }
}

void AdaptiveIdentifier::Add(double t, double force, double velocity) {
  if (!segment_started_) {
    segment_started_ = true;
    state_[0] = integrator_ == AdaptiveIntegrator::kEuler ? 0.0 : velocity;
  } else {
    CHECK_GT(t, t_) << "Stamps increase strictly.";
    if (integrator_ == AdaptiveIntegrator::kEuler) {
      StepEuler(t - t_);
    } else {
      StepRungeKutta(t - t_, velocity);
    }
    is_finite_ = is_finite_ && std::all_of(state_.begin(), state_.end(), [](double x) {
                   return std::isfinite(x);
                 });
  }
  t_ = t;
  force_ = force;
  velocity_ = velocity;
  ++num_samples_;
}

UncoupledModel<double> AdaptiveIdentifier::Estimate() const {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  if (num_samples_ == 0 || !is_finite_) return {nan, nan, nan, nan};
  const double alpha = std::max(state_[1], kSmallestAlpha);
  return {1.0 / alpha, -state_[2] / alpha, -state_[3] / alpha, -state_[4] / alpha};
}

}  // namespace fathom
