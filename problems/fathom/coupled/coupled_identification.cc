// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_identification.h"

#include "fathom/base/input_error.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/vehicle/files/thruster_shares.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::optional<Vehicle> VehicleOfAll(const std::vector<Log>& logs) {
  for (const Log& log : logs) {
    if (auto vehicle = VehicleOf(log)) return vehicle;
  }
  return std::nullopt;
}

std::string NamesOfEntries(const std::vector<FreeEntry>& entries) {
  std::vector<std::string> names;
  for (const FreeEntry& entry : entries) names.push_back(NameOf(entry));
  return fmt::format("{}", fmt::join(names, ", "));
}

// As a fit takes them.
CoupledLogs CoupledLogsOf(std::vector<Log> logs,
                          const std::vector<Dof>& dofs,
                          const std::optional<Vehicle>& vehicle) {
  CoupledLogs out;
  for (const Log& log : logs) {
    const std::vector<Thruster> thrusters = vehicle ? vehicle->thrusters : std::vector<Thruster>();
    out.data.push_back(CoupledDataOf(log, dofs, thrusters));
    if (out.data.back().force_unit != out.data.front().force_unit) {
      throw InputError(fmt::format("{}: is commanded in {}, expected {} as in {}.",
                                   log.path.string(),
                                   out.data.back().force_unit,
                                   out.data.front().force_unit,
                                   logs.front().path.string()));
    }
  }
  out.logs = std::move(logs);
  return out;
}

}  // namespace

CoupledIdentification IdentifyCoupled(std::vector<Log> logs,
                                      const CoupledIdentificationOptions& options) {
  if (logs.empty()) throw InputError("An identification needs at least one log.");
  const std::optional<Vehicle> vehicle = VehicleOfAll(logs);
  CoupledIdentification identified;
  identified.fitted.log_fingerprints = FingerprintsOf(logs);
  CoupledLogs all = CoupledLogsOf(std::move(logs), options.dofs, vehicle);
  for (const CoupledData& data : all.data) {
    for (const std::string& remark : data.remarks) {
      identified.remarks.push_back(all.data.size() > 1 ? fmt::format("{}: {}", data.log, remark)
                                                       : remark);
    }
  }
  CoupledFitOptions fit = options.fit;
  if (vehicle) fit.body = vehicle->body;
  if (options.structure) {
    identified.fit = FitBlocks(all, StructureOf(*options.structure, options.dofs), fit);
    identified.fitted.structure = std::string(Name(*options.structure));
  } else {
    EntrySearchOptions search;
    search.fit = fit;
    const auto& thrusters = all.data.front().inputs.command.thrusters;
    for (const CommandedThruster& thruster : thrusters) search.thrusters.push_back(thruster.name);
    identified.ladder = ClimbLadder(all, options.dofs, search);
    identified.fit = identified.ladder->rungs[identified.ladder->accepted].fit;
    identified.fitted.structure = "auto";
  }
  const CoupledSummary& result = identified.fit;
  identified.message = result.message;
  identified.is_usable = result.IsUsable();
  if (!identified.is_usable) return identified;
  FittedCoupledModel& fitted = identified.fitted;
  fitted.model = result.model;
  fitted.model.dofs = options.dofs;
  fitted.entries = result.entries;
  fitted.covariance = result.covariance;
  fitted.force_unit = all.data.front().force_unit;
  fitted.horizon = fit.window;
  if (!result.on_bound.empty()) {
    fitted.caveats.push_back(
        fmt::format("Ended on what a body can be, no damping below 0 and no inertia below the "
                    "body's own: {}. These intervals are to be cut there.",
                    NamesOfEntries(result.on_bound)));
  }
  auto prediction = PredictCoupled(fitted.model, all.data, fit.window);
  if (!prediction) {
    identified.is_usable = false;
    identified.message = "free runs of the model diverge";
    return identified;
  }
  fitted.train = prediction->train;
  fitted.held_out = prediction->held_out;
  identified.prediction = std::move(*prediction);
  if (identified.ladder && identified.ladder->rungs.front().fit.converged) {
    CoupledModel diagonal = identified.ladder->rungs.front().fit.model;
    diagonal.dofs = options.dofs;
    identified.diagonal = PredictCoupled(diagonal, all.data, fit.window);
  }
  identified.data = std::move(all.data);
  return identified;
}

}  // namespace fathom
