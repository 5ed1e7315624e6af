// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/effects/sensor_effects.h"

#include "fathom/vehicle/effect_of.h"
#include "fathom/vehicle/effects/quantities.h"
#include "fathom/vehicle/effects/switched_on.h"

#include <array>
#include <cmath>
#include <limits>

#include <ceres/jet.h>

namespace fathom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAny = std::numeric_limits<double>::quiet_NaN();

struct SensorMisalignment {
  static EffectInfo Info() {
    return {.name = "sensor_misalignment",
            .place = Place::kSensor,
            .scope = Scope::kVehicle,
            .parameters =
                {{.name = "angle", .quantity = kAngle, .null = 0.0, .lower = -0.8, .upper = 0.8}},
            .has_partner = true,
            .cause = "the velocity sensor is mounted turned",
            .advice = "Correct the sensor's mounting angle."};
  }
  // y = v cos a + v_j sin a, and what is known of v_j is its own reading y_j = v_j cos a - v sin a.
  template <typename T>
  static T Reading(const T* p, const EffectSetting&, const T& reading, const Instant<T>& now) {
    using std::cos;
    using std::tan;
    return reading / cos(p[0]) + now.partner.velocity * tan(p[0]);
  }
};

// The reading of a sensor at r in a vehicle that turns with omega: v + omega x r. The partner is
// the rotation, and the arm is the coordinate of r that it acts on.
struct LeverArm {
  static EffectInfo Info() {
    return {.name = "lever_arm",
            .place = Place::kSensor,
            .scope = Scope::kVehicle,
            .parameters =
                {{.name = "arm", .quantity = kArm, .null = 0.0, .lower = -10.0, .upper = 10.0}},
            .has_partner = true,
            .cause = "the velocity sensor sits off the vehicle's centre",
            .advice = "Correct the sensor's position in the vehicle."};
  }
  static double Sign(const EffectSetting& setting) {
    const bool is_negative = (setting.dof == Dof::kSurge && setting.partner == Dof::kYaw) ||
                             (setting.dof == Dof::kSway && setting.partner == Dof::kRoll) ||
                             (setting.dof == Dof::kHeave && setting.partner == Dof::kPitch);
    return is_negative ? -1.0 : 1.0;
  }
  template <typename T>
  static T Reading(const T* p,
                   const EffectSetting& setting,
                   const T& reading,
                   const Instant<T>& now) {
    return reading + Sign(setting) * p[0] * now.partner.velocity;
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
                            .upper = kInfinity}},
            .cause = "the velocity sensor shows a speed at rest",
            .advice = "Calibrate the sensor's zero before the run."};
  }
  template <typename T>
  static T Reading(const T* p, const EffectSetting&, const T& reading, const Instant<T>&) {
    return reading + p[0];
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
                            .trials = {0.1, 0.3, 1.0, 3.0}}},
            .cause = "the velocity that was logged is smoothed and so comes late",
            .advice = "Log the raw sensor, or turn the estimator's smoothing down."};
  }
  // T dy/dt = v - y for a v that goes in a straight line.
  template <typename T>
  static void FollowReading(const T* p, const T& begin, const T& end, const T& duration, T* state) {
    using std::exp;
    const T slope = (end - begin) / duration;
    if (p[0] < T(1e-3) * duration) {
      *state = end - slope * p[0];
      return;
    }
    const T kept = exp(-duration / p[0]);
    *state = end - slope * p[0] + (*state - begin + slope * p[0]) * kept;
  }
};

struct SensorClockOffset {
  static EffectInfo Info() {
    return {.name = "sensor_clock_offset",
            .place = Place::kSensor,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "offset",
                            .quantity = kDuration,
                            .null = 0.0,
                            .lower = -5.0,
                            .upper = 5.0,
                            .search = Search::kSize,
                            .trials = {-1.0, -0.1, 0.1, 1.0}}},
            .needs_pose = true,
            .cause = "the poses carry the stamps of another clock than the velocities",
            .advice = "Synchronise the camera's clock with the vehicle's."};
  }
  template <typename T>
  static T PoseDelay(const T* p) {
    return p[0];
  }
};

struct PoseScale {
  static EffectInfo Info() {
    return {.name = "pose_scale",
            .place = Place::kSensor,
            .scope = Scope::kVehicle,
            .parameters =
                {{.name = "error", .quantity = kRatio, .null = 0.0, .lower = -0.7, .upper = 2.0}},
            .needs_pose = true,
            .cause = "the poses measure distances on another scale than the velocities",
            .advice = "Measure the marker, and calibrate the camera in the water."};
  }
  template <typename T>
  static T Displacement(const T* p, const T& displacement, const Instant<T>&) {
    return (1.0 + p[0]) * displacement;
  }
};

struct MarkerMoved {
  static EffectInfo Info() {
    return {.name = "marker_moved",
            .place = Place::kSensor,
            .scope = Scope::kRun,
            .parameters = {{.name = "jump",
                            .quantity = kLength,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity},
                           {.name = "time",
                            .quantity = kDuration,
                            .null = kAny,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .search = Search::kTimeOfRun}},
            .needs_pose = true,
            .cause = "a marker was moved during the run",
            .advice = "Look at the images about that time, and fasten the marker."};
  }
  template <typename T>
  static T Displacement(const T* p, const T& displacement, const Instant<T>& now) {
    return displacement + p[0] * SwitchedOn(T(now.time - p[1]));
  }
};

}  // namespace

std::span<const Effect* const> SensorEffects() {
  static const EffectOf<SensorMisalignment> misalignment;
  static const EffectOf<LeverArm> lever_arm;
  static const EffectOf<SensorBias> bias;
  static const EffectOf<SensorLag> lag;
  static const EffectOf<SensorClockOffset> clock_offset;
  static const EffectOf<PoseScale> pose_scale;
  static const EffectOf<MarkerMoved> marker_moved;
  static const std::array<const Effect*, 7> effects = {
      &misalignment, &lever_arm, &bias, &lag, &clock_offset, &pose_scale, &marker_moved};
  return effects;
}

}  // namespace fathom
