// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/fitted_model.h"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace fathom {

inline constexpr double kGreatestRate = 10000.0;  // of what is measured [Hz]

// How the velocity will be measured. NaN: as in the model's log.
struct VelocityMeasurement {
  double rate = std::numeric_limits<double>::quiet_NaN();   // [Hz]
  double noise = std::numeric_limits<double>::quiet_NaN();  // standard deviation of a sample, white
                                                            // [m/s] or [rad/s]
};

// How the position will be measured, as by a camera and markers. An infinite noise: not at all.
struct PositionMeasurement {
  double rate = std::numeric_limits<double>::quiet_NaN();  // [Hz]; NaN: as the velocity
  double noise = std::numeric_limits<double>::infinity();  // standard deviation, white [m] or [rad]
};

// What an experiment along one DOF may do; docs/file_formats.md, "Limits".
struct PlanLimits {
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();

  double force = 0.0;                           // greatest, each way [N] or [N m]
  double speed = kNoLimit;                      // greatest, each way [m/s] or [rad/s]
  ValueRange distance = {-kNoLimit, kNoLimit};  // from the start [m] or [rad]
  double thruster_force = kNoLimit;             // greatest of each thruster, each way [N]
  double shortest_hold = 1.0;                   // of one force: the period of the command [s]
  std::optional<double> duration = {};          // [s]
  VelocityMeasurement velocity = {};
  PositionMeasurement position = {};
};

// What a log reached: its greatest force and speed, either way. The distance is not limited.
PlanLimits LimitsOfLog(const DataRange& range);

// Reads a limits file (YAML). Throws InputError, naming file, line and key, for whatever breaks
// the format.
PlanLimits ReadPlanLimits(const std::filesystem::path& path);

// The same from memory; `name` stands for the file in messages.
PlanLimits ParsePlanLimits(const std::string& name, const std::string& text);

// Throws InputError unless `value`, a rate [Hz] or a noise that the limits or the model's fit tell,
// is above 0 and at most `most`. `model`: the name of its file, `what`: "how much its fit missed",
// `key`: what the limits file may hold under velocity, "noise: 0.01".
void RequireMeasured(const std::string& model,
                     double value,
                     double most,
                     const std::string& what,
                     const std::string& key);

}  // namespace fathom
