// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/simulate.h"

#include <algorithm>
#include <cmath>

#include <ceres/jet.h>
#include <glog/logging.h>

namespace fathom {
namespace {

// One more than needed: an even number of derivatives fills the vector registers.
constexpr int kJetSize = Simulation::kNumSensitivities + 1;
using Jet = ceres::Jet<double, kJetSize>;

constexpr double kLargestStep = 0.1;      // in time constants of the damping, docs/models.md (5)
constexpr double kMostSubsteps = 1000.0;  // of one step
constexpr double kLargestSpeed = 1e6;     // [m/s] or [rad/s]; beyond, the state has diverged

double Value(double x) { return x; }
double Value(const Jet& x) { return x.a; }

template <typename T>
struct State {
  T velocity;
  T position;
};

// One Runge-Kutta step of order four, docs/models.md (5). The position costs a fifth of the time
// and is often not asked for.
template <bool kWithPosition, typename T>
void Advance(const UncoupledModel<T>& model, double force, double h, State<T>* state) {
  const T v1 = state->velocity;
  const T k1 = model.Acceleration(v1, force);
  const T v2 = v1 + (0.5 * h) * k1;
  const T k2 = model.Acceleration(v2, force);
  const T v3 = v1 + (0.5 * h) * k2;
  const T k3 = model.Acceleration(v3, force);
  const T v4 = v1 + h * k3;
  const T k4 = model.Acceleration(v4, force);
  state->velocity += (h / 6.0) * (k1 + 2.0 * (k2 + k3) + k4);
  if constexpr (kWithPosition) state->position += (h / 6.0) * (v1 + 2.0 * (v2 + v3) + v4);
}

// Into how many equal parts a step of `duration` is divided, as a real number. The speed in the
// damping's rate is the most that the step can reach: what the force gives without damping, or the
// speed at which quadratic damping balances the force.
template <typename T>
double NumSubsteps(const UncoupledModel<T>& model,
                   const T& velocity,
                   double force,
                   double duration) {
  const double inertia = Value(model.inertia);
  const double d_L = Value(model.linear_damping), d_Q = Value(model.quadratic_damping);
  const double speed = std::abs(Value(velocity));
  const double push = std::abs(force - Value(model.buoyancy));
  const double longest = kLargestStep * inertia;
  const auto steps_at = [&](double most) { return duration * std::abs(d_L + 2.0 * d_Q * most); };
  const double reached = speed + push * duration / inertia;
  if (steps_at(reached) <= longest) return 1.0;
  const double balance = d_Q > 0.0 ? std::max(speed, std::sqrt(push / d_Q)) : reached;
  return std::max(1.0, std::ceil(steps_at(std::min(reached, balance)) / longest));
}

// Calls emit(output index, state) at every output stamp. False if the state diverges.
template <bool kWithPosition, typename T, typename Steps, typename Emit>
bool Integrate(const Steps& steps, const UncoupledModel<T>& model, State<T> state, Emit emit) {
  emit(0, state);
  for (const auto& step : steps) {
    const double num_substeps = NumSubsteps(model, state.velocity, step.force, step.duration);
    if (!(num_substeps <= kMostSubsteps)) return false;
    const double h = num_substeps == 1.0 ? step.duration : step.duration / num_substeps;
    for (int i = 0; i < static_cast<int>(num_substeps); ++i) {
      Advance<kWithPosition>(model, step.force, h, &state);
    }
    if (!(std::abs(Value(state.velocity)) < kLargestSpeed)) return false;
    if (step.output >= 0) emit(step.output, state);
  }
  return true;
}

void CopyDerivatives(const Jet& from, int row, std::span<double> to) {
  if (to.empty()) return;
  constexpr int kColumns = Simulation::kNumSensitivities;
  std::copy_n(from.v.data(), kColumns, to.begin() + static_cast<std::ptrdiff_t>(row) * kColumns);
}

}  // namespace

Simulation::Simulation(const HeldCommand& command, std::span<const double> output_time)
    : num_outputs_(static_cast<int>(output_time.size())) {
  CHECK(!output_time.empty());
  CHECK_EQ(command.time.size(), command.value.size());
  double t = output_time[0];
  const auto index_after = [&](double time) -> size_t {
    return std::upper_bound(command.time.begin(), command.time.end(), time) - command.time.begin();
  };
  size_t next_command = index_after(t);
  steps_.reserve(output_time.size() + index_after(output_time.back()) - next_command);
  double force = command.At(t);
  for (int output = 1; output < num_outputs_; ++output) {
    const double t_output = output_time[output];
    CHECK_GT(t_output, t) << "Output stamps increase strictly.";
    for (; next_command < command.time.size() && command.time[next_command] <= t_output;
         ++next_command) {
      const double t_command = command.time[next_command];
      if (t_command < t_output) {
        steps_.push_back({t_command - t, force, -1});
        t = t_command;
        force = command.value[next_command];
      } else {
        steps_.push_back({t_output - t, force, output});
        t = t_output;
        force = command.value[next_command];
      }
    }
    if (t < t_output) steps_.push_back({t_output - t, force, output});
    t = t_output;
  }
}

bool Simulation::Run(const UncoupledModel<double>& model,
                     const InitialState& initial,
                     std::span<double> velocity,
                     std::span<double> position) const {
  CHECK_EQ(velocity.size(), static_cast<size_t>(num_outputs_));
  CHECK(position.empty() || position.size() == velocity.size());
  const State<double> start = {initial.velocity, initial.position};
  const auto emit = [&](int output, const State<double>& state) {
    velocity[output] = state.velocity;
    if (!position.empty()) position[output] = state.position;
  };
  return position.empty() ? Integrate<false>(steps_, model, start, emit)
                          : Integrate<true>(steps_, model, start, emit);
}

bool Simulation::RunWithSensitivities(const UncoupledModel<double>& model,
                                      const InitialState& initial,
                                      std::span<double> velocity,
                                      std::span<double> position,
                                      std::span<double> velocity_sensitivity,
                                      std::span<double> position_sensitivity) const {
  const UncoupledModel<Jet> differentiated = {Jet(model.inertia, 0),
                                              Jet(model.quadratic_damping, 1),
                                              Jet(model.linear_damping, 2),
                                              Jet(model.buoyancy, 3)};
  const State<Jet> start = {Jet(initial.velocity, 4), Jet(initial.position)};
  const auto emit = [&](int output, const State<Jet>& state) {
    if (!velocity.empty()) velocity[output] = state.velocity.a;
    if (!position.empty()) position[output] = state.position.a;
    CopyDerivatives(state.velocity, output, velocity_sensitivity);
    CopyDerivatives(state.position, output, position_sensitivity);
  };
  const bool with_position = !position.empty() || !position_sensitivity.empty();
  return with_position ? Integrate<true>(steps_, differentiated, start, emit)
                       : Integrate<false>(steps_, differentiated, start, emit);
}

}  // namespace fathom
