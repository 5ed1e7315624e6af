// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/synthesize/experiment/experiment.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/files/vehicle_file.h"
#include "fathom/vehicle/scales.h"

#include <array>
#include <cstdint>
#include <span>

namespace fathom {

// The log of an experiment with a vehicle that is known, so that an identifier's answer can be
// compared with the truth. docs/synthesize.md.
//
// `effects` are hidden in it, each in the DOF that its setting names, in the order in which they
// act whatever their order here. Each has its values, in the order of its parameters; the
// setting's reference force is the RMS command of ScalesOf().
//
// A pure function: the same vehicle, experiment, effects and seed give the same log. Every source
// of chance has a stream of random numbers of its own, named after its purpose.
//
// A vehicle with a coupled model moves by RunCoupled(); its log holds all DOFs of the model, and
// the thrusts [N] where the experiment drives thrusters. Other vehicles move by code of their own.
//
// Throws InputError if the vehicle has no model of a driven DOF, a controlled DOF's axis would be
// turned by another one, or an effect is of a DOF that is not driven or of a pose that is not
// logged. Likewise if thrusters, fins or shafts are driven and the vehicle has no coupled model or
// none of that name, and if an effect or turbulence is to act on a coupled vehicle.
Log Synthesize(const Vehicle& vehicle,
               const Experiment& experiment,
               std::span<const ActiveEffect> effects,
               std::uint64_t seed);

// Nothing hidden.
Log Synthesize(const Vehicle& vehicle, const Experiment& experiment, std::uint64_t seed);

// The poses of the same run at the stamps of another sensor, without noise: world_from_body, with
// what effects on poses do to them. For cameras, docs/synthesize.md ("Camera logs").
Stream ShownPoses(const Vehicle& vehicle,
                  const Experiment& experiment,
                  std::span<const ActiveEffect> effects,
                  std::uint64_t seed,
                  const Sampling& sampling);

// How large things are in each DOF of an experiment in which nothing is hidden, by Index(Dof); 0
// where it is not driven. Of a vehicle without a coupled model. Throws as above.
std::array<Scales, 6> ScalesOf(const Vehicle& vehicle,
                               const Experiment& experiment,
                               std::uint64_t seed);

}  // namespace fathom
