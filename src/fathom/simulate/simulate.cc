// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/simulate.h"

#include "fathom/base/tiny_as_zero.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kLargestStep = 0.1;      // in time constants of the damping, docs/models.md (5)
constexpr double kMostSubsteps = 1000.0;  // of one step
constexpr double kLargestSpeed = 1e6;     // [m/s] or [rad/s]; beyond, the state has diverged

// By the four parameters, then by the initial velocity.
using Derivatives = std::array<double, Simulation::kNumSensitivities>;

// The model over its inertia, docs/models.md (1), so that no stage divides:
//
//   dv/dt = push - (quadratic |v| + linear) v,   push = (tau - b) / m
struct ModelPerInertia {
  explicit ModelPerInertia(const UncoupledModel<double>& model)
      : inverse_inertia(1.0 / model.inertia),
        quadratic(model.quadratic_damping * inverse_inertia),
        linear(model.linear_damping * inverse_inertia),
        buoyancy(model.buoyancy) {}

  double Push(double force) const { return (force - buoyancy) * inverse_inertia; }
  // Derivative of the acceleration by the speed.
  double Slope(double v) const { return -(2.0 * quadratic * std::abs(v) + linear); }

  double inverse_inertia, quadratic, linear, buoyancy;
};

struct State {
  double velocity = 0.0, position = 0.0;
  Derivatives of_velocity = {}, of_position = {};
};

// Speeds of the stages of one Runge-Kutta step, docs/models.md (5), and at its end.
struct Stages {
  std::array<double, 4> v;
  double end;
};

// Each stage waits for the one before, so the way from speed to speed is kept short: the numbers
// that it takes are known beforehand.
[[gnu::always_inline]] inline Stages StagesOf(const ModelPerInertia& model,
                                              double v,
                                              double push,
                                              double h) {
  // v + h times the acceleration at the speed `at`.
  const auto after = [&](double h, double at) {
    const double linear = h * model.linear, quadratic = h * model.quadratic;
    return ((v + h * push) - linear * at) - (quadratic * at) * std::abs(at);
  };
  Stages stages;
  stages.v[0] = v;
  stages.v[1] = after(0.5 * h, v);
  stages.v[2] = after(0.5 * h, stages.v[1]);
  stages.v[3] = after(h, stages.v[2]);
  // h/6 (a_0 + 2 a_1 + 2 a_2 + a_3), where the first three are differences of the speeds.
  stages.end = (stages.v[1] + 2.0 * stages.v[2] + stages.v[3] - 4.0 * v) * (1.0 / 3.0) +
               after(h / 6.0, stages.v[3]);
  return stages;
}

// How sum_i weight_i a_i follows the parameters and, last, the speed at the step's begin. The
// stages are passed backwards: weight_i grows by what a_i does to the stages after it.
[[gnu::always_inline]] inline Derivatives DerivativesOf(const ModelPerInertia& model,
                                                        const Stages& at,
                                                        double push,
                                                        double h,
                                                        std::array<double, 4> weight) {
  weight[2] += h * model.Slope(at.v[3]) * weight[3];
  weight[1] += 0.5 * h * model.Slope(at.v[2]) * weight[2];
  weight[0] += 0.5 * h * model.Slope(at.v[1]) * weight[1];
  Derivatives sum = {};
  for (int i = 0; i < 4; ++i) {
    const double by_buoyancy = -weight[i] * model.inverse_inertia;
    const double size = std::abs(at.v[i]);
    sum[kQuadraticDamping] += by_buoyancy * at.v[i] * size;
    sum[kLinearDamping] += by_buoyancy * at.v[i];
    sum[kBuoyancy] += by_buoyancy;
    sum[kNumParameters] += weight[i] * model.Slope(at.v[i]);
  }
  // d a_i / d m = -a_i / m, and a_i is made of what was just summed up.
  sum[kInertia] = push * sum[kBuoyancy] - model.quadratic * sum[kQuadraticDamping] -
                  model.linear * sum[kLinearDamping];
  return sum;
}

// `of` += how the step follows the speed at its begin, `by_speed` and what `step` adds, times how
// that speed follows the initial one and the parameters, and what the parameters do in the step.
void Chain(const Derivatives& of_speed, double by_speed, const Derivatives& step, Derivatives* of) {
  const double factor = by_speed + step[kNumParameters];
  for (int k = 0; k < Simulation::kNumSensitivities; ++k) (*of)[k] += factor * of_speed[k];
  for (int k = 0; k < kNumParameters; ++k) (*of)[k] += step[k];
}

