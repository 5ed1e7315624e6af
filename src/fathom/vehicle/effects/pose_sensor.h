// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect_info.h"
#include "fathom/vehicle/effect_law.h"
#include "fathom/vehicle/effects/bounds.h"
#include "fathom/vehicle/effects/natural_units.h"
#include "fathom/vehicle/effects/quantities.h"
#include "fathom/vehicle/effects/switched_on.h"

// What poses make of the motion. Equations: docs/effects.md.
namespace fathom {

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
                            .trials = {-1.0, -0.1, 0.1, 1.0},
                            .drawn = {0.1, 1.5, natural::One, true}}},
            .needs_pose = true,
            .cause = "a clock offset between poses and velocities",
            .advice = "Synchronise the camera's clock with the vehicle's."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.pose_delay = [](const T* p) { return p[0]; }};
  }
};

struct PoseScale {
  static EffectInfo Info() {
    return {.name = "pose_scale",
            .place = Place::kSensor,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "error",
                            .quantity = kRatio,
                            .null = 0.0,
                            .lower = -0.7,
                            .upper = 2.0,
                            .drawn = {0.02, 0.3, natural::One, true}}},
            .needs_pose = true,
            .is_like_lost_motion = true,
            .cause = "a scale error between poses and velocities",
            .advice = "Measure the marker, and calibrate the camera in the water."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.displacement = [](const T* p, const T& displacement, const Instant<T>&) {
      return (1.0 + p[0]) * displacement;
    }};
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
                            .upper = kInfinity,
                            .drawn = {0.1, 2.0, natural::Speed, true}},
                           {.name = "time",
                            .quantity = kDuration,
                            .null = kAny,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .search = Search::kTimeOfRun,
                            .drawn = {0.2, 0.8, natural::Duration}}},
            .needs_pose = true,
            .cause = "a marker that was moved during the run",
            .advice = "Look at the images about that time, and fasten the marker."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.displacement = [](const T* p, const T& displacement, const Instant<T>& now) {
      return displacement + p[0] * SwitchedOn(T(now.time - p[1]));
    }};
  }
};

}  // namespace fathom
