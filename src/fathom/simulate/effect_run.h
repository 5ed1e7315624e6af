// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/flattened.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/output_stamps.h"
#include "fathom/simulate/partner_signals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// The integration behind EffectSimulation, for one scalar. Not for other includers.

namespace fathom {

template <typename T>
struct ScalarEffect {
  const EffectLaws* laws;
  const EffectLaw<T>* law;
  EffectSetting setting;
  bool has_partner = false;
  std::vector<T> parameters;
};

template <typename T>
struct ScalarModel {
  UncoupledModel<T> baseline;
  T initial_velocity{0.0};
  T initial_position{0.0};
  T initial_reading_excess{0.0};
  T initial_memory_excess{0.0};
  std::vector<ScalarEffect<T>> effects;
};

// One run. All times inside are on the command's clock, s = t - delay of the command: the steps
// then never move, and only the outputs do.
template <typename T>
class EffectRun {
 public:
  EffectRun(const EffectInputs& inputs, ScalarModel<T> model, const OutputStamps& stamps)
      : inputs_(inputs),
        model_(std::move(model)),
        stamps_(stamps),
        needs_position_(!stamps.displacement.empty()) {
    for (size_t k = 0; k < model_.effects.size(); ++k) {
      const ScalarEffect<T>& effect = model_.effects[k];
      const EffectHooks& has = effect.laws->has;
      if (has.delay) delay_ = delay_ + effect.law->Delay(effect.parameters.data());
      if (has.pose_delay) pose_delay_ = effect.law->PoseDelay(effect.parameters.data());
      needs_position_ = needs_position_ || has.resistance;
      acts_on_water_ = acts_on_water_ || has.resistance || has.relative_speed;
      follows_force_ = follows_force_ || has.follow;
      follows_reading_ = follows_reading_ || has.follow_reading;
      moves_stamps_ = moves_stamps_ || has.delay || has.pose_delay;
      if (effect.has_partner) partners_[k] = PartnerSignals(inputs, effect.setting);
      has_memory_ = has_memory_ || has.memory_rate;
    }
    if (has_memory_) {
      for (State* state : {&state_, &before_, &trial_, &k1_, &k2_, &k3_, &k4_}) {
        state->memory.resize(model_.effects.size());
      }
    }
    water_.quadratic_damping = model_.baseline.quadratic_damping;
    water_.linear_damping = model_.baseline.linear_damping;
    time_zero_ = inputs.command.time.empty() ? 0.0 : inputs.command.time.front();
  }

  // Calls emit_velocity(row, reading) and emit_displacement(row, reading) at every output stamp.
  // False if the state diverges.
  template <typename EmitVelocity, typename EmitDisplacement>
  FATHOM_FLATTENED bool Integrate(const EmitVelocity& emit_velocity,
                                  const EmitDisplacement& emit_displacement) {
    const std::vector<double>& edges = inputs_.command.time;
    T begin = stamps_.start - delay_;
    state_.velocity = model_.initial_velocity;
    state_.position = model_.initial_position;
    for (size_t k = 0; k < model_.effects.size(); ++k) {
      if (!model_.effects[k].laws->has.memory_rate) continue;
      state_.memory[k] = RememberedBefore(model_.effects[k]) + model_.initial_memory_excess;
    }
    reading_ = Reading(state_.velocity, T(stamps_.start));
    shown_ = follows_reading_ ? T(reading_ + model_.initial_reading_excess) : reading_;
    size_t next_edge = std::upper_bound(edges.begin(), edges.end(), Value(begin)) - edges.begin();
    WarmUp(Value(begin), next_edge);
    size_t row_v = 0, row_x = 0;
    bool is_first = true;
    while (row_v < stamps_.velocity.size() || row_x < stamps_.displacement.size()) {
      const double s = Value(begin);
      const double command = next_edge > 0 ? inputs_.command.value[next_edge - 1] : 0.0;
      const double edge = next_edge < edges.size() ? edges[next_edge] : s + 1.0;
      const double longest = LongestStep(command, s);
      if (!(longest > kShortestStep)) return false;
      const double num_steps = std::max(1.0, std::ceil((edge - s) / longest * (1.0 - 1e-9)));
      const double end = num_steps == 1.0 ? edge : s + (edge - s) / num_steps;
      const bool ok =
          is_first ? Step(command, begin, T(end) - begin) : Step(command, begin, end - s);
      if (!ok) return false;
      const T duration = is_first ? T(T(end) - begin) : T(end - s);
      EmitVelocities(begin, duration, end, &row_v, emit_velocity);
      EmitDisplacements(begin, duration, end, &row_x, emit_displacement);
      if (follows_reading_) AdvanceReading(T(end), duration);
      begin = T(end);
      is_first = false;
      if (num_steps == 1.0) ++next_edge;
    }
    return true;
  }

