// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/yaml_pose.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace fathom {

Pose PoseAt(const YamlMap& map, std::string_view key) {
  constexpr double kTolerance = 1e-3;
  const YamlMap pose = map.Map(key);
  const std::vector<double> p = pose.Numbers("position", 3);
  const std::vector<double> q = pose.Numbers("quaternion", 4);
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!(std::abs(length - 1.0) <= kTolerance)) {
    pose.Fail("quaternion",
              fmt::format("has length {:.6g}, expected a unit quaternion x, y, z, w (within {}).",
                          length,
                          kTolerance));
  }
  return {Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized(), {p[0], p[1], p[2]}};
}

std::string FormatYamlPose(const Pose& pose) {
  const Eigen::Vector3d& p = pose.translation;
  const Eigen::Quaterniond& q = pose.rotation;
  return fmt::format("{{position: [{}, {}, {}], quaternion: [{}, {}, {}, {}]}}",
                     p.x(),
                     p.y(),
                     p.z(),
                     q.x(),
                     q.y(),
                     q.z(),
                     q.w());
}

}  // namespace fathom
