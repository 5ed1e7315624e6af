// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/pose_flips.h"

#include "fathom/base/median.h"
#include "fathom/base/plural.h"
#include "fathom/signal/pose_velocity.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <numbers>
#include <system_error>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kLeastFlip = 30.0 * kDegree;
constexpr double kBack = 1.0 / 3.0;   // of the flip: what it may still be off when it is over
constexpr double kLongest = 0.5;      // [s]
constexpr double kUsualSteps = 10.0;  // times the median step of all rows
constexpr std::size_t kFewestRowsOfFlip = 10;

struct Flip {
  std::size_t first = 0, end = 0;  // rows
  double angle = 0.0;              // [rad]
};

std::vector<Flip> FlipsOf(const Poses& poses) {
  const auto turn = [&](std::size_t i, std::size_t j) {
    return poses.world_from_body[i].angularDistance(poses.world_from_body[j]);
  };
  std::vector<double> steps;
  for (std::size_t i = 1; i < poses.size(); ++i) steps.push_back(turn(i - 1, i));
  const double least = std::max(kLeastFlip, kUsualSteps * Median(steps));
  std::vector<Flip> flips;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double angle = steps[i - 1];
    if (angle < least) continue;
    std::size_t back = i + 1;
    const auto is_near = [&](std::size_t j) {
      return j < poses.size() && poses.time[j] - poses.time[i] <= kLongest;
    };
    while (is_near(back) && turn(i - 1, back) > kBack * angle) ++back;
    if (!is_near(back)) continue;
    flips.push_back({i, back, angle});
    i = back;
  }
  return flips;
}

bool HasMarkers(const Log& log) {
  std::error_code error;
  return log.detections || std::filesystem::exists(log.path / "tags.yaml", error);
}

}  // namespace

std::optional<Finding> CheckPoseFlips(const Log& log) {
  if (!log.pose || log.pose->time.size() < kFewestRowsOfFlip) return std::nullopt;
  const Poses poses = PosesOf(*log.pose);
  const std::vector<Flip> flips = FlipsOf(poses);
  if (flips.empty()) return std::nullopt;
  const Flip& first = flips.front();
  return Finding{
      Severity::kNote,
      "pose_flip",
      fmt::format(
          "pose.csv: the attitude turns away and back {}, first by {:.0f}° at t = {:.2f} s.{}",
          flips.size() == 1 ? "once" : Plural(flips.size(), "time"),
          first.angle / kDegree,
          poses.time[first.first],
          HasMarkers(log) ? " A single marker that is small in the image fits two attitudes: show "
                            "the camera several, or larger ones."
                          : ""),
      FindingPlace{"pose.csv", "yaw", {poses.time[first.first], poses.time[first.end - 1]}}};
}

}  // namespace fathom
