// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/simulate/experiment.h"
#include "fathom/vehicle/vehicle_file.h"

#include <cstdint>

namespace fathom {

// The log of an experiment with a vehicle that is known, so that an identifier's answer can be
// compared with the truth. docs/synthesize.md.
//
// A pure function: the same vehicle, experiment and seed give the same log. Every source of chance
// has a stream of random numbers of its own, named after its purpose.
//
// Throws InputError if the vehicle has no model of a driven DOF, or a controlled DOF's axis would
// be turned by another one.
Log Synthesize(const Vehicle& vehicle, const Experiment& experiment, std::uint64_t seed);

}  // namespace fathom
