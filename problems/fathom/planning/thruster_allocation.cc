// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/thruster_allocation.h"

#include "fathom/base/input_error.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kNoPivot = 1e-9;    // a row that the others give, of the greatest
constexpr double kNoForce = 1e-9;    // along a DOF, for a force of 1
constexpr double kRounding = 1e-12;  // of a thrust, beyond its range

// Those that thrusters hold best come first: a vehicle mostly rights itself in roll and pitch.
constexpr std::array<Dof, 6> kOrderOfHolding = {
    Dof::kSurge, Dof::kSway, Dof::kHeave, Dof::kYaw, Dof::kRoll, Dof::kPitch};

// That all tables hold.
double VoltageOf(double given, const Vehicle& vehicle, const std::string& name) {
  for (const Thruster& thruster : vehicle.thrusters) {
    const ThrustTable* table = TableOf(thruster, vehicle);
    if (table == nullptr) continue;
    const std::vector<double>& voltages = table->voltages;
    if (std::isnan(given) && voltages.size() == 1) given = voltages.front();
    if (std::isnan(given)) {
      throw InputError(fmt::format(
          "--voltage: is missing, expected the volts of the supply, since table '{}' of "
          "{} holds {:g} V.",
          table->name,
          name,
          fmt::join(voltages, ", ")));
    }
    if (given >= voltages.front() && given <= voltages.back()) continue;
    throw InputError(
        fmt::format("--voltage: is {:g} V, expected {:g} to {:g} V as in table '{}' of {}.",
                    given,
                    voltages.front(),
                    voltages.back(),
                    table->name,
                    name));
  }
  return given;
}

ValueRange RangeOfThruster(const Thruster& thruster,
                           const ThrustTable* table,
                           const AllocationTask& task,
                           double voltage) {
  ValueRange range = {-task.thruster_force, task.thruster_force};
  const auto narrow = [&](double low, double high) {
    range = {std::max(range.low, low), std::min(range.high, high)};
  };
  if (table != nullptr) {
    std::vector<double> thrusts;
    for (const double command : table->commands) thrusts.push_back(table->Thrust(command, voltage));
    const auto [low, high] = std::minmax_element(thrusts.begin(), thrusts.end());
    narrow(std::min(0.0, *low), std::max(0.0, *high));
  } else if (thruster.forward_coefficient > 0.0 && thruster.reverse_coefficient == 0.0) {
    narrow(0.0, PlanLimits::kNoLimit);
  }
  return range;
}

// The thrusts for a force of 1 along the DOF: T = A^+ e with the rows A of the allocation that are
// independent, the DOF's first.
Eigen::VectorXd SharesOf(Dof dof, const Eigen::MatrixXd& allocation) {
  std::vector<Dof> order(kOrderOfHolding.begin(), kOrderOfHolding.end());
  std::stable_partition(order.begin(), order.end(), [&](Dof other) { return other == dof; });
  Eigen::MatrixXd rows(0, allocation.cols());
  for (const Dof other : order) {
    Eigen::MatrixXd more(rows.rows() + 1, rows.cols());
    more << rows, allocation.row(Index(other));
    if (RankOf(more, kNoPivot) == more.rows()) rows = more;
    if (rows.rows() == 0) return {};
  }
  return PseudoInverse(rows).col(0);
}

ValueRange ReachOf(const std::vector<double>& shares, const std::vector<ValueRange>& ranges) {
  ValueRange reach = {-PlanLimits::kNoLimit, PlanLimits::kNoLimit};
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (std::abs(shares[k]) <= kNoForce) continue;
    double low = ranges[k].low / shares[k], high = ranges[k].high / shares[k];
    if (low > high) std::swap(low, high);
    reach = {std::max(reach.low, low), std::min(reach.high, high)};
  }
  return reach;
}

}  // namespace

double ThrusterAllocation::ReachEachWay() const { return std::min(-reach.low, reach.high); }

