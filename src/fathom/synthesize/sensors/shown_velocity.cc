// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/sensors/shown_velocity.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

constexpr double kLongestStep = 5e-3;  // [s]

}  // namespace

ShownVelocity::ShownVelocity(const VehicleMotion& motion, const TrueRun& run)
    : motion_(motion), run_(run) {
  for (const Dof dof : kAllDofs) {
    for (const ActiveEffect& active : motion.chain(dof).effects()) {
      const EffectHooks& has = active.effect->laws().has;
      if (active.effect->info().name == "sensor_misalignment") {
        turned_.push_back(active);
      } else if (has.reading) {
        reading_.push_back(active);
      }
      if (has.follow_reading) following_.push_back(active);
    }
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
  // A turned sensor shows both of its axes turned.
  for (const ActiveEffect& active : turned_) {
    const double angle = active.values[0];
    double& v = readings[Index(active.setting.dof)];
    double& v_j = readings[Index(active.setting.partner)];
    const double y = v * std::cos(angle) + v_j * std::sin(angle);
    v_j = v_j * std::cos(angle) - v * std::sin(angle);
    v = y;
  }
  for (const ActiveEffect& active : reading_) {
    double& reading = readings[Index(active.setting.dof)];
    reading = active.effect->laws().In<double>().Reading(
        active.values.data(), active.setting, reading, InstantOf(active, now));
  }
  return readings;
}

// Moves the lagging sensors on to `t`, where `readings` are without lag.
void ShownVelocity::Follow(const Readings& readings, double t) {
  if (t > time_) {
    Readings begin = last_, end = readings;
    Readings shown = readings;
    for (const ActiveEffect& active : following_) {
      const int i = Index(active.setting.dof);
      shown[i] = shown_[i];
      active.effect->laws().In<double>().FollowReading(
          active.values.data(), begin[i], end[i], t - time_, &shown[i]);
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
      const double next = std::min(event, time_ + kLongestStep);
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
