// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/coupled_model.h"

#include <functional>
#include <utility>

#include <Eigen/Core>

namespace fathom {

// A second simulator of all six DOFs, written from Fossen 2021, Eqs. 6.43 to 6.46, by blocks and
// with a rotation matrix, and integrated by its own small steps: the truth of the first.
class PlainSimulator {
 public:
  Vector6 nu = Vector6::Zero();
  Eigen::Matrix3d world_from_body = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d current = Eigen::Vector3d::Zero();  // of the water over ground, world [m/s]
  std::function<Vector6(const Vector6&)> more;        // a further force by nu; may be empty

  explicit PlainSimulator(CoupledModel model) : model_(std::move(model)) {}

  // Over a constant force, by the midpoint rule.
  void Advance(const Vector6& commanded, double duration, double step);

 private:
  double EffectOn(int i, const char* name) const;

  // What dead zones and weak reverse thrust leave of a command.
  Vector6 LeftOf(Vector6 tau) const;

  // Of the velocity over ground: that of the water changes in the body's frame as the body turns.
  Vector6 Rate(const Vector6& v, const Eigen::Matrix3d& rotation, const Vector6& tau) const;

  Vector6 RateInWater(const Vector6& v, const Eigen::Matrix3d& rotation, const Vector6& tau) const;

  CoupledModel model_;
  Vector6 push_ = Vector6::Zero();  // of a thrust that lags
};

}  // namespace fathom
