// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/held_command.h"

#include <cstddef>
#include <random>
#include <vector>

#include "camera_experiment.h"

namespace fathom {

inline constexpr double kTrueStep = 0.0025;  // of the integration [s]

// What a vehicle truly does along its DOF.
struct TrueMotion {
  std::vector<double> x, v, a;  // every kTrueStep
  HeldCommand command;
};

TrueMotion Move(const CameraExperiment& experiment,
                const UncoupledModel<double>& m,
                std::mt19937* generator);

// What a held coordinate does, every kTrueStep, with standard deviation 1.
std::vector<double> Wander(WanderKind kind, size_t n, std::mt19937* generator);

// How a pendulum of this natural frequency [rad/s] and damping ratio follows `push`, every
// kTrueStep; it would rest where the push is constant.
std::vector<double> Swing(const std::vector<double>& push, double frequency, double ratio);

struct TrueState {
  double displacement = 0.0, speed = 0.0;
};

// Cubic Hermite between the steps of the integration: at share `s` behind step `i`.
TrueState StateAt(const TrueMotion& motion, size_t i, double s);

}  // namespace fathom
