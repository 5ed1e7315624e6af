// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/simulate/coupled/coupled_rate.h"
#include "fathom/simulate/coupled/tangent_step.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A frame that a steady current carries along, in which the water is still. DOFs that are not
// modelled stay as they are in both: what is measured of heave has no part of the current while the
// vehicle is level.
class WaterFrame {
 public:
  // In the water of `inputs.log`.
  WaterFrame(const CoupledModel& model,
             std::span<const FreeEntry> entries,
             const CoupledInputs& inputs);

  // Whether the water moves, or an entry may let it move; else both frames are one.
  bool Flows() const { return flows_; }

  // A state over ground as it is in this frame, where both stand at one place, with its
  // derivatives, unless null.
  void ToWater(CoupledFlow* state, CoupledTangent* tangent) const { Add(-1.0, state, tangent); }

  // The way back, `since` s after both stood there.
  void ToGround(double since, CoupledFlow* state, CoupledTangent* tangent) const;

 private:
  void Add(double sign, CoupledFlow* state, CoupledTangent* tangent) const;

  std::array<bool, 6> is_modelled_ = {};
  Eigen::Vector3d current_ = Eigen::Vector3d::Zero();           // world [m/s]
  std::vector<std::pair<Eigen::Index, Eigen::Index>> columns_;  // of it, and the axis of each
  bool flows_ = false;
};

}  // namespace fathom
