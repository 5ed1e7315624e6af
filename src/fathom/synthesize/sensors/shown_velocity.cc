// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/sensors/shown_velocity.h"

#include <algorithm>
#include <tuple>

namespace fathom {
namespace {

constexpr double kLongestShownStep = 5e-3;  // [s]

}  // namespace

ShownVelocity::ShownVelocity(const VehicleMotion& motion, const TrueRun& run)
    : motion_(motion), run_(run) {
  for (const Dof dof : kAllDofs) {
    std::tie(turning_[Index(dof)], others_[Index(dof)]) =
        motion.hidden(dof).SplitBy(&EffectLaw<double>::both_readings);
    if (motion.hidden(dof).Has(&EffectLaw<double>::follow_reading)) following_.push_back(dof);
  }
  last_ = ReadingsOf(run.states.front(), run.held.front(), 0.0);
  shown_ = last_;
}

ShownVelocity::Readings ShownVelocity::ReadingsOf(const MotionState& state,
                                                  const HeldForces& held,
                                                  double t) const {
  Readings readings;
  std::copy(state.velocity.begin(), state.velocity.end(), readings.begin());
  const Surroundings now = {t, state.velocity, held.sent};
  for (const HiddenEffects& turning : turning_) turning.TurnReadings(readings.data());
  for (const Dof dof : kAllDofs) {
    const HiddenEffects& others = others_[Index(dof)];
    readings[Index(dof)] = others.Reading(readings[Index(dof)], InstantsOf(others, now));
  }
  return readings;
}

// Moves the lagging sensors on to `t`, where `readings` are without lag.
void ShownVelocity::Follow(const Readings& readings, double t) {
  if (t > time_) {
    Readings shown = readings;
    for (const Dof dof : following_) {
      const int i = Index(dof);
      shown[i] = shown_[i];
      motion_.hidden(dof).FollowReading(last_[i], readings[i], t - time_, &shown[i]);
    }
    shown_ = shown;
  }
  last_ = readings;
  time_ = t;
}

std::array<double, 6> ShownVelocity::At(double t) {
  if (!following_.empty()) {
    while (time_ < t) {
      const double event = place_ + 1 < run_.time.size() ? run_.time[place_ + 1] : t;
      const double next = std::min(event, time_ + kLongestShownStep);
      if (next >= t) break;
      const MotionState state = run_.StateAt(motion_, place_, next);
      Follow(ReadingsOf(state, run_.held[place_], next), next);
      place_ = run_.Before(next, place_);
    }
  }
  place_ = run_.Before(t, place_);
  const Readings readings = ReadingsOf(run_.StateAt(motion_, place_, t), run_.held[place_], t);
  if (following_.empty()) return readings;
  Follow(readings, t);
  return shown_;
}

}  // namespace fathom
