// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/camera_delay.h"

#include "fathom/findings/twin_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLongestCameraDelay = 10.0;     // [s]
constexpr double kMostOfOverlap = 0.2;           // a delay takes away so much of it
constexpr double kCameraDelayStep = 0.05;        // [s]
constexpr double kSurelyOneMotion = 0.8;         // correlation
constexpr double kLeastCameraEvidence = 10.0;    // natural logarithm of the ratio of likelihoods
constexpr double kPeriodicCameraEvidence = 3.0;  // closer than that, two delays are as good
constexpr double kLeastCameraDelay = 0.1;        // [s] told
constexpr double kTooLate = 1.0;                 // [s]

constexpr double kLeastRest = 0.02;  // of 1 - r^2, where delays are told apart

// The logarithm of the likelihood of a delay, and the largest correlation.
struct Match {
  double likelihood = 0.0;
  double surely = 0.0;  // the same, without what the grid of delays and the smoothing blur
  double correlation = 0.0;
};

Match MatchAt(double delay, double duration, const std::vector<TwinMotion>& motions) {
  Match match;
  for (const TwinMotion& motion : motions) {
    const double r = std::clamp(LikenessAt(delay, motion).correlation, 0.0, 1.0 - 1e-12);
    match.likelihood -= 0.5 * duration * std::log(1.0 - r * r);
    match.surely -= 0.5 * duration * std::log(std::max(1.0 - r * r, kLeastRest));
    match.correlation = std::max(match.correlation, r);
  }
  return match;
}

// What both streams cover, and how many steps of the delay are looked at either way.
struct Reach {
  double duration = 0.0;  // [s]
  int num_steps = 0;
};

Reach ReachOf(const TwinMotion& motion) {
  const auto& [pose, twist] = std::tie(motion.pose_time, motion.twist_time);
  Reach reach;
  reach.duration = std::min(pose.back(), twist.back()) - std::max(pose.front(), twist.front());
  reach.num_steps = static_cast<int>(
      std::min(kLongestCameraDelay, kMostOfOverlap * reach.duration) / kCameraDelayStep);
  return reach;
}

// Whether another delay is as good as the one at `best`, beyond the valley between them.
bool IsPeriodic(const std::vector<Match>& matches, std::size_t best) {
  const double top = matches[best].surely;
  const auto goes_on = [&](auto from, auto to) {
    double lowest = top;
    for (auto it = from; it != to; ++it) {
      lowest = std::min(lowest, it->surely);
      if (it->surely > lowest + kPeriodicCameraEvidence &&
          it->surely > top - kPeriodicCameraEvidence) {
        return true;
      }
    }
    return false;
  };
  const auto at = matches.begin() + static_cast<std::ptrdiff_t>(best);
  return goes_on(at, matches.end()) || goes_on(std::make_reverse_iterator(at), matches.rend());
}

}  // namespace

std::optional<CameraDelay> FindCameraDelay(const Log& log) {
  const std::vector<TwinMotion> motions = TwinMotionsOf(log);
  if (motions.empty()) return std::nullopt;
  const auto [duration, num_steps] = ReachOf(motions.front());
  if (num_steps < 1) return std::nullopt;
  std::vector<Match> matches;
  for (int k = -num_steps; k <= num_steps; ++k) {
    // The twist is as much earlier as the camera is later.
    matches.push_back(MatchAt(-k * kCameraDelayStep, duration, motions));
  }
  const auto at = std::ranges::max_element(matches, {}, &Match::likelihood) - matches.begin();
  const auto best = static_cast<std::size_t>(at);
  if (best == 0 || best + 1 == matches.size()) return std::nullopt;  // it may be longer still
  const Match& none = matches[static_cast<std::size_t>(num_steps)];
  const CameraDelay found = {(static_cast<int>(at) - num_steps) * kCameraDelayStep,
                             matches[best].surely - none.surely};
  if (matches[best].correlation < kSurelyOneMotion || found.evidence < kLeastCameraEvidence) {
    return std::nullopt;
  }
  if (IsPeriodic(matches, best)) return std::nullopt;
  return found;
}

std::vector<CameraDelayCurve> CameraDelayCurves(const Log& log) {
  std::vector<CameraDelayCurve> curves;
  for (const TwinMotion& motion : TwinMotionsOf(log)) {
    auto& [column, curve] = curves.emplace_back(CameraDelayCurve{motion.column, {}});
    const int num_steps = ReachOf(motion).num_steps;
    for (int k = -num_steps; k <= num_steps; ++k) {
      curve.delay.push_back(k * kCameraDelayStep);
      curve.correlation.push_back(LikenessAt(-k * kCameraDelayStep, motion).correlation);
    }
  }
  return curves;
}

std::optional<Finding> CheckCameraClock(const Log& log, const CameraDelay& found) {
  const std::vector<TwinMotion> motions = TwinMotionsOf(log);
  if (motions.empty()) return std::nullopt;
  const double size = std::abs(found.delay);
  if (size <= std::max(kLeastCameraDelay, motions.front().SlowestStep())) return std::nullopt;
  return Finding{size > kTooLate ? Severity::kWarning : Severity::kNote,
                 "camera_delay",
                 fmt::format("The motion that the camera sees comes {:.2f} s {} that of "
                             "velocity.csv: their clocks differ, or one is written down late.",
                             size,
                             found.delay > 0.0 ? "after" : "before")};
}

}  // namespace fathom
