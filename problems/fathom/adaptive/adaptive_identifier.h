// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/adaptive_state.h"
#include "fathom/adaptive/gains.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

enum class AdaptiveIntegrator {
  kEuler,       // as in the paper; the estimated velocity starts at 0
  kRungeKutta,  // order four, the measured velocity interpolated linearly, the force held
};

// "euler" or "runge_kutta", as in flags and files.
std::string_view Name(AdaptiveIntegrator integrator);

// Throws InputError for another name: "is 'heun', expected euler or runge_kutta.", for the name of
// a flag to be put before it.
AdaptiveIntegrator ParseAdaptiveIntegrator(const std::string& name);

struct AdaptiveOptions {
  // Nothing: chosen from the data by FitAdaptive. AdaptiveIdentifier needs them given.
  std::optional<AdaptiveGains> gains;

  AdaptiveIntegrator integrator = AdaptiveIntegrator::kRungeKutta;

  // Every broken rule, a sentence each; empty if the options can be used.
  std::vector<std::string> Problems() const;
};

// The adaptive law of the paper's Eqs. 7 and 8, online: one sample in, one estimate out.
//
//   dv_hat/dt = a_m dv + Phi' f,      dv = v_hat - v           docs/adaptive.md (1)
//   dPhi/dt   = -Lambda dv f                                                    (2)
//
//   f    (tau, v_hat|v_hat|, v_hat, 1)
//   Phi  (alpha, beta, mu, nu), starts at 0
//
// Everything it knows is in the object: a few numbers, whatever the length of the stream; several
// instances do not disturb each other.
class AdaptiveIdentifier {
 public:
  // Throws InputError if the options break their rules or hold no gains.
  explicit AdaptiveIdentifier(const AdaptiveOptions& options);

  // Goes on where another one was: its state(), which must be finite. Throws as above.
  AdaptiveIdentifier(const AdaptiveOptions& options, const AdaptiveState& state);

  // One sample: stamp [s], after the one before; force [N] or [N m], held until the next stamp;
  // measured velocity [m/s] or [rad/s].
  void Add(double t, double force, double velocity);

  // Forgets the stamp and the estimated velocity, but not the parameters: the next sample starts a
  // new stretch of data.
  void StartSegment();

  // m = 1/alpha, d_Q = -beta/alpha, d_L = -mu/alpha, b = -nu/alpha of the present Phi, with an
  // alpha of at least 1e-5. NaN before the first sample.
  UncoupledModel<double> Estimate() const;

  // v_hat at the last sample [m/s] or [rad/s].
  double velocity() const { return state_[0]; }

  // Phi.
  std::array<double, 4> lumped() const { return {state_[1], state_[2], state_[3], state_[4]}; }

  AdaptiveState state() const;

  // False once the state has left the finite numbers; it stays so.
  bool IsFinite() const { return is_finite_; }

  long num_samples() const { return num_samples_; }

 private:
  using State = std::array<double, 5>;  // v_hat, then Phi

  State Derivative(const State& state, double force, double velocity) const;
  void StepEuler(double h);
  void StepRungeKutta(double h, double velocity);

  AdaptiveGains gains_;
  AdaptiveIntegrator integrator_;
  State state_ = {};
  double t_ = 0.0;         // of the last sample
  double force_ = 0.0;     // of the last sample
  double velocity_ = 0.0;  // measured, of the last sample
  long num_samples_ = 0;
  bool segment_started_ = false;
  bool is_finite_ = true;
};

}  // namespace fathom
