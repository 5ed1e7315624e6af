// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/synthesize/experiment/experiment.h"
#include "fathom/synthesize/motion/true_run.h"
#include "fathom/synthesize/motion/vehicle_motion.h"

#include <cstdint>

namespace fathom {

// The streams of a log, from the truth: command.csv, velocity.csv and pose.csv in log time, of the
// driven DOFs, or those that the velocity sensor is to log. Drop-outs are remarked on in `log`.

Stream CommandStream(const TrueRun& truth, const Experiment& experiment);

// The experiment has a velocity sensor.
Stream VelocityStream(const VehicleMotion& motion,
                      const TrueRun& truth,
                      const Experiment& experiment,
                      std::uint64_t seed,
                      Log& log);

// The experiment has a pose sensor. Hidden clock offsets add up: a pose has one stamp.
Stream PoseStream(const VehicleMotion& motion,
                  const TrueRun& truth,
                  const Experiment& experiment,
                  std::uint64_t seed,
                  Log& log);

}  // namespace fathom
