// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/thruster_shares.h"

#include "fathom/vehicle/thruster.h"

#include <cstddef>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

namespace fathom {
namespace {

// Adds the products of each thruster's part, and of the whole, with the whole.
void AddProducts(const Log& log,
                 const Vehicle& vehicle,
                 Dof dof,
                 std::map<std::string, double>* parts,
                 double* whole) {
  const auto allocation = AllocationMatrix(vehicle.thrusters);
  const std::vector<double>& time = log.thrusters->time;
  const std::vector<double>& force = *log.command->Find(ForceColumn(dof));
  for (std::size_t k = 0; k < vehicle.thrusters.size(); ++k) {
    const auto* thrust = log.thrusters->Find(fmt::format("thruster_{}", k + 1));
    double& part = (*parts)[vehicle.thrusters[k].name];
    for (std::size_t row = 0; row + 1 < time.size(); ++row) {
      part += allocation(Index(dof), static_cast<Eigen::Index>(k)) * (*thrust)[row] * force[row] *
              (time[row + 1] - time[row]);
    }
  }
  for (std::size_t row = 0; row + 1 < time.size(); ++row) {
    *whole += force[row] * force[row] * (time[row + 1] - time[row]);
  }
}

}  // namespace

std::optional<Vehicle> VehicleOf(const Log& log) {
  const std::filesystem::path file = log.path / log.vehicle;
  std::error_code error;
  if (!log.vehicle.ends_with(".yaml") || !std::filesystem::exists(file, error)) return std::nullopt;
  return ReadVehicleFile(file);
}

std::optional<Vehicle> FirstVehicleOf(std::span<const Log> logs) {
  for (const Log& log : logs) {
    if (auto vehicle = VehicleOf(log)) return vehicle;
  }
  return std::nullopt;
}

std::map<std::string, double> ThrusterSharesOf(std::span<const Log> logs, Dof dof) {
  std::map<std::string, double> shares;
  double whole = 0.0;
  for (const Log& log : logs) {
    const std::optional<Vehicle> vehicle = log.thrusters ? VehicleOf(log) : std::nullopt;
    if (!vehicle) return {};
    AddProducts(log, *vehicle, dof, &shares, &whole);
  }
  if (!(whole > 0.0)) return {};
  for (auto& [name, share] : shares) share /= whole;
  return shares;
}

}  // namespace fathom