 private:
  static constexpr size_t kMostEffects = 6;
  static constexpr double kLongestStep = 0.1;     // [s]
  static constexpr double kRateTimesStep = 0.25;  // at most
  // What a vehicle in water does takes longer than a few of these; a search that gets here has run
  // away to where inertia and a resistance stand in for one another, at hundreds of steps a second.
  static constexpr double kShortestStep = 2.5e-3;  // [s]
  static constexpr double kLargestSpeed = 1e6;     // [m/s] or [rad/s]; beyond, it has diverged
  static constexpr double kWarmUp = 60.0;          // [s] before the start, for what has a memory

  struct State {
    T velocity{0.0};
    T position{0.0};
    std::vector<T> memory;  // of each effect; empty if none has one
  };

  static double Value(double x) { return x; }
  template <typename J>
  static double Value(const J& x) {
    return x.a;
  }

  // `s` on the command's clock.
  const Instant<T>& At(size_t k, const T& s) {
    return moves_stamps_ ? AtTime(k, T(s + delay_)) : AtTime(k, s);
  }

  // `t` in log time.
  const Instant<T>& AtTime(size_t k, const T& t) {
    now_[k].time = t - time_zero_;
    if (!partners_[k].empty()) now_[k].partner = partners_[k].At(t, Value(t), held_time_);
    return now_[k];
  }

  using ThrusterStates = std::array<T, kMostEffects>;

  // The mean force of a step in which `command` is held; moves the thrusters' states on.
  T MeanForce(double command, const T& begin, const T& duration, ThrusterStates* thrust) {
    T force(command);
    for (size_t k = 0; k < model_.effects.size(); ++k) {
      const ScalarEffect<T>& effect = model_.effects[k];
      const EffectHooks& has = effect.laws->has;
      const T* const p = effect.parameters.data();
      if (has.thrust) {
        force = effect.law->Thrust(p, effect.setting, force, At(k, T(begin + 0.5 * duration)));
      }
      if (has.follow) force = effect.law->Follow(p, force, duration, &(*thrust)[k]);
    }
    return force;
  }

  // The thrusters' states at the start, from the command before it.
  void WarmUp(double start, size_t next_edge) {
    const std::vector<double>& edges = inputs_.command.time;
    size_t first = next_edge;
    while (first > 0 && edges[first - 1] > start - kWarmUp) --first;
    if (first > 0 && first == next_edge) --first;
    const double command_before = first > 0 ? inputs_.command.value[first - 1] : 0.0;
    for (T& state : thrust_) state = T(0.0);
    // Long enough for any thruster to have reached what was commanded before.
    constexpr double kForEver = 1e6;
    if (first < next_edge) MeanForce(command_before, T(edges[first]), T(kForEver), &thrust_);
    for (size_t i = first; i < next_edge; ++i) {
      const double end = i + 1 < next_edge ? edges[i + 1] : start;
      if (end > edges[i])
        MeanForce(inputs_.command.value[i], T(edges[i]), T(end - edges[i]), &thrust_);
    }
  }

