// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/pose_coordinate.h"

#include "fathom/signal/filters/mean_attitude.h"
#include "fathom/signal/pose_velocity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr size_t kFewestPoses = 20;
constexpr double kSteadyAxis = 0.02;  // RMS [rad] below which it is taken to keep still
constexpr double kLargestLeak = 1.0;  // of the positions' noise: what the turning adds to it

// Poses averaged over about a second, so that their noise does not add up along the way.
Poses SlowPoses(const Poses& poses) {
  Poses slow;
  for (size_t begin = 0; begin < poses.size();) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector4d rotation = Eigen::Vector4d::Zero();
    size_t end = begin;
    for (; end < poses.size() && poses.time[end] - poses.time[begin] < 1.0; ++end) {
      position += poses.position[end];
      const Eigen::Vector4d q = poses.world_from_body[end].coeffs();
      rotation += q.dot(poses.world_from_body[begin].coeffs()) < 0.0 ? Eigen::Vector4d(-q) : q;
    }
    slow.time.push_back(poses.time[begin]);
    slow.position.push_back(position / static_cast<double>(end - begin));
    slow.world_from_body.push_back(Eigen::Quaterniond(rotation).normalized());
    begin = end;
  }
  return slow;
}

// Noise of a coordinate, from its second differences.
double NoiseOf(const std::vector<double>& coordinate) {
  double sum = 0.0;
  for (size_t i = 2; i < coordinate.size(); ++i) {
    const double bend = coordinate[i] - 2.0 * coordinate[i - 1] + coordinate[i - 2];
    sum += bend * bend / 6.0;
  }
  return std::sqrt(sum / static_cast<double>(std::max<size_t>(coordinate.size(), 3) - 2));
}

// By how much the displacement along the mean axis differs from the way along the turning axis
// [RMS]: motion along the other axes leaks into it when the vehicle turns.
double LeakOf(Dof dof, const Poses& poses) {
  if (IsAngular(dof)) return 0.0;
  const Poses slow = SlowPoses(poses);
  // Below, attitude noise alone would add up.
  if (AxisTurn(dof, slow.world_from_body) < kSteadyAxis) return 0.0;
  const std::vector<double> coordinate = DisplacementAlong(dof, slow);
  std::vector<double> difference = {0.0};
  double way = 0.0;
  for (size_t i = 1; i < slow.size(); ++i) {
    const Eigen::Quaterniond middle =
        slow.world_from_body[i - 1].slerp(0.5, slow.world_from_body[i]);
    way += (middle.conjugate() * (slow.position[i] - slow.position[i - 1]))[Index(dof)];
    difference.push_back(coordinate[i] - coordinate[0] - way);
  }
  const Eigen::Map<const Eigen::ArrayXd> d(difference.data(), std::ssize(difference));
  return std::sqrt((d - d.mean()).square().mean());
}

}  // namespace

std::optional<SampledSignal> PoseCoordinate(const Log& log,
                                            const std::string& name,
                                            Dof dof,
                                            std::vector<std::string>* remarks) {
  if (!log.pose || !TellsMotion(*log.pose, dof)) return std::nullopt;
  if (log.pose->time.size() < kFewestPoses) {
    remarks->push_back(fmt::format("{}: holds {} poses, expected at least {} to use them.",
                                   name,
                                   log.pose->time.size(),
                                   kFewestPoses));
    return std::nullopt;
  }
  const Poses poses = PosesOf(*log.pose);
  const std::vector<double> displacement = DisplacementAlong(dof, poses);
  const double turn = IsAngular(dof) ? 0.0 : AxisTurn(dof, poses.world_from_body);
  if (turn > kLargestAxisTurn && log.velocity) {
    remarks->push_back(
        fmt::format("{}: the poses are not used: the {} axis turns by {:.2f} rad RMS, so the "
                    "displacement has no fixed direction.",
                    name,
                    Name(dof),
                    turn));
    return std::nullopt;
  }
  const double leak = LeakOf(dof, poses) / std::max(NoiseOf(displacement), 1e-12);
  if (leak > kLargestLeak && log.velocity) {
    remarks->push_back(
        fmt::format("{}: the poses are not used: the vehicle turns, and its other motion adds to "
                    "the {} coordinate {:.1f} times the coordinate's noise.",
                    name,
                    Name(dof),
                    leak));
    return std::nullopt;
  }
  return SampledSignal{poses.time, displacement};
}

}  // namespace fathom
