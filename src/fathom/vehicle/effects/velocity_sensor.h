// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect_info.h"
#include "fathom/vehicle/effect_law.h"
#include "fathom/vehicle/effects/bounds.h"
#include "fathom/vehicle/effects/confusions.h"
#include "fathom/vehicle/effects/natural_units.h"
#include "fathom/vehicle/effects/quantities.h"

#include <cmath>

// What a velocity sensor makes of the motion. Equations: docs/effects.md.
namespace fathom {

struct SensorMisalignment {
  static EffectInfo Info() {
    return {.name = "sensor_misalignment",
            .place = Place::kSensor,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "angle",
                            .quantity = kAngle,
                            .null = 0.0,
                            .lower = -0.8,
                            .upper = 0.8,
                            .drawn = {0.04, 0.5, natural::One, true}}},
            .partner = PartnerInfo{.rule = IsOfOneKind, .velocity = true},
            .cause = "a velocity sensor that is mounted at an angle",
            .advice = "Correct the sensor's mounting angle."};
  }
  static bool IsOfOneKind(Dof dof, Dof partner) { return IsAngular(dof) == IsAngular(partner); }
  // What is known of the partner's velocity v_j is its own reading y_j = v_j cos a - v sin a.
  template <typename T>
  static EffectLaw<T> Law() {
    return {.reading =
                [](const T* p, const EffectSetting&, const T& reading, const Instant<T>& now) {
                  using std::cos;
                  using std::tan;
                  return reading / cos(p[0]) + now.partner.velocity * tan(p[0]);
                },
            .both_readings =
                [](const T* p, T* reading, T* partner_reading) {
                  using std::cos;
                  using std::sin;
                  const T v = *reading, v_j = *partner_reading;
                  *reading = v * cos(p[0]) + v_j * sin(p[0]);
                  *partner_reading = v_j * cos(p[0]) - v * sin(p[0]);
                }};
  }
};

// The reading of a sensor at r in a vehicle that turns with omega: v + omega x r. The partner is
// the rotation, and the arm is the coordinate of r that it acts on.
struct LeverArm {
  static EffectInfo Info() {
    return {.name = "lever_arm",
            .place = Place::kSensor,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "arm",
                            .quantity = kArm,
                            .null = 0.0,
                            .lower = -10.0,
                            .upper = 10.0,
                            .drawn = {0.05, 0.8, natural::Arm, true}}},
            .partner = PartnerInfo{.rule = IsAnotherAxis, .velocity = true},
            .cause = "a velocity sensor away from the vehicle's centre",
            .advice = "Correct the sensor's position in the vehicle."};
  }
  static bool IsAnotherAxis(Dof dof, Dof partner) {
    return !IsAngular(dof) && IsAngular(partner) && Index(partner) != Index(dof) + 3;
  }
  static double Sign(const EffectSetting& setting) {
    const bool is_negative = (setting.dof == Dof::kSurge && setting.partner == Dof::kYaw) ||
                             (setting.dof == Dof::kSway && setting.partner == Dof::kRoll) ||
                             (setting.dof == Dof::kHeave && setting.partner == Dof::kPitch);
    return is_negative ? -1.0 : 1.0;
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {
        .reading =
            [](const T* p, const EffectSetting& setting, const T& reading, const Instant<T>& now) {
              return reading + Sign(setting) * p[0] * now.partner.velocity;
            }};
  }
};

struct SensorBias {
  static EffectInfo Info() {
    return {.name = "sensor_bias",
            .place = Place::kSensor,
            .scope = Scope::kRun,
            .parameters = {{.name = "bias",
                            .quantity = kSpeed,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity,
                            .drawn = {0.03, 0.5, natural::Speed, true}}},
            .cause = "a bias of the velocity sensor",
            .advice = "Calibrate the sensor's zero before the run.",
            .confusions = {&kSpeedAtRest}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.reading = [](const T* p, const EffectSetting&, const T& reading, const Instant<T>&) {
      return reading + p[0];
    }};
  }
};

struct SensorLag {
  static EffectInfo Info() {
    return {.name = "sensor_lag",
            .place = Place::kSensor,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "time_constant",
                            .quantity = kDuration,
                            .null = 0.0,
                            .lower = 0.0,
                            .upper = 20.0,
                            .search = Search::kSize,
                            .trials = {0.1, 0.3, 1.0, 3.0},
                            .drawn = {0.1, 2.0, natural::One}}},
            .cause = "a lag of the velocity measurement, as smoothing causes it",
            .advice = "Log the raw sensor, or reduce the smoothing of the estimator.",
            .confusions = {&kWhichLag, &kLateReading}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {// T dy/dt = v - y for a v that goes in a straight line.
            .follow_reading =
                [](const T* p, const T& begin, const T& end, const T& duration, T* state) {
                  using std::exp;
                  const T slope = (end - begin) / duration;
                  if (p[0] < T(1e-3) * duration) {
                    *state = end - slope * p[0];
                    return;
                  }
                  const T kept = exp(-duration / p[0]);
                  *state = end - slope * p[0] + (*state - begin + slope * p[0]) * kept;
                }};
  }
};

}  // namespace fathom
