// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/integration/instants.h"
#include "fathom/simulate/integration/run_step.h"
#include "fathom/simulate/integration/scalar_model.h"
#include "fathom/simulate/integration/water_integrator.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace fathom {

// What the velocity sensor shows of a run, from step to step.
template <typename T>
class ShownReadings {
 public:
  // All must outlive this. `start` [s] in log time, as the stamps.
  ShownReadings(const ScalarModel<T>& model,
                double start,
                const std::vector<double>& stamps,
                Instants<T>* instants)
      : model_(model),
        start_(start),
        stamps_(stamps),
        instants_(*instants),
        follows_force_(model.effects.Has(&EffectLaw<T>::follow)),
        follows_reading_(model.effects.Has(&EffectLaw<T>::follow_reading)) {
    reading_ = Reading(model.initial_velocity, T(start));
    shown_ = follows_reading_ ? T(reading_ + model.initial_reading_excess) : reading_;
  }

  // Whether all stamps were passed.
  bool empty() const { return row_ == stamps_.size(); }

  // Calls emit(row, reading) at every stamp up to the end of `step`, the one after the last given.
  template <typename Emit>
  void Pass(const RunStep<T>& step, WaterIntegrator<T>* water, const Emit& emit) {
    const double shift = Value(instants_.delay());
    bool has_slope = false;
    T slope_after(0.0);
    for (; row_ < stamps_.size(); ++row_) {
      const double t = stamps_[row_];
      if (t - shift > step.end + 1e-9) break;
      T velocity = step.after.velocity;
      if (instants_.moves_stamps() || t - shift < step.end - 1e-9) {
        if (!has_slope) slope_after = water->Acceleration(step.after, step.force, T(step.end));
        has_slope = true;
        velocity = VelocityWithin(step, slope_after, t);
      }
      const T since = t - instants_.delay() - step.begin;
      if (follows_force_ && Value(since) > 1e-9) {
        // A force with a memory is not even over the step: its own impulse so far.
        ThrusterStates<T> thrust = step.thrust;
        const T mean_so_far =
            MeanForce(model_.effects, step.command, step.begin, since, &instants_, &thrust);
        velocity = velocity + (mean_so_far - step.force) * since / model_.baseline.inertia;
      }
      emit(row_, Shown(Reading(velocity, T(t)), since));
    }
    if (!follows_reading_) return;
    const T reading = Reading(step.after.velocity, T(T(step.end) + instants_.delay()));
    model_.effects.FollowReading(reading_, reading, step.duration, &shown_);
    reading_ = reading;
  }

 private:
  T VelocityWithin(const RunStep<T>& step, const T& slope_after, double t) const {
    const T& delay = instants_.delay();
    if (step.stiff_rate != 0.0) {
      const T since = t - delay - step.begin;
      return step.before.velocity + Reach(step.stiff_rate, since) * step.slope.velocity;
    }
    const auto at = [&](const auto& x) {
      return Cubic(step.before.velocity,
                   step.slope.velocity,
                   step.after.velocity,
                   slope_after,
                   step.duration,
                   x);
    };
    return instants_.moves_stamps() || Value(step.begin) == Value(T(start_ - delay))
               ? at(T((t - delay - step.begin) / step.duration))
               : at((t - Value(delay) - Value(step.begin)) / Value(step.duration));
  }

  T Reading(const T& velocity, const T& t) {
    return model_.effects.Reading(
        velocity, [&](std::size_t k) -> const Instant<T>& { return instants_.InLogTime(k, t); });
  }

  // With the sensor's lag, `since` [s] the step's begin.
  T Shown(const T& reading, const T& since) const {
    if (!follows_reading_) return reading;
    T shown = shown_;
    if (Value(since) > 1e-9) model_.effects.FollowReading(reading_, reading, since, &shown);
    return shown;
  }

  const ScalarModel<T>& model_;
  const double start_;
  const std::vector<double>& stamps_;
  Instants<T>& instants_;
  const bool follows_force_;
  const bool follows_reading_;
  std::size_t row_ = 0;
  T reading_{0.0};  // of the velocity at the next step's begin, before any lag
  T shown_{0.0};    // what the lagging sensor shows there
};

}  // namespace fathom
