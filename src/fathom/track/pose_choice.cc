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
  const double of_from = variance * from.noise_scale * from.noise_scale;
  const double of_to = variance * to.noise_scale * to.noise_scale;
  PoseCovariance covariance = of_from * from.unit_covariance + of_to * to.unit_covariance;
  const double translation = speeds.translation * dt;
  const double rotation = speeds.rotation * dt;
  constexpr double kFloor = 1e-12;  // [m^2], [rad^2]: what is exact is no reason to break
  covariance.diagonal().head<3>().array() += translation * translation + kFloor;
  covariance.diagonal().tail<3>().array() += rotation * rotation + kFloor;
  const double distance = step.dot(covariance.ldlt().solve(step));
  return std::min(0.5 * distance, options.most_step);
}

// What a pose costs of itself: its corners' misfit, and the detections that it leaves out.
double PoseCost(const FrameCandidates& frame,
                const ViewPose& pose,
                const PoseChoiceOptions& options) {
  const double sigma = options.corner_sigma * frame.poses.front().noise_scale;
  const int num_left_out = frame.num_detections - static_cast<int>(pose.used.size());
  return 0.5 * pose.squared_error / (sigma * sigma) + options.rejection * num_left_out;
}

// What it costs to leave a frame out.
double RejectionCost(const FrameCandidates& frame, const PoseChoiceOptions& options) {
  const ViewPose& best = frame.poses.front();  // no other one explains more
  if (best.used.size() < 2) return options.rejection;
  return 4.0 * options.rejection + PoseCost(frame, best, options);
}

// The frames with candidates, the only ones that can be left out, and what that costs.
struct SeenFrames {
  std::vector<int> index;  // among all

  // [i]: the cost of leaving out the first i of them.
  std::vector<double> left_out = {0.0};
};

SeenFrames SeenOf(std::span<const FrameCandidates> frames, const PoseChoiceOptions& options) {
  SeenFrames seen;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].poses.empty()) continue;
    seen.index.push_back(static_cast<int>(i));
    seen.left_out.push_back(seen.left_out.back() + RejectionCost(frames[i], options));
  }
  return seen;
}

// The cheapest track that ends at a pose.
struct Best {
  double cost = 0.0;
  int frame = -1;  // the chosen one before; -1: none
  int pose = -1;
};

// The cheapest track that ends at a pose of frame `i`, the pose's own cost apart: it begins here,
// all before left out, or goes on from one of the frames before, those between left out. `far`: as
// in BestTracks().
Best BestBefore(std::span<const FrameCandidates> frames,
                const SeenFrames& seen,
                const std::vector<std::vector<Best>>& best,
                const Best& far,
                std::size_t i,
                const ViewPose& pose,
                const Speeds& speeds,
                const PoseChoiceOptions& options) {
  const std::vector<double>& left_out = seen.left_out;
  Best own = {.cost = left_out[i], .frame = -1, .pose = -1};
  const double from_far = far.cost + left_out[i] + options.most_step;
  if (from_far < own.cost) own = {.cost = from_far, .frame = far.frame, .pose = far.pose};
  const double time = frames[seen.index[i]].time;
  const std::size_t first = i > kLongestSkip ? i - 1 - kLongestSkip : 0;
  for (std::size_t j = first; j < i; ++j) {
    const FrameCandidates& before = frames[seen.index[j]];
    for (std::size_t k = 0; k < before.poses.size(); ++k) {
      const double so_far = best[j][k].cost + left_out[i] - left_out[j + 1];
      if (so_far >= own.cost) continue;
      const double cost =
          so_far + StepCost(before.poses[k], pose, time - before.time, speeds, options);
      if (cost < own.cost) {
        own = {.cost = cost, .frame = static_cast<int>(j), .pose = static_cast<int>(k)};
      }
    }
  }
  return own;
}

// By dynamic programming, for each pose of each seen frame.
std::vector<std::vector<Best>> BestTracks(std::span<const FrameCandidates> frames,
                                          const SeenFrames& seen,
                                          const PoseChoiceOptions& options) {
  const Speeds speeds = SpeedsOf(frames);
  std::vector<std::vector<Best>> best(seen.index.size());
  // The cheapest end of a track too far back to be looked at pose by pose; its cost as if every
  // frame from the first on had been left out behind it.
  Best far = {.cost = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < seen.index.size(); ++i) {
    const FrameCandidates& frame = frames[seen.index[i]];
    if (i > kLongestSkip + 1) {
      const std::size_t j = i - kLongestSkip - 2;
      for (std::size_t k = 0; k < best[j].size(); ++k) {
        const double cost = best[j][k].cost - seen.left_out[j + 1];
        if (cost < far.cost) far = {cost, static_cast<int>(j), static_cast<int>(k)};
      }
    }
    for (const ViewPose& pose : frame.poses) {
      Best own = BestBefore(frames, seen, best, far, i, pose, speeds, options);
      own.cost += PoseCost(frame, pose, options);
      best[i].push_back(own);
    }
  }
  return best;
}

// The cheapest end, all behind it left out; no frame if it is cheapest to leave out all.
Best CheapestEnd(const SeenFrames& seen, const std::vector<std::vector<Best>>& best) {
  Best end = {.cost = seen.left_out.back()};
  for (std::size_t i = 0; i < best.size(); ++i) {
    const double behind = seen.left_out.back() - seen.left_out[i + 1];
    for (std::size_t k = 0; k < best[i].size(); ++k) {
      const double cost = best[i][k].cost + behind;
      if (cost < end.cost) end = {cost, static_cast<int>(i), static_cast<int>(k)};
    }
  }
  return end;
}

}  // namespace

std::vector<std::optional<int>> ChoosePoses(std::span<const FrameCandidates> frames,
                                            const PoseChoiceOptions& options) {
  const SeenFrames seen = SeenOf(frames, options);
  const std::vector<std::vector<Best>> best = BestTracks(frames, seen, options);
  std::vector<std::optional<int>> chosen(frames.size());
  for (Best at = CheapestEnd(seen, best); at.frame >= 0; at = best[at.frame][at.pose]) {
    chosen[seen.index[at.frame]] = at.pose;
  }
  return chosen;
}

}  // namespace fathom
