// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/mount_check.h"

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kLeastArm = 0.1;  // [m] told
constexpr double kInDegrees = 180.0 / std::numbers::pi;
constexpr double kWrongAngle = 10.0;  // [deg]

Finding FindingOnAngle(const MountEstimate& angle, const FindingPlace& place) {
  const double size = std::abs(angle.value) * kInDegrees;
  const double half_width = angle.half_width * kInDegrees;
  return {size > kWrongAngle ? Severity::kWarning : Severity::kNote,
          "mounting_angle",
          fmt::format("velocity.csv: u and v are measured along axes that are turned by {:.1f}° "
                      "({:.1f}° to {:.1f}°) to {} of those of the vehicle in pose.csv.",
                      size,
                      size - half_width,
                      size + half_width,
                      angle.value > 0.0 ? "starboard" : "port"),
          place};
}

}  // namespace

std::vector<Finding> CheckSensorMount(const SensorMount& mount,
                                      const Log& log,
                                      const std::vector<LateColumn>& columns) {
  std::vector<std::string> names, arms;
  for (const LateColumn& column : columns) names.emplace_back(VelocityColumn(column.dof));
  const FindingPlace place = {
      "velocity.csv", names.front(), {log.velocity->time.front(), log.velocity->time.back()}};
  std::vector<Finding> findings;
  if (mount.needs_angle) findings.push_back(FindingOnAngle(mount.angle, place));
  for (int k = 0; k < 3; ++k) {
    const MountEstimate& arm = mount.arm[k];
    if (!arm.IsOver(kLeastArm)) continue;
    arms.push_back(fmt::format("{} = {:.2f} m ({:.2f} to {:.2f})",
                               "xyz"[k],
                               arm.value,
                               arm.value - arm.half_width,
                               arm.value + arm.half_width));
  }
  if (arms.empty() || !mount.needs_arm) return findings;
  findings.push_back({Severity::kNote,
                      "lever_arm",
                      fmt::format("velocity.csv: {} {} of a point that, in the vehicle's axes, "
                                  "lies at {} from the point that pose.csv is of.",
                                  fmt::join(names, ", "),
                                  names.size() == 1 ? "is" : "are",
                                  fmt::join(arms, ", ")),
                      place});
  return findings;
}

}  // namespace fathom
