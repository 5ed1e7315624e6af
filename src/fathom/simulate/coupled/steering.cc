// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/steering.h"

#include "fathom/simulate/coupled/coupled_rate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/LU>

namespace fathom {
namespace {

constexpr double kSmall = 1e-5;  // of a central difference [m/s], [rad/s], [rad]

}  // namespace

std::optional<std::size_t> RudderOf(const std::vector<CommandedFin>& fins) {
  std::optional<std::size_t> rudder;
  for (std::size_t k = 0; k < fins.size(); ++k) {
    const double arm = std::abs(fins[k].arms.across[Index(Dof::kYaw)]);
    if (arm > 0.0 && (!rudder || arm > std::abs(fins[*rudder].arms.across[Index(Dof::kYaw)]))) {
      rudder = k;
    }
  }
  return rudder;
}

std::optional<SteeringEquations> SteeringOf(const CoupledModel& model,
                                            const std::vector<CommandedFin>& fins,
                                            double ahead,
                                            double thrust) {
  const auto moves = [&](Dof dof) {
    return std::ranges::find(model.dofs, dof) != model.dofs.end();
  };
  const auto rudder = RudderOf(fins);
  CoupledCommand command;  // `thrust` is that of shafts too
  command.fins = fins;
  const CoupledRate rate(model, {}, command);
  if (!rudder || !moves(Dof::kYaw) || !rate.IsUsable()) return std::nullopt;
  std::vector<Eigen::Index> rows;
  if (moves(Dof::kSway)) rows.push_back(Index(Dof::kSway));
  rows.push_back(Index(Dof::kYaw));
  const auto size = static_cast<Eigen::Index>(rows.size());

  CoupledFlow state = {Vector6::Zero(), Eigen::Vector4d::Unit(3), Eigen::Vector3d::Zero()};
  state.nu[0] = ahead;
  CoupledDrive drive;
  for (const CommandedFin& fin : fins) {
    const auto neutral = model.fin_neutral.find(fin.name);
    drive.angles.push_back(neutral == model.fin_neutral.end() ? 0.0 : neutral->second);
    drive.races.push_back(fin.behind.empty() ? 0.0 : thrust);
  }
  // M times the accelerations of the DOFs that the model moves is the force.
  const auto forces = [&] {
    const Vector6 force = model.inertia * rate.At(state, drive).nu;
    Eigen::VectorXd of_rows(size);
    for (Eigen::Index i = 0; i < size; ++i) of_rows[i] = force[rows[static_cast<std::size_t>(i)]];
    return of_rows;
  };
  const auto slope = [&](double* variable) -> Eigen::VectorXd {
    const double at = *variable;
    *variable = at + kSmall;
    const Eigen::VectorXd above = forces();
    *variable = at - kSmall;
    const Eigen::VectorXd below = forces();
    *variable = at;
    return (above - below) / (2.0 * kSmall);
  };
  SteeringEquations equations = {
      Eigen::MatrixXd(size, size), Eigen::MatrixXd(size, size), Eigen::VectorXd(size)};
  for (Eigen::Index j = 0; j < size; ++j) {
    const Eigen::Index row = rows[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < size; ++i) {
      equations.inertia(i, j) = model.inertia(rows[static_cast<std::size_t>(i)], row);
    }
    equations.force.col(j) = slope(&state.nu[row]);
  }
  const double to_starboard = fins[*rudder].arms.across[Index(Dof::kYaw)] > 0.0 ? 1.0 : -1.0;
  equations.rudder = to_starboard * slope(&drive.angles[*rudder]);
  return equations;
}

// With A = M^-1 F and b = M^-1 f: K = -(A^-1 b)_r, and the transfer function from angle to r is
// K (1 + T_3 s) / ((1 + T_1 s) (1 + T_2 s)).
Nomoto NomotoOf(const SteeringEquations& equations) {
  const Eigen::MatrixXd A = equations.inertia.inverse() * equations.force;
  const Eigen::VectorXd b = equations.inertia.inverse() * equations.rudder;
  Nomoto nomoto;
  if (!equations.HasSway()) {
    nomoto.growth_rate = A(0, 0);
    nomoto.K = -b[0] / A(0, 0);
    nomoto.T = -1.0 / A(0, 0);
    return nomoto;
  }
  const double determinant = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
  // The larger real part of the eigenvalues, half +- sqrt(half^2 - determinant).
  const double half = 0.5 * A.trace();
  nomoto.growth_rate = half + std::sqrt(std::max(half * half - determinant, 0.0));
  const double numerator = A(1, 0) * b[0] - A(0, 0) * b[1];
  nomoto.K = numerator / determinant;
  nomoto.T = -A.trace() / determinant - b[1] / numerator;
  return nomoto;
}

}  // namespace fathom
