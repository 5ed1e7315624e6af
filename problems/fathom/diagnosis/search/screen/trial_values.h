// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/force_response.h"
#include "fathom/diagnosis/search/suspect.h"

#include <vector>

namespace fathom {

// A run's own scales.
struct RunScale {
  double force = 1.0;                        // RMS of the command [N] or [N m]
  double speed = 1.0;                        // RMS [m/s] or [rad/s]
  double first_time = 0.0, last_time = 1.0;  // since the first command sample [s]
};

// Of all logs but for the times, which are of one where the suspect acts there alone.
RunScale ScaleOf(const TrainingData& data, const ForceResponse& response, const Suspect& suspect);

// The same of the measured motion.
RunScale MeasuredScale(const TrainingData& data);

// Between neighbouring times of the run that are tried [s].
double SpacingOfTimes(const RunScale& scale);

// The values at which a parameter is tried; docs/diagnosis.md (4).
std::vector<double> ValuesToTry(const EffectParameter& parameter,
                                const TrainingData& data,
                                const RunScale& scale);

// All combinations of these values of an effect's parameters.
std::vector<std::vector<double>> CombinationsOf(const EffectInfo& info,
                                                const TrainingData& data,
                                                const RunScale& scale);

}  // namespace fathom
