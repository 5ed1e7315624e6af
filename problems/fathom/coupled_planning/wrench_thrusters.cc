// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/wrench_thrusters.h"

#include "fathom/base/input_error.h"
#include "fathom/planning/thruster_reach.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// A thruster that a model has a gain of is one of its vehicle.
void RequireThrustersOfModel(const CoupledPlanRequest& request) {
  for (const auto& [name, gain] : request.model.model.thrust_gain) {
    const auto is_of_name = [&](const auto& part) { return part.name == name; };
    if (std::ranges::any_of(request.vehicle->thrusters, is_of_name)) continue;
    if (std::ranges::any_of(request.vehicle->shafts, is_of_name)) continue;
    throw InputError(
        fmt::format("{}: has no thruster '{}', expected the vehicle of {}, which holds its gain.",
                    request.vehicle_name,
                    name,
                    request.name));
  }
}

}  // namespace

std::optional<WrenchAllocation> WrenchThrusters(const CoupledPlanRequest& request,
                                                const std::vector<WrenchAxis>& axes) {
  if (request.vehicle == nullptr) return std::nullopt;
  RequireThrustersOfModel(request);
  std::vector<Dof> dofs;
  Vector6 holding = Vector6::Zero();
  for (const WrenchAxis& axis : axes) {
    dofs.push_back(axis.dof);
    holding[Index(axis.dof)] = axis.holding;
  }
  WrenchAllocation thrusters = AllocateWrench(dofs,
                                              {request.voltage, request.limits.thruster_force},
                                              request.model.model.thrust_gain,
                                              *request.vehicle,
                                              request.vehicle_name);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const Dof dof = axes[k].dof;
    RequireBothWays(dof, thrusters.along[k], request.vehicle_name);
    RequireWithinReach({request.limits_name, fmt::format("force.{}", Name(dof)), axes[k].force},
                       dof,
                       thrusters.along[k],
                       request.vehicle_name);
  }
  if (thrusters.Gives(holding)) return thrusters;
  throw InputError(fmt::format(
      "{}: its thrusters cannot give at once what holds the vehicle where it is, {:.4g} of surge, "
      "sway, heave [N], roll, pitch, yaw [N m], expected stronger ones or fewer DOFs, --dofs.",
      request.vehicle_name,
      fmt::join(holding, ", ")));
}

}  // namespace fathom
