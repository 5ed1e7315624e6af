// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/pose_velocity.h"

#include "fathom/base/median.h"
#include "fathom/signal/filters/mean_attitude.h"
#include "fathom/signal/filters/unwrap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

namespace fathom {
namespace {

constexpr double kSmallestFlip = 5.0 * std::numbers::pi / 180.0;  // [rad]
constexpr double kFlipRatio = 6.0;
constexpr size_t kFlipNeighbours = 10;  // on either side

// Logarithm of a rotation: axis times angle, of length at most pi.
Eigen::Vector3d RotationVector(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const double sine = q.vec().norm();
  if (sine < 1e-9) return 2.0 * sign * q.vec();
  return 2.0 * std::atan2(sine, sign * q.w()) / sine * sign * q.vec();
}

Eigen::Quaterniond RotationOf(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  const double half_sinc = angle < 1e-6 ? 0.5 : std::sin(0.5 * angle) / angle;
  Eigen::Quaterniond q;
  q.w() = std::cos(0.5 * angle);
  q.vec() = half_sinc * phi;
  return q;
}

// J_r(phi) dphi/dt with J_r = I - (1 - cos a)/a^2 [phi] + (a - sin a)/a^3 [phi]^2, a = |phi|.
Eigen::Vector3d BodyRate(const Eigen::Vector3d& phi, const Eigen::Vector3d& phi_dot) {
  const double a = phi.norm();
  const double first = a < 1e-4 ? 0.5 : (1.0 - std::cos(a)) / (a * a);
  const double second = a < 1e-2 ? 1.0 / 6.0 - a * a / 120.0 : (a - std::sin(a)) / (a * a * a);
  const Eigen::Vector3d cross = phi.cross(phi_dot);
  return phi_dot - first * cross + second * phi.cross(cross);
}

double AngleOf(Dof dof, const Eigen::Quaterniond& q) {
  const Eigen::Matrix3d R = q.toRotationMatrix();
  switch (dof) {
    case Dof::kRoll:
      return std::atan2(R(2, 1), R(2, 2));
    case Dof::kPitch:
      return std::asin(std::clamp(-R(2, 0), -1.0, 1.0));
    default:
      return std::atan2(R(1, 0), R(0, 0));
  }
}

}  // namespace

Poses Poses::Between(size_t begin, size_t end) const {
  const auto cut = [&](const auto& all) {
    using Vector = std::decay_t<decltype(all)>;
    return Vector(all.begin() + static_cast<std::ptrdiff_t>(begin),
                  all.begin() + static_cast<std::ptrdiff_t>(end));
  };
  return {cut(time), cut(position), cut(world_from_body)};
}

bool TellsMotion(const Stream& pose, Dof dof) {
  if (IsAngular(dof)) return pose.Find("qw") != nullptr;
  return pose.Find(dof == Dof::kHeave ? "z" : "x") != nullptr;
}

Poses PosesOf(const Stream& pose) {
  Poses poses;
  poses.time = pose.time;
  poses.position.assign(pose.time.size(), Eigen::Vector3d::Zero());
  poses.world_from_body.assign(pose.time.size(), Eigen::Quaterniond::Identity());
  for (const int axis : {0, 1, 2}) {
    const auto* values = pose.Find(std::string_view("xyz").substr(axis, 1));
    if (values == nullptr) continue;
    for (size_t i = 0; i < values->size(); ++i) poses.position[i][axis] = (*values)[i];
  }
  const auto *qx = pose.Find("qx"), *qy = pose.Find("qy"), *qz = pose.Find("qz"),
             *qw = pose.Find("qw");
  if (qw == nullptr) return poses;
  for (size_t i = 0; i < pose.time.size(); ++i) {
    Eigen::Quaterniond q = Eigen::Quaterniond((*qw)[i], (*qx)[i], (*qy)[i], (*qz)[i]).normalized();
    if (i > 0 && q.dot(poses.world_from_body[i - 1]) < 0.0) q.coeffs() *= -1.0;
    poses.world_from_body[i] = q;
  }
  return poses;
}

BodyVelocity VelocityOf(const Poses& poses, const SavitzkyGolayOptions& options) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BodyVelocity result;
  result.velocity.assign(poses.size(), Eigen::Vector<double, 6>::Constant(nan));
  result.is_centred.assign(poses.size(), false);
  LocalPolynomial fit(poses.time, options);
  std::vector<Eigen::Vector3d> phi;
  for (size_t i = 0; i < poses.size(); ++i) {
    if (!fit.MoveTo(i)) continue;
    const Eigen::Quaterniond& R_i = poses.world_from_body[i];
    phi.clear();
    const size_t first = fit.window().first();
    for (size_t j = first; j < fit.window().past_last(); ++j) {
      phi.push_back(RotationVector(R_i.conjugate() * poses.world_from_body[j]));
    }
    Eigen::Vector3d phi_smooth = Eigen::Vector3d::Zero();
    const auto value_weights = fit.Weights(0);
    for (size_t j = 0; j < phi.size(); ++j) phi_smooth += value_weights[j] * phi[j];
    Eigen::Vector3d phi_dot = Eigen::Vector3d::Zero(), p_dot = Eigen::Vector3d::Zero();
    const auto slope_weights = fit.Weights(1);
    for (size_t j = 0; j < phi.size(); ++j) {
      phi_dot += slope_weights[j] * phi[j];
      // From the stamp's own position: small numbers, and the weights sum to 0.
      p_dot += slope_weights[j] * (poses.position[first + j] - poses.position[i]);
    }
    const Eigen::Quaterniond R = R_i * RotationOf(phi_smooth);
    result.velocity[i].head<3>() = R.conjugate() * p_dot;          // (5)
    result.velocity[i].tail<3>() = BodyRate(phi_smooth, phi_dot);  // (6), (7)
    result.is_centred[i] = fit.window().is_centred();
  }
  return result;
}