  // A water effect's state at the start, from the velocity measured before it.
  T RememberedBefore(const ScalarEffect<T>& effect) const {
    const SampledSignal& measured = inputs_.velocity[Index(inputs_.dof)];
    if (measured.time.empty() || !(measured.time.front() < stamps_.start)) {
      return model_.initial_velocity;
    }
    const double first = std::max(measured.time.front(), stamps_.start - kWarmUp);
    const double num_steps = std::ceil((stamps_.start - first) / kLongestStep);
    const double h = (stamps_.start - first) / num_steps;
    std::size_t place = 0;
    T memory(LineAt(measured, first, &place).value);
    for (double i = 0.0; i < num_steps; ++i) {
      const auto rate = [&](double share, const T& at) {
        const T speed(LineAt(measured, first + h * (i + share), &place).value);
        return effect.law->MemoryRate(effect.parameters.data(), at, speed);
      };
      const T k1 = rate(0.0, memory);
      const T k2 = rate(0.5, T(memory + 0.5 * h * k1));
      const T k3 = rate(0.5, T(memory + 0.5 * h * k2));
      const T k4 = rate(1.0, T(memory + h * k3));
      memory = memory + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    return memory;
  }

  T Acceleration(const State& at, const T& mean_force, const T& s) {
    T relative = at.velocity;
    T force = mean_force;
    T resistance(0.0);
    if (acts_on_water_) {
      for (size_t k = 0; k < model_.effects.size(); ++k) {
        const ScalarEffect<T>& effect = model_.effects[k];
        if (!effect.laws->has.relative_speed) continue;
        relative = effect.law->RelativeSpeed(effect.parameters.data(), relative);
      }
      water_.speed = at.velocity;
      water_.relative_speed = relative;
      water_.position = at.position;
    }
    for (size_t k = 0; k < model_.effects.size(); ++k) {
      const ScalarEffect<T>& effect = model_.effects[k];
      const T* const p = effect.parameters.data();
      if (effect.laws->has.thrust_at_speed) {
        force = effect.law->ThrustAtSpeed(p, force, at.velocity);
      }
      if (!effect.laws->has.resistance) continue;
      if (has_memory_) water_.memory = at.memory[k];
      resistance = resistance + effect.law->Resistance(p, effect.setting, water_, At(k, s));
    }
    return model_.baseline.Acceleration(relative, T(force - resistance));
  }

  void Slope(const State& at, const T& mean_force, const T& s, State* slope) {
    slope->velocity = Acceleration(at, mean_force, s);
    if (needs_position_) slope->position = at.velocity;
    for (size_t k = 0; k < at.memory.size(); ++k) {
      const ScalarEffect<T>& effect = model_.effects[k];
      if (!effect.laws->has.memory_rate) continue;
      slope->memory[k] =
          effect.law->MemoryRate(effect.parameters.data(), at.memory[k], at.velocity);
    }
  }

  template <typename H>
  void Move(const State& from, const H& h, const State& slope, State* to) const {
    to->velocity = from.velocity + h * slope.velocity;
    if (needs_position_) to->position = from.position + h * slope.position;
    for (size_t k = 0; k < from.memory.size(); ++k) {
      to->memory[k] = from.memory[k] + h * slope.memory[k];
    }
  }

  // One step of the classical scheme; keeps both ends for the outputs in between.
  template <typename H>
  bool Step(double command, const T& begin, const H& h) {
    held_time_ = Value(begin) + 0.5 * Value(T(h)) + Value(delay_);
    thrust_before_ = thrust_;
    command_ = command;
    force_ = MeanForce(command, begin, T(h), &thrust_);
    before_ = state_;
    const T middle = begin + 0.5 * h;
    Slope(before_, force_, begin, &k1_);
    Move(before_, H(0.5 * h), k1_, &trial_);
    Slope(trial_, force_, middle, &k2_);
    Move(before_, H(0.5 * h), k2_, &trial_);
    Slope(trial_, force_, middle, &k3_);
    Move(before_, h, k3_, &trial_);
    Slope(trial_, force_, T(begin + h), &k4_);
    Move(before_, H(h / 6.0), k1_, &state_);
    Move(state_, H(h / 3.0), k2_, &state_);
    Move(state_, H(h / 3.0), k3_, &state_);
    Move(state_, H(h / 6.0), k4_, &state_);
    return std::abs(Value(state_.velocity)) < kLargestSpeed;
  }

  // The water's quickest rate now and about rest, where friction turns.
  double LongestStep(double command, double s) {
    const double inertia = Value(model_.baseline.inertia);
    const double v = Value(state_.velocity);
    const double d_L = Value(model_.baseline.linear_damping);
    const double d_Q = Value(model_.baseline.quadratic_damping);
    const double reached =
        std::abs(v) + std::abs(command - Value(model_.baseline.buoyancy)) * kLongestStep / inertia;
    double rate = std::abs(d_L + 2.0 * d_Q * reached) / inertia;
    if (acts_on_water_) rate = std::max(rate, WaterRate(command, s));
    return std::min(kLongestStep, kRateTimesStep / rate);
  }

  // With the effects. It costs as much as a step: where it is far from shortening one it is looked
  // at now and then.
  double WaterRate(double command, double s) {
    constexpr int kLookAgain = 5;  // steps
    if (5.0 * water_rate_ * kLongestStep < kRateTimesStep && ++since_look_ < kLookAgain) {
      return water_rate_;
    }
    since_look_ = 0;
    water_rate_ = 0.0;
    constexpr double kProbe = 1e-4;  // of speed
    for (const double at : {Value(state_.velocity), 0.0}) {
      State here = state_;
      State there = state_;
      here.velocity = T(at - kProbe);
      there.velocity = T(at + kProbe);
      const double a0 = Value(Acceleration(here, T(command), T(s)));
      const double a1 = Value(Acceleration(there, T(command), T(s)));
      water_rate_ = std::max(water_rate_, std::abs(a1 - a0) / (2.0 * kProbe));
    }
    return water_rate_;
  }

  T Reading(const T& velocity, const T& time) {
    T reading = velocity;
    for (size_t k = 0; k < model_.effects.size(); ++k) {
      const ScalarEffect<T>& effect = model_.effects[k];
      if (!effect.laws->has.reading) continue;
      reading =
          effect.law->Reading(effect.parameters.data(), effect.setting, reading, AtTime(k, time));
    }
    return reading;
  }

  // A cubic from (y0, slope0) to (y1, slope1) at the share `x` of `h`.
  template <typename X>
  static T Cubic(
      const T& y0, const T& slope0, const T& y1, const T& slope1, const T& h, const X& x) {
    const X x2 = x * x;
    const X x3 = x2 * x;
    return y0 + (y1 - y0) * X(3.0 * x2 - 2.0 * x3) + h * slope0 * X(x - 2.0 * x2 + x3) +
           h * slope1 * X(x3 - x2);
  }

  template <typename Emit>
  void EmitVelocities(
      const T& begin, const T& duration, double end, size_t* row, const Emit& emit) {
    const double shift = Value(delay_);
    bool has_slope = false;
    T slope_after(0.0);
    for (; *row < stamps_.velocity.size(); ++*row) {
      const double t = stamps_.velocity[*row];
      if (t - shift > end + 1e-9) return;
      T velocity = state_.velocity;
      if (moves_stamps_ || t - shift < end - 1e-9) {
        if (!has_slope) slope_after = Acceleration(state_, force_, T(end));
        has_slope = true;
        const auto at = [&](const auto& x) {
          return Cubic(before_.velocity, k1_.velocity, state_.velocity, slope_after, duration, x);
        };
        velocity = moves_stamps_ || Value(begin) == Value(stamps_.start - delay_)
                       ? at(T((t - delay_ - begin) / duration))
                       : at((t - shift - Value(begin)) / Value(duration));
      }
      const T since = t - delay_ - begin;
      if (follows_force_ && Value(since) > 1e-9) {
        // A force with a memory is not even over the step: its own impulse so far.
        ThrusterStates thrust = thrust_before_;
        const T mean_so_far = MeanForce(command_, begin, since, &thrust);
        velocity = velocity + (mean_so_far - force_) * since / model_.baseline.inertia;
      }
      T reading = Reading(velocity, T(t));
      if (follows_reading_) {
        if (Value(since) > 1e-9) {
          T shown = shown_;
          Show(reading, since, &shown);
          reading = shown;
        } else {
          reading = shown_;
        }
      }
      emit(*row, reading);
    }
  }

  void Show(const T& reading, const T& duration, T* shown) {
    T begin = reading_, end = reading;
    for (const ScalarEffect<T>& effect : model_.effects) {
      if (!effect.laws->has.follow_reading) continue;
      effect.law->FollowReading(effect.parameters.data(), begin, end, duration, shown);
    }
  }

  void AdvanceReading(const T& end, const T& duration) {
    const T reading = Reading(state_.velocity, T(end + delay_));
    Show(reading, duration, &shown_);
    reading_ = reading;
  }

  template <typename Emit>
  void EmitDisplacements(
      const T& begin, const T& duration, double end, size_t* row, const Emit& emit) {
    const T shift = delay_ + pose_delay_;
    for (; *row < stamps_.displacement.size(); ++*row) {
      const double stamp = stamps_.displacement[*row];
      if (stamp - Value(shift) > end + 1e-9) return;
      T position = state_.position;
      const T since = stamp - shift - begin;
      if (Value(since) < 0.0) {  // before the start: as it was moving then
        position = before_.position + since * before_.velocity;
      } else if (moves_stamps_) {
        position = Cubic(before_.position,
                         before_.velocity,
                         state_.position,
                         state_.velocity,
                         duration,
                         T(since / duration));
      } else if (Value(since) < Value(duration) - 1e-9) {
        position = Cubic(before_.position,
                         before_.velocity,
                         state_.position,
                         state_.velocity,
                         duration,
                         Value(since) / Value(duration));
      }
      T displacement = position - model_.initial_position;
      for (size_t k = 0; k < model_.effects.size(); ++k) {
        const ScalarEffect<T>& effect = model_.effects[k];
        if (!effect.laws->has.displacement) continue;
        displacement = effect.law->Displacement(
            effect.parameters.data(), displacement, AtTime(k, T(stamp - pose_delay_)));
      }
      emit(*row, T(displacement + model_.initial_position));
    }
  }

  const EffectInputs& inputs_;
  const ScalarModel<T> model_;
  const OutputStamps& stamps_;
  std::array<PartnerSignals, kMostEffects> partners_;
  double time_zero_ = 0.0;  // of the effects' time, in log time [s]
  T delay_{0.0};            // of the command [s]
  T pose_delay_{0.0};       // of the poses' stamps [s]
  bool needs_position_;     // for the outputs or for a force that may depend on it
  bool acts_on_water_ = false;
  bool has_memory_ = false;
  bool follows_force_ = false;
  bool follows_reading_ = false;
  bool moves_stamps_ = false;

  // Numbers with derivatives are large: what every step needs is made once and kept.
  State state_, before_;             // at both ends of the present step
  State k1_, k2_, k3_, k4_, trial_;  // the scheme's slopes, and where the next one is taken
  WaterState<T> water_;
  std::array<Instant<T>, kMostEffects> now_;
  double command_ = 0.0;                   // held over the present step [N] or [N m]
  double held_time_ = 0.0;                 // middle of the present step, in log time [s]
  T force_{0.0};                           // mean over the step
  ThrusterStates thrust_, thrust_before_;  // at both ends of the present step
  double water_rate_ = std::numeric_limits<double>::infinity();  // when last looked at [1/s]
  int since_look_ = 0;                                           // steps
  T reading_{0.0};  // of the velocity at the step's begin, before any lag
  T shown_{0.0};    // what the lagging sensor shows there
};

}  // namespace fathom
