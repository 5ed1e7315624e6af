// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/coupled_model.h"

#include <vector>

#include <Eigen/Geometry>

namespace fathom {

// A state at which exports are compared.
struct DrawnState {
  Vector6 nu = Vector6::Zero();
  Eigen::Quaterniond world_from_body = Eigen::Quaterniond::Identity();
  Vector6 tau = Vector6::Zero();
};

// With a fixed seed. DOFs that the model lacks move too, where `all_move`.
std::vector<DrawnState> DrawnStates(const CoupledModel& model, int num, bool all_move);

// dnu/dt written out from Fossen 2021, Eqs. 6.43 to 6.46, by blocks, entry by entry and with a
// rotation matrix: the truth of exports.
Vector6 WrittenOutRate(const CoupledModel& model, const DrawnState& state);

}  // namespace fathom
