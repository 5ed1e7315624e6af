// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/water_frame.h"

#include "fathom/vehicle/coupled/coriolis.h"

#include <cstddef>

#include <Eigen/Geometry>

namespace fathom {

WaterFrame::WaterFrame(const CoupledModel& model,
                       std::span<const FreeEntry> entries,
                       const CoupledInputs& inputs) {
  for (const Dof dof : model.dofs) is_modelled_[static_cast<std::size_t>(Index(dof))] = true;
  const auto current = model.current.find(inputs.log);
  if (current != model.current.end()) current_.head<2>() = current->second;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const FreeEntry& entry = entries[k];
    if (entry.kind != FreeEntry::Kind::kCurrent || entry.actuator != inputs.log) continue;
    columns_.emplace_back(static_cast<Eigen::Index>(k), Index(entry.row));
  }
  flows_ = !current_.isZero(0.0) || !columns_.empty();
}

void WaterFrame::ToGround(double since, CoupledFlow* state, CoupledTangent* tangent) const {
  Add(1.0, state, tangent);
  state->position += since * current_;
  if (!tangent) return;
  for (const auto& [column, axis] : columns_) (*tangent)(9 + axis, column) += since;
}

// Adds `sign` times the current to a velocity through the water.
void WaterFrame::Add(double sign, CoupledFlow* state, CoupledTangent* tangent) const {
  const Eigen::Matrix3d body_from_world =
      Eigen::Quaterniond(state->attitude).toRotationMatrix().transpose();
  const Eigen::Vector3d seen = body_from_world * current_;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (is_modelled_[static_cast<std::size_t>(i)]) state->nu[i] += sign * seen[i];
  }
  if (!tangent) return;
  const Eigen::Matrix3d by_turn = CrossMatrix(seen);
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (!is_modelled_[static_cast<std::size_t>(i)]) continue;
    tangent->row(i) += sign * by_turn.row(i) * tangent->middleRows<3>(6);
    for (const auto& [column, axis] : columns_) {
      (*tangent)(i, column) += sign * body_from_world(i, axis);
    }
  }
}

}  // namespace fathom
