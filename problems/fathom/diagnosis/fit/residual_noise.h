// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/training_data.h"
#include "fathom/noise/noise_model.h"

#include <Eigen/Core>

namespace fathom {

// The white noise that a sensor has at the least: 1e-4 of the motion that it shows, in speed, or in
// what that covers in a second. No real one is as quiet. Of data of a simulation without noise only
// rounding and integration would be left, and pass for structure.
NoiseModel QuietestSensors(const TrainingData& data);

// As if all of a residual were white: its RMS, channel by channel; at least 1e-12.
NoiseModel WhiteNoise(const TrainingData& data, const Eigen::VectorXd& residual);

// White noise as a sensor alone would have it, from the residual's second differences, which
// structure hardly reaches: under it nothing that is missing passes for a disturbance. At least
// that of QuietestSensors().
NoiseModel SensorNoiseOnly(const TrainingData& data, const Eigen::VectorXd& residual);

}  // namespace fathom