std::vector<double> ThrusterAllocation::ThrustsOf(double force) const {
  std::vector<double> thrusts;
  for (std::size_t k = 0; k < share.size(); ++k) {
    const double thrust = share[k] * force;
    const double slack = kRounding * std::abs(thrust);
    const bool is_at_end = thrust >= range[k].low - slack && thrust <= range[k].high + slack;
    // -0 would be printed as such.
    thrusts.push_back(0.0 + (is_at_end ? std::clamp(thrust, range[k].low, range[k].high) : thrust));
  }
  return thrusts;
}

bool ThrusterAllocation::HasPulses() const {
  return !table.empty() && std::all_of(table.begin(), table.end(), [](const ThrustTable* one) {
    return one != nullptr && one->command_unit == "us";
  });
}

std::vector<int> ThrusterAllocation::PulsesOf(double force) const {
  std::vector<int> pulses;
  if (!HasPulses()) return pulses;
  const std::vector<double> thrusts = ThrustsOf(force);
  for (std::size_t k = 0; k < thrusts.size(); ++k) {
    pulses.push_back(static_cast<int>(std::lround(*table[k]->CommandFor(thrusts[k], voltage))));
  }
  return pulses;
}

ThrusterAllocation AllocateAlong(const AllocationTask& task,
                                 const Vehicle& vehicle,
                                 const std::string& name) {
  if (vehicle.thrusters.empty()) {
    throw InputError(fmt::format("{}: has no thrusters, expected some to be commanded.", name));
  }
  const Eigen::Matrix<double, 6, Eigen::Dynamic> matrix = AllocationMatrix(vehicle.thrusters);
  const Eigen::VectorXd shares = SharesOf(task.dof, matrix);
  if (shares.size() == 0) {
    throw InputError(fmt::format(
        "{}: its thrusters give {} a force of 0 {}, expected the thrusters of this DOF's vehicle.",
        name,
        Name(task.dof),
        ForceUnit(task.dof)));
  }
  const Eigen::Matrix<double, 6, 1> forces = GeneralisedForces(matrix, shares);
  for (const Dof other : {Dof::kSurge, Dof::kSway, Dof::kHeave, Dof::kYaw}) {
    const double along = forces[Index(other)];
    if (other == task.dof || std::abs(along) <= kNoForce) continue;
    throw InputError(fmt::format(
        "{}: its thrusters give {} a force of 0 {} without {}: {:.3g} {} act along it for "
        "each {}. Plan a DOF that they drive alone.",
        name,
        Name(task.dof),
        ForceUnit(task.dof),
        Name(other),
        along,
        ForceUnit(other),
        ForceUnit(task.dof)));
  }
  ThrusterAllocation allocation;
  allocation.voltage = VoltageOf(task.voltage, vehicle, name);
  for (std::size_t k = 0; k < vehicle.thrusters.size(); ++k) {
    const Thruster& thruster = vehicle.thrusters[k];
    const ThrustTable* table = TableOf(thruster, vehicle);
    allocation.names.push_back(thruster.name);
    // What rounding leaves of a thruster that has no part in it.
    const double share = shares[static_cast<Eigen::Index>(k)];
    allocation.share.push_back(std::abs(share) <= kNoForce ? 0.0 : share);
    allocation.table.push_back(table);
    allocation.range.push_back(RangeOfThruster(thruster, table, task, allocation.voltage));
    if (table == nullptr || table->CommandFor(0.0, allocation.voltage)) continue;
    throw InputError(fmt::format(
        "{}: table '{}' gives no command for a thrust of 0 N at {:g} V, expected thrust "
        "that passes 0 and rises from command to command, or falls.",
        name,
        table->name,
        allocation.voltage));
  }
  allocation.reach = ReachOf(allocation.share, allocation.range);
  if (task.dof != Dof::kRoll) allocation.roll = forces[Index(Dof::kRoll)];
  if (task.dof != Dof::kPitch) allocation.pitch = forces[Index(Dof::kPitch)];
  return allocation;
}

}  // namespace fathom
