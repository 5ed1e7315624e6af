// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/synthesize/experiment/experiment.h"
#include "fathom/synthesize/motion/coupled_truth.h"

#include <cstdint>

namespace fathom {

// The streams of a coupled vehicle's log, in log time. Those of the motion as measured_streams.h.

// Thrusters as thruster_1, ... [N] with the forces that they make, or the driven forces; every fin.
void AddCoupledCommand(const CoupledTruth& truth,
                       const Vehicle& vehicle,
                       const Experiment& experiment,
                       Log* log);

// The experiment has a velocity sensor. Throws InputError if that is to measure a DOF that the
// model does not move.
Stream CoupledVelocityStream(const CoupledTruth& truth,
                             const Experiment& experiment,
                             std::uint64_t seed,
                             Log& log);

// The experiment has a pose sensor.
Stream CoupledPoseStream(const CoupledTruth& truth,
                         const Experiment& experiment,
                         std::uint64_t seed,
                         Log& log);

}  // namespace fathom
