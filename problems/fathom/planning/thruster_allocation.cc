// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/thruster_allocation.h"

#include "fathom/base/input_error.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNoPivot = 1e-9;  // a row that the others give, of the greatest
constexpr double kNoForce = 1e-9;  // along a DOF, for a force of 1

// Those that thrusters hold best come first: a vehicle mostly rights itself in roll and pitch.
constexpr std::array<Dof, 6> kOrderOfHolding = {
    Dof::kSurge, Dof::kSway, Dof::kHeave, Dof::kYaw, Dof::kRoll, Dof::kPitch};

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
  for (const double of_thruster : share) thrusts.push_back(of_thruster * force);
  return thrusters.WithoutRounding(std::move(thrusts));
}

PlannedThrusts ThrustsOf(const HeldCommand& command, const ThrusterAllocation& allocation) {
  PlannedThrusts thrusts = {command.time, {}};
  for (const double force : command.value) thrusts.thrust.push_back(allocation.ThrustsOf(force));
  return thrusts;
}

ThrusterAllocation AllocateAlong(const AllocationTask& task,
                                 const Vehicle& vehicle,
                                 const std::string& name) {
  ThrusterAllocation allocation;
  allocation.thrusters = ThrustersOf(task.supply, vehicle, name);
  Eigen::Matrix<double, 6, Eigen::Dynamic> matrix = AllocationMatrix(vehicle.thrusters);
  for (std::size_t k = 0; k < vehicle.thrusters.size(); ++k) {
    const auto gain = task.gain.find(vehicle.thrusters[k].name);
    if (gain != task.gain.end()) matrix.col(static_cast<Eigen::Index>(k)) *= gain->second;
  }
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
  for (const double share : shares) {
    // What rounding leaves of a thruster that has no part in it.
    allocation.share.push_back(std::abs(share) <= kNoForce ? 0.0 : share);
  }
  allocation.reach = ReachOf(allocation.share, allocation.thrusters.range);
  if (task.dof != Dof::kRoll) allocation.roll = forces[Index(Dof::kRoll)];
  if (task.dof != Dof::kPitch) allocation.pitch = forces[Index(Dof::kPitch)];
  return allocation;
}

}  // namespace fathom
