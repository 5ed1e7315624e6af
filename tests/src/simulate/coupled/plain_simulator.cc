// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "plain_simulator.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace fathom {
namespace {

Eigen::Matrix3d S(const Eigen::Vector3d& x) {
  Eigen::Matrix3d s;
  s << 0, -x(2), x(1), x(2), 0, -x(0), -x(1), x(0), 0;
  return s;
}

Eigen::Matrix3d Turn(const Eigen::Vector3d& by) {
  const double angle = by.norm();
  if (angle < 1e-12) return Eigen::Matrix3d::Identity() + S(by);
  return Eigen::AngleAxisd(angle, by / angle).toRotationMatrix();
}

}  // namespace

void PlainSimulator::Advance(const Vector6& commanded, double duration, double step) {
  const Vector6 tau = LeftOf(commanded);
  const int steps = static_cast<int>(std::lround(duration / step));
  for (int k = 0; k < steps; ++k) {
    Vector6 half_push = tau, begin_push = tau;
    if (model_.thruster_lag > 0.0) {
      begin_push = push_;
      half_push = push_ + 0.5 * step / model_.thruster_lag * (tau - push_);
      push_ += step / model_.thruster_lag * (tau - half_push);
    }
    const Vector6 half = nu + 0.5 * step * Rate(nu, world_from_body, begin_push);
    const Eigen::Matrix3d turned = world_from_body * Turn(0.5 * step * nu.tail<3>());
    position += step * (turned * half.head<3>());
    nu += step * Rate(half, turned, half_push);
    world_from_body *= Turn(step * half.tail<3>());
  }
}

double PlainSimulator::EffectOn(int i, const char* name) const {
  const auto found = model_.effects.find(name);
  return found == model_.effects.end() ? 0.0 : found->second(i);
}

Vector6 PlainSimulator::LeftOf(Vector6 tau) const {
  for (int i = 0; i < 6; ++i) {
    const double width = EffectOn(i, "thrust_dead_zone");
    const double beyond = std::max(std::abs(tau(i)) - width, 0.0);
    const double share = tau(i) < 0.0 ? 1.0 - EffectOn(i, "thrust_asymmetry") : 1.0;
    tau(i) = share * std::copysign(beyond, tau(i));
  }
  return tau;
}

Vector6 PlainSimulator::Rate(const Vector6& v,
                             const Eigen::Matrix3d& rotation,
                             const Vector6& tau) const {
  const Eigen::Vector3d water = rotation.transpose() * current;
  Vector6 through = v;
  through.head<3>() -= water;
  Vector6 rate = RateInWater(through, rotation, tau);
  rate.head<3>() += water.cross(v.tail<3>());
  return rate;
}

Vector6 PlainSimulator::RateInWater(const Vector6& v,
                                    const Eigen::Matrix3d& rotation,
                                    const Vector6& tau) const {
  const Matrix6& m = model_.inertia;
  const Eigen::Vector3d v1 = v.head<3>(), v2 = v.tail<3>();
  const Eigen::Vector3d a = m.block<3, 3>(0, 0) * v1 + m.block<3, 3>(0, 3) * v2;
  const Eigen::Vector3d b = m.block<3, 3>(3, 0) * v1 + m.block<3, 3>(3, 3) * v2;
  Vector6 force = tau;
  const double c = std::cos(model_.thrust_angle), s = std::sin(model_.thrust_angle);
  for (const int i : {0, 3}) {
    force[i] = c * tau[i] - s * tau[i + 1];
    force[i + 1] = s * tau[i] + c * tau[i + 1];
  }
  force -= model_.offset;
  if (more) force += more(v);
  if (model_.coriolis) {
    force.head<3>() -= -S(a) * v2;
    force.tail<3>() -= -S(a) * v1 - S(b) * v2;
  }
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      force(i) -= model_.linear_damping(i, j) * v(j) +
                  model_.quadratic_damping(i, j) * std::abs(v(j)) * v(j);
    }
  }
  for (int i = 0; i < 6; ++i) {
    force(i) -= EffectOn(i, "cubic_damping") * v(i) * v(i) * v(i) +
                EffectOn(i, "coulomb_friction") * std::tanh(v(i) / 0.005);
    if (v(i) >= 0.0) continue;
    force(i) += EffectOn(i, "damping_asymmetry") * model_.quadratic_damping(i, i) * v(i) * v(i);
  }
  const double pitch = std::asin(-rotation(2, 0));
  const double roll = std::atan2(rotation(2, 1), rotation(2, 2));
  const Eigen::Vector3d up_force(0.0, 0.0, -model_.net_buoyancy);
  force.head<3>() += rotation.transpose() * up_force;
  force(3) -= model_.righting_roll * std::cos(pitch) * std::sin(roll);
  force(4) -= model_.righting_pitch * std::sin(pitch);
  return m.fullPivLu().solve(force);
}

}  // namespace fathom
