// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/sensors/coupled_streams.h"

#include "fathom/base/input_error.h"
#include "fathom/synthesize/experiment/resolution.h"
#include "fathom/synthesize/sensors/noisy_streams.h"
#include "fathom/vehicle/files/thruster_command.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

// A stream at the stamps of the command, without columns.
Stream AtCommand(const CoupledTruth& truth, const Experiment& experiment) {
  Stream stream;
  for (const double stamp : truth.inputs.command.time) {
    stream.time.push_back(RoundTo(experiment.start_time + stamp, kStampResolution));
  }
  return stream;
}

void AddColumn(Stream& stream, std::string name, std::vector<double> values) {
  stream.columns.push_back(std::move(name));
  stream.values.push_back(std::move(values));
}

}  // namespace

void AddCoupledCommand(const CoupledTruth& truth,
                       const Vehicle& vehicle,
                       const Experiment& experiment,
                       Log* log) {
  const CoupledCommand& command = truth.inputs.command;
  if (!experiment.thrusters.empty()) {
    log->thrusters = AtCommand(truth, experiment);
    for (std::size_t k = 0; k < command.thrusters.size(); ++k) {
      AddColumn(*log->thrusters, fmt::format("thruster_{}", k + 1), command.thrusters[k].thrust);
    }
    log->thruster_unit = "N";
    log->command = ForcesOfThrusts(*log->thrusters, vehicle);
  } else if (!experiment.drives.empty()) {
    log->command = AtCommand(truth, experiment);
    for (const Drive& drive : experiment.drives) {
      std::vector<double> values;
      for (const Vector6& force : command.force) values.push_back(force[Index(drive.dof)]);
      AddColumn(*log->command, std::string(ForceColumn(drive.dof)), std::move(values));
    }
  }
  if (!command.shafts.empty()) log->shafts = AtCommand(truth, experiment);
  for (const CommandedShaft& shaft : command.shafts) {
    AddColumn(*log->shafts, "shaft_" + shaft.shaft.name, shaft.turns);
  }
  if (command.fins.empty()) return;
  log->fins = AtCommand(truth, experiment);
  for (const CommandedFin& fin : command.fins) {
    AddColumn(*log->fins, "fin_" + fin.name, fin.angle);
  }
}

Stream CoupledVelocityStream(const CoupledTruth& truth,
                             const Experiment& experiment,
                             std::uint64_t seed,
                             Log& log) {
  const std::vector<Dof>& modelled = truth.model.dofs;
  const std::vector<Dof>& asked = experiment.velocity->dofs;
  for (const Dof dof : asked) {
    if (std::find(modelled.begin(), modelled.end(), dof) != modelled.end()) continue;
    throw InputError(
        fmt::format("experiment '{}': measures {}, which the coupled model of vehicle '{}' does "
                    "not move, expected one of its `dofs`.",
                    experiment.name,
                    Name(dof),
                    truth.vehicle));
  }
  const std::vector<Vector6> velocity = VelocitiesAt(truth, VelocityTimes(experiment, seed));
  const auto shown = [&](std::size_t k, double) {
    std::array<double, 6> nu{};
    std::copy(velocity[k].begin(), velocity[k].end(), nu.begin());
    return nu;
  };
  return NoisyVelocities(asked.empty() ? modelled : asked, shown, experiment, seed, log);
}

Stream CoupledPoseStream(const CoupledTruth& truth,
                         const Experiment& experiment,
                         std::uint64_t seed,
                         Log& log) {
  const std::vector<CoupledState> places = PlacesAt(truth, PoseTimes(experiment, seed));
  const auto shown = [&](std::size_t k, double) -> ShownPlace {
    return {places[k].position, places[k].attitude};
  };
  return NoisyPoses(shown, 0.0, experiment, seed, log);
}

}  // namespace fathom