std::vector<double> DisplacementAlong(Dof dof, const Poses& poses) {
  const auto& attitudes = poses.world_from_body;
  std::vector<double> displacement;
  if (!IsAngular(dof)) {
    const Eigen::Vector3d axis = MeanAttitude(dof, attitudes) * Eigen::Vector3d::Unit(Index(dof));
    for (const auto& p : poses.position) displacement.push_back(axis.dot(p));
    return displacement;
  }
  for (const auto& q : attitudes) displacement.push_back(AngleOf(dof, q));
  if (dof != Dof::kYaw || AxisTurn(dof, attitudes) > kLargestAxisTurn) return Unwrap(displacement);

  // About the body's own axis, counted from where the first heading is.
  const Eigen::Quaterniond mean = MeanAttitude(dof, attitudes);
  const double offset = displacement.front() - AngleOf(dof, mean.conjugate() * attitudes.front());
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    displacement[i] = offset + AngleOf(dof, mean.conjugate() * attitudes[i]);
  }
  return Unwrap(displacement);
}

int CountRotationFlips(const Poses& poses) {
  std::vector<double> steps;
  for (size_t i = 1; i < poses.size(); ++i) {
    steps.push_back(poses.world_from_body[i - 1].angularDistance(poses.world_from_body[i]));
  }
  int count = 0;
  for (size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] <= kSmallestFlip) continue;
    const size_t begin = i > kFlipNeighbours ? i - kFlipNeighbours : 0;
    const size_t end = std::min(i + kFlipNeighbours + 1, steps.size());
    const double usual = Median({steps.begin() + static_cast<std::ptrdiff_t>(begin),
                                 steps.begin() + static_cast<std::ptrdiff_t>(end)});
    if (steps[i] > kFlipRatio * usual) ++count;
  }
  return count;
}

}  // namespace fathom