// One step of order four. The position and the derivatives are often not asked for.
template <bool kWithPosition, bool kWithDerivatives>
void Advance(const ModelPerInertia& model, double push, double h, State* state) {
  const Stages at = StagesOf(model, state->velocity, push, h);
  const auto& v = at.v;
  if constexpr (kWithDerivatives && kWithPosition) {
    // x grows by h v and h^2/6 (a_1 + a_2 + a_3).
    const double third = h * h / 6.0;
    Chain(state->of_velocity,
          h,
          DerivativesOf(model, at, push, h, {third, third, third, 0.0}),
          &state->of_position);
  }
  if constexpr (kWithDerivatives) {
    Chain(Derivatives(state->of_velocity),
          0.0,
          DerivativesOf(model, at, push, h, {h / 6.0, h / 3.0, h / 3.0, h / 6.0}),
          &state->of_velocity);
  }
  if constexpr (kWithPosition) state->position += (h / 6.0) * (v[0] + 2.0 * (v[1] + v[2]) + v[3]);
  state->velocity = at.end;
}

// Into how many equal parts a step of `duration` is divided, as a real number. The speed in the
// damping's rate is the most that the step can reach: what the force gives without damping, or the
// speed at which quadratic damping balances the force.
[[gnu::always_inline]] inline double NumSubsteps(const ModelPerInertia& model,
                                                 double velocity,
                                                 double push,
                                                 double duration) {
  const double speed = std::abs(velocity), most_push = std::abs(push);
  const auto steps_at = [&](double most) {
    return duration * std::abs(model.linear + 2.0 * model.quadratic * most);
  };
  const double reached = speed + most_push * duration;
  if (steps_at(reached) <= kLargestStep) return 1.0;
  const double balance =
      model.quadratic > 0.0 ? std::max(speed, std::sqrt(most_push / model.quadratic)) : reached;
  return std::max(1.0, std::ceil(steps_at(std::min(reached, balance)) / kLargestStep));
}

// Calls emit(output index, state) at every output stamp. False if the state diverges.
template <bool kWithPosition, bool kWithDerivatives, typename Steps, typename Emit>
bool Integrate(const Steps& steps, const ModelPerInertia& model, State state, Emit emit) {
  emit(0, state);
  for (const auto& step : steps) {
    const double push = model.Push(step.force);
    const double num_substeps = NumSubsteps(model, state.velocity, push, step.duration);
    if (!(num_substeps <= kMostSubsteps)) return false;
    const double h = num_substeps == 1.0 ? step.duration : step.duration / num_substeps;
    for (int i = 0; i < static_cast<int>(num_substeps); ++i) {
      Advance<kWithPosition, kWithDerivatives>(model, push, h, &state);
    }
    if (!(std::abs(state.velocity) < kLargestSpeed)) return false;
    if (step.output >= 0) emit(step.output, state);
  }
  return true;
}

void CopyDerivatives(const Derivatives& from, int row, std::span<double> to) {
  if (to.empty()) return;
  std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(row) * from.size());
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
  const ModelPerInertia per_inertia(model);
  const State start = {initial.velocity, initial.position};
  const auto emit = [&](int output, const State& state) {
    velocity[output] = state.velocity;
    if (!position.empty()) position[output] = state.position;
  };
  return position.empty() ? Integrate<false, false>(steps_, per_inertia, start, emit)
                          : Integrate<true, false>(steps_, per_inertia, start, emit);
}

bool Simulation::RunWithSensitivities(const UncoupledModel<double>& model,
                                      const InitialState& initial,
                                      std::span<double> velocity,
                                      std::span<double> position,
                                      std::span<double> velocity_sensitivity,
                                      std::span<double> position_sensitivity) const {
  const TinyAsZero tiny_as_zero;
  const ModelPerInertia per_inertia(model);
  State start = {initial.velocity, initial.position};
  start.of_velocity[kNumParameters] = 1.0;
  const auto emit = [&](int output, const State& state) {
    if (!velocity.empty()) velocity[output] = state.velocity;
    if (!position.empty()) position[output] = state.position;
    CopyDerivatives(state.of_velocity, output, velocity_sensitivity);
    CopyDerivatives(state.of_position, output, position_sensitivity);
  };
  const bool with_position = !position.empty() || !position_sensitivity.empty();
  return with_position ? Integrate<true, true>(steps_, per_inertia, start, emit)
                       : Integrate<false, true>(steps_, per_inertia, start, emit);
}

}  // namespace fathom
