// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/track/pose_choice.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

// Steps over more left-out frames than this cost most_step, however short they are.
constexpr int kLongestSkip = 10;

// Typical speeds of the motion, as standard deviations of a step over a second.
struct Speeds {
  double translation = 0.0;  // [m/s]
  double rotation = 0.0;     // [rad/s]
};

// From the shortest steps between neighbouring frames. They hold the noise of the poses as well,
// which makes the speeds too large rather than too small.
Speeds SpeedsOf(std::span<const FrameCandidates> frames) {
  std::vector<double> translation, rotation;
  const FrameCandidates* last = nullptr;
  for (const FrameCandidates& frame : frames) {
    if (frame.poses.empty()) continue;
    if (last != nullptr) {
      const double dt = frame.time - last->time;
      double shortest = std::numeric_limits<double>::infinity();
      double turn = std::numeric_limits<double>::infinity();
      for (const ViewPose& from : last->poses) {
        for (const ViewPose& to : frame.poses) {
          const PoseIncrement step = StepBetween(from.world_from_camera, to.world_from_camera);
          shortest = std::min(shortest, step.head<3>().norm());
          turn = std::min(turn, step.tail<3>().norm());
        }
      }
      translation.push_back(shortest / dt);
      rotation.push_back(turn / dt);
    }
    last = &frame;
  }
  if (translation.empty()) return {};
  // The greatest speed of a sine is 1.4 times its median, that of other inputs more; 3 covers them.
  constexpr double kMargin = 3.0;
  return {kMargin * Median(translation), kMargin * Median(rotation)};
}

// d^2 / 2 of the step between two poses.
double StepCost(const ViewPose& from,
                const ViewPose& to,
                double dt,
                const Speeds& speeds,
                const PoseChoiceOptions& options) {
  const PoseIncrement step = StepBetween(from.world_from_camera, to.world_from_camera);
  const double variance = options.corner_sigma * options.corner_sigma;
  PoseCovariance covariance = variance * (from.unit_covariance + to.unit_covariance);
  const double translation = speeds.translation * dt;
  const double rotation = speeds.rotation * dt;
  constexpr double kFloor = 1e-12;  // [m^2], [rad^2]: what is exact is no reason to break
  covariance.diagonal().head<3>().array() += translation * translation + kFloor;
  covariance.diagonal().tail<3>().array() += rotation * rotation + kFloor;
  const double distance = step.dot(covariance.ldlt().solve(step));
  return std::min(0.5 * distance, options.most_step);
}

// What it costs to leave a frame out.
double RejectionCost(const FrameCandidates& frame, const PoseChoiceOptions& options) {
  const bool several_agree = std::any_of(frame.poses.begin(),
                                         frame.poses.end(),
                                         [](const ViewPose& pose) { return pose.used.size() > 1; });
  return several_agree ? 4.0 * options.rejection : options.rejection;
}

struct Best {
  double cost = 0.0;
  int frame = -1;  // the chosen one before; -1: none
  int pose = -1;
};

}  // namespace

std::vector<std::optional<int>> ChoosePoses(std::span<const FrameCandidates> frames,
                                            const PoseChoiceOptions& options) {
  const Speeds speeds = SpeedsOf(frames);
  const double variance = options.corner_sigma * options.corner_sigma;
  // The frames with candidates, the only ones that can be left out.
  std::vector<int> seen;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].poses.empty()) seen.push_back(static_cast<int>(i));
  }
  // left_out[i]: the cost of leaving out the first i of them.
  std::vector<double> left_out = {0.0};
  for (const int i : seen) left_out.push_back(left_out.back() + RejectionCost(frames[i], options));
  std::vector<std::vector<Best>> best(seen.size());
  // The cheapest end of a track too far back to be looked at pose by pose; its cost as if every
  // frame from the first on had been left out behind it.
  Best far = {.cost = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const FrameCandidates& frame = frames[seen[i]];
    if (i > kLongestSkip + 1) {
      const std::size_t j = i - kLongestSkip - 2;
      for (std::size_t k = 0; k < best[j].size(); ++k) {
        const double cost = best[j][k].cost - left_out[j + 1];
        if (cost < far.cost) far = {cost, static_cast<int>(j), static_cast<int>(k)};
      }
    }
    for (const ViewPose& pose : frame.poses) {
      // The track begins here, all before left out, ...
      Best own = {.cost = left_out[i], .frame = -1, .pose = -1};
      // ... or goes on from one of the frames before, those between left out.
      const double from_far = far.cost + left_out[i] + options.most_step;
      if (from_far < own.cost) own = {.cost = from_far, .frame = far.frame, .pose = far.pose};
      const std::size_t first = i > kLongestSkip ? i - 1 - kLongestSkip : 0;
      for (std::size_t j = first; j < i; ++j) {
        const FrameCandidates& before = frames[seen[j]];
        for (std::size_t k = 0; k < before.poses.size(); ++k) {
          const double so_far = best[j][k].cost + left_out[i] - left_out[j + 1];
          if (so_far >= own.cost) continue;
          const double cost =
              so_far + StepCost(before.poses[k], pose, frame.time - before.time, speeds, options);
          if (cost < own.cost) {
            own = {.cost = cost, .frame = static_cast<int>(j), .pose = static_cast<int>(k)};
          }
        }
      }
      own.cost += 0.5 * pose.squared_error / variance;
      const int num_left_out = frame.num_detections - static_cast<int>(pose.used.size());
      own.cost += options.rejection * num_left_out;
      best[i].push_back(own);
    }
  }

  // The cheapest end, all behind it left out; then back along the track.
  std::vector<std::optional<int>> chosen(frames.size());
  double least = left_out.back();
  int i = -1, k = -1;
  for (std::size_t end = 0; end < seen.size(); ++end) {
    const double behind = left_out.back() - left_out[end + 1];
    for (std::size_t pose = 0; pose < best[end].size(); ++pose) {
      if (best[end][pose].cost + behind < least) {
        least = best[end][pose].cost + behind;
        i = static_cast<int>(end);
        k = static_cast<int>(pose);
      }
    }
  }
  while (i >= 0) {
    chosen[seen[i]] = k;
    const Best& step = best[i][k];
    i = step.frame;
    k = step.pose;
  }
  return chosen;
}

}  // namespace fathom
