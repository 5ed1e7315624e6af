// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "written_out_rate.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/LU>

namespace fathom {
namespace {

Eigen::Matrix3d SkewOf(const Eigen::Vector3d& x) {
  Eigen::Matrix3d s;
  s << 0, -x(2), x(1), x(2), 0, -x(0), -x(1), x(0), 0;
  return s;
}

}  // namespace

std::vector<DrawnState> DrawnStates(const CoupledModel& model, int num, bool all_move) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<DrawnState> states(static_cast<std::size_t>(num));
  for (DrawnState& state : states) {
    for (const Dof dof : kAllDofs) {
      const double speed = uniform(generator);
      const bool moves = all_move || std::count(model.dofs.begin(), model.dofs.end(), dof) > 0;
      if (moves) state.nu[Index(dof)] = speed;
      state.tau[Index(dof)] = 10.0 * uniform(generator);
    }
    const double w = uniform(generator), x = uniform(generator);
    const double y = uniform(generator), z = uniform(generator);
    state.world_from_body = Eigen::Quaterniond(w, x, y, z).normalized();
  }
  return states;
}

Vector6 WrittenOutRate(const CoupledModel& model, const DrawnState& state) {
  const Matrix6& m = model.inertia;
  const Eigen::Vector3d v1 = state.nu.head<3>(), v2 = state.nu.tail<3>();
  const Eigen::Vector3d a = m.block<3, 3>(0, 0) * v1 + m.block<3, 3>(0, 3) * v2;
  const Eigen::Vector3d b = m.block<3, 3>(3, 0) * v1 + m.block<3, 3>(3, 3) * v2;
  Vector6 force = state.tau - model.offset;
  if (model.coriolis) {
    force.head<3>() += SkewOf(a) * v2;
    force.tail<3>() += SkewOf(a) * v1 + SkewOf(b) * v2;
  }
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      force(i) -= model.linear_damping(i, j) * state.nu(j) +
                  model.quadratic_damping(i, j) * std::abs(state.nu(j)) * state.nu(j);
    }
  }
  const auto effect = [&](const char* name, int i) {
    const auto found = model.effects.find(name);
    return found == model.effects.end() ? 0.0 : found->second(i);
  };
  for (int i = 0; i < 6; ++i) {
    const double v = state.nu(i);
    force(i) -= effect("cubic_damping", i) * v * v * v +
                effect("coulomb_friction", i) * std::tanh(v / 0.005);
    if (v >= 0.0) continue;
    force(i) += effect("damping_asymmetry", i) * model.quadratic_damping(i, i) * v * v;
  }
  const Eigen::Matrix3d rotation = state.world_from_body.toRotationMatrix();
  const double sin_pitch = -rotation(2, 0);
  const double roll = std::atan2(rotation(2, 1), rotation(2, 2));
  const double cos_pitch = std::hypot(rotation(2, 1), rotation(2, 2));
  force.head<3>() += rotation.transpose() * Eigen::Vector3d(0.0, 0.0, -model.net_buoyancy);
  force(3) -= model.righting_roll * cos_pitch * std::sin(roll);
  force(4) -= model.righting_pitch * sin_pitch;
  // The others do not accelerate.
  Matrix6 modelled = Matrix6::Identity();
  Vector6 right = Vector6::Zero();
  for (const Dof row : model.dofs) {
    right(Index(row)) = force(Index(row));
    for (const Dof column : model.dofs) {
      modelled(Index(row), Index(column)) = m(Index(row), Index(column));
    }
  }
  return modelled.fullPivLu().solve(right);
}

}  // namespace fathom
