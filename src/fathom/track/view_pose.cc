// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/track/view_pose.h"

#include "fathom/base/median.h"
#include "fathom/track/pose_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include <Eigen/Cholesky>
#include <opencv2/calib3d.hpp>

namespace fathom {
namespace {

// Both poses of a square seen along these rays, by infinitesimal plane-based pose estimation
// (Collins and Bartoli 2014). OpenCV's corners are ours, in the same order.
std::vector<Pose> SolveByIppe(double size, const std::array<Eigen::Vector2d, 4>& slopes) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pixels;
  for (const Eigen::Vector3d& corner : CornersInTag(size)) {
    points.emplace_back(corner.x(), corner.y(), corner.z());
  }
  for (const Eigen::Vector2d& slope : slopes) pixels.emplace_back(slope.x(), slope.y());
  std::vector<cv::Vec3d> rotations, translations;
  try {
    cv::solvePnPGeneric(points,
                        pixels,
                        cv::Matx33d::eye(),
                        cv::noArray(),
                        rotations,
                        translations,
                        false,
                        cv::SOLVEPNP_IPPE_SQUARE);
  } catch (const cv::Exception&) {
    return {};
  }
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const Eigen::Vector3d phi(rotations[i][0], rotations[i][1], rotations[i][2]);
    const Eigen::Vector3d t(translations[i][0], translations[i][1], translations[i][2]);
    if (!phi.allFinite() || !t.allFinite() || !(t.z() > 0.0)) continue;
    PoseIncrement step;
    step << t, phi;
    poses.push_back(Moved(Pose(), step));
  }
  return poses;
}

// Two refined poses are the same minimum if they draw the corners in the same place.
bool IsSameMinimum(const Pose& a, const Pose& b, const PoseCovariance& unit_covariance) {
  constexpr double kSame = 1e-3;  // [px]
  const PoseIncrement step = StepBetween(a, b);
  return step.dot(unit_covariance.ldlt().solve(step)) < kSame * kSame;
}

// About the quantile of a chi-square that a standard normal has at `z` (Wilson and Hilferty 1931).
double ChiSquareAt(double z, double dof) {
  const double part = 2.0 / (9.0 * dof);
  return dof * std::pow(1.0 - part + z * std::sqrt(part), 3);
}

double NoiseScaleOf(const ViewPose& view, double corner_sigma) {
  constexpr double kOneInAThousand = 3.09;
  if (view.used.size() < 2 || !(corner_sigma > 0.0)) return 1.0;
  const double dof = view.degrees_of_freedom;
  const double square = view.squared_error / (corner_sigma * corner_sigma);
  return square > ChiSquareAt(kOneInAThousand, dof) ? std::sqrt(square / dof) : 1.0;
}

// A pose that one square of the frame proposes.
struct Candidate {
  Pose world_from_camera;
  int proposer = 0;  // index of the square's detection
};

// A pose and the detections that it explains, as indices into the frame, rising.
struct Explanation {
  RefinedPose pose;
  std::vector<int> used;
};

// The corners of one frame, and what it takes to explain them.
class Frame {
 public:
  Frame(const CameraModel& camera,
        const MarkerMap& map,
        std::span<const Detection> frame,
        const ViewPoseOptions& options)
      : camera_(camera), options_(options), gate_square_(4.0 * options.gate * options.gate) {
    for (const Detection& detection : frame) {
      seen_.push_back(SeenCornersOf(*map.Find(detection.tag_id), detection));
    }
    // One square alone, its tilt known to some degrees, puts those a metre away far off: before all
    // are fitted together nothing within this is an outlier.
    constexpr double kWideGate = 100.0;  // rms [px]
    wide_square_ =
        frame.size() > 1 ? std::max(gate_square_, 4.0 * kWideGate * kWideGate) : gate_square_;
  }

  // Keeps the candidates that fit all detections best, each counting no more than an outlier; first
  // those that explain their own square, of whose two poses the other is the flipped one.
  void KeepTheBest(std::vector<Candidate>* candidates) const {
    constexpr std::size_t kMost = 4;
    if (candidates->size() <= kMost) return;
    std::vector<std::tuple<bool, double, std::size_t>> scores;
    for (std::size_t k = 0; k < candidates->size(); ++k) {
      const auto& [pose, proposer] = (*candidates)[k];
      double score = 0.0;
      for (std::size_t i = 0; i < seen_.size(); ++i) {
        score += std::min(Error(i, pose), wide_square_);
      }
      scores.emplace_back(Error(proposer, pose) > gate_square_, score, k);
    }
    std::sort(scores.begin(), scores.end());
    std::vector<Candidate> best;
    for (std::size_t k = 0; k < kMost; ++k) best.push_back((*candidates)[std::get<2>(scores[k])]);
    *candidates = std::move(best);
  }

  // From all that lies within the wide gate; where that explains no more than half of the frame,
  // something among them may have spoilt the fit: then from the candidate's own square, outwards.
  std::optional<Explanation> Explain(const Candidate& candidate) const {
    constexpr std::size_t kFewestToTrim = 5;
    auto found = AtOwnNoise(ExplainAll(candidate));
    if (seen_.size() < kFewestToTrim || (found && IsQuiet(*found))) return found;
    // What several have in common may have spoilt both. The noise of one that fewer than half
    // spoil is then far less.
    auto trimmed = AtOwnNoise(Trimmed(candidate.world_from_camera));
    const bool is_better =
        trimmed && IsMost(trimmed->used) && (!found || 2.0 * OwnNoise(*trimmed) < OwnNoise(*found));
    return is_better ? trimmed : found;
  }

  // Squared residuals of one detection's corners, summed [px^2].
  double Error(std::size_t i, const Pose& pose) const {
    return SquaredError(camera_, seen_[i], pose);
  }

 private:
  std::optional<Explanation> ExplainAll(const Candidate& candidate) const {
    auto all = Settle(candidate.world_from_camera,
                      ExplainedBy(candidate.world_from_camera, wide_square_),
                      gate_square_);
    if (seen_.size() == 1 || (all && IsMost(all->used))) return all;
    auto grown = Grow(candidate);
    if (grown) grown = Settle(grown->pose.world_from_camera, grown->used, gate_square_);
    if (grown && (!all || grown->used.size() > all->used.size())) all = std::move(grown);
    return all;
  }

  // The pose that fits best those more than half of the detections that it fits best (least trimmed
  // squares; Rousseeuw and Van Driessen 2006).
  std::optional<Explanation> Trimmed(const Pose& start) const {
    constexpr int kMostRounds = 10;
    std::optional<Explanation> found;
    for (int round = 0; round < kMostRounds; ++round) {
      const Pose& pose = found ? found->pose.world_from_camera : start;
      std::vector<std::pair<double, int>> errors;
      for (std::size_t i = 0; i < seen_.size(); ++i) {
        errors.emplace_back(Error(i, pose), static_cast<int>(i));
      }
      std::sort(errors.begin(), errors.end());
      std::vector<int> used;
      for (std::size_t k = 0; k <= seen_.size() / 2; ++k) used.push_back(errors[k].second);
      std::sort(used.begin(), used.end());
      if (found && used == found->used) return found;
      const auto refined = Refine(used, pose, std::numeric_limits<double>::infinity());
      if (!refined) return std::nullopt;
      found = Explanation{*refined, std::move(used)};
    }
    return found;
  }

  // The corners' standard deviation, from the detection in the middle of those used [px].
  double OwnNoise(const Explanation& found) const {
    std::vector<double> squares;
    for (const int i : found.used) squares.push_back(Error(i, found.pose.world_from_camera));
    const double dof = 8.0 - 6.0 / static_cast<double>(squares.size());
    return std::sqrt(Median(std::move(squares)) / ChiSquareAt(0.0, dof));
  }

  bool IsQuiet(const Explanation& found) const {
    constexpr double kMostNoise = 1.5;  // over that of most frames
    return IsMost(found.used) && OwnNoise(found) < kMostNoise * options_.corner_sigma;
  }

  bool IsMost(const std::vector<int>& used) const { return 2 * used.size() > seen_.size(); }

  // The explanation with the gate that its own noise sets, in place of one for all frames: a wrong
  // detection within a wide gate stands out against the others, and those of a noisy frame do not.
  // The noise is that of the detection in the middle. As before where few are to tell it.
  std::optional<Explanation> AtOwnNoise(std::optional<Explanation> found) const {
    constexpr std::size_t kFewest = 4;
    constexpr int kRounds = 2;
    constexpr double kGate = 4.0;          // standard deviations of the noise
    constexpr double kMostNoise = 3.0;     // over that of most frames
    constexpr double kSmallestGate = 1.0;  // [px], of what is no noise: lens, printing, edges
    for (int round = 0; round < kRounds; ++round) {
      if (!found || found->used.size() < kFewest || !IsMost(found->used)) return found;
      const double own = OwnNoise(*found);
      double gate = std::min(std::max(kGate * own, kSmallestGate), options_.gate);
      if (options_.corner_sigma > 0.0) {
        const double scale = std::clamp(own / options_.corner_sigma, 1.0, kMostNoise);
        gate = scale * options_.gate;
      }
      auto next = Settle(found->pose.world_from_camera,
                         ExplainedBy(found->pose.world_from_camera, 4.0 * gate * gate),
                         4.0 * gate * gate);
      if (!next || !IsMost(next->used)) return found;
      const bool is_same = next->used == found->used;
      found = std::move(next);
      if (is_same) return found;
    }
    return found;
  }

  std::vector<int> ExplainedBy(const Pose& pose, double square) const {
    std::vector<int> used;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      if (Error(i, pose) <= square) used.push_back(static_cast<int>(i));
    }
    return used;
  }

  std::optional<RefinedPose> Refine(const std::vector<int>& used,
                                    const Pose& start,
                                    double huber) const {
    std::vector<SeenCorner> corners;
    for (const int i : used) corners.insert(corners.end(), seen_[i].begin(), seen_[i].end());
    return RefinePose(camera_, corners, start, huber);
  }

  // Fits the pose to the detections that it explains until these stay the same. None if it comes to
  // explain nothing. `square`: what a detection may be off, summed over its corners [px^2].
  std::optional<Explanation> Settle(Pose pose, std::vector<int> used, double square) const {
    constexpr int kMostRounds = 5;
    for (int round = 0; round < kMostRounds && !used.empty(); ++round) {
      // The first fit may hold outliers: none of them may pull more than the gate allows.
      const double huber =
          round == 0 && used.size() > 1 ? std::min(options_.huber, options_.gate) : options_.huber;
      const auto refined = Refine(used, pose, huber);
      if (!refined) return std::nullopt;
      pose = refined->world_from_camera;
      std::vector<int> next = ExplainedBy(pose, square);
      if ((next == used && huber == options_.huber) || round + 1 == kMostRounds) {
        return Explanation{*refined, std::move(used)};
      }
      used = std::move(next);
    }
    return std::nullopt;
  }

  // The candidate's own square, and one by one the detection next to the pose so far, where one
  // pose explains it together with all those before. None if not even the square is explained.
  std::optional<Explanation> Grow(const Candidate& candidate) const {
    std::optional<Explanation> grown;
    std::vector<int> left = ExplainedBy(candidate.world_from_camera, wide_square_);
    std::erase(left, candidate.proposer);
    int added = candidate.proposer;
    Pose start = candidate.world_from_camera;
    while (true) {
      std::vector<int> used = grown ? grown->used : std::vector<int>();
      used.insert(std::upper_bound(used.begin(), used.end(), added), added);
      const auto refined = Refine(used, start, options_.huber);
      const bool is_consistent = refined && std::all_of(used.begin(), used.end(), [&](int i) {
                                   return Error(i, refined->world_from_camera) <= gate_square_;
                                 });
      if (is_consistent) grown = Explanation{*refined, std::move(used)};
      if (!grown || left.empty()) return grown;
      start = grown->pose.world_from_camera;
      const auto nearest = std::min_element(left.begin(), left.end(), [&](int a, int b) {
        return Error(a, start) < Error(b, start);
      });
      added = *nearest;
      left.erase(nearest);
    }
  }

  const CameraModel& camera_;
  const ViewPoseOptions options_;
  const double gate_square_;  // sum over a detection's corners [px^2]; and so the next
  double wide_square_;
  std::vector<std::array<SeenCorner, 4>> seen_;
};

}  // namespace

std::vector<Pose> SolveSquare(const CameraModel& camera,
                              double size,
                              const std::array<Eigen::Vector2d, 4>& corners) {
  const double largest_angle = LargestAngle(camera);
  std::array<Eigen::Vector2d, 4> slopes;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto ray = RayOf(camera, corners[i], largest_angle);
    if (!ray || !(ray->z() > 0.0)) return {};
    slopes[i] = ray->head<2>() / ray->z();
  }
  Marker marker;
  marker.size = size;
  Detection detection;
  detection.corners = corners;
  const auto seen = SeenCornersOf(marker, detection);  // the tag frame is the world
  struct Solution {
    Pose camera_from_tag;
    double squared_error;
  };
  std::vector<Solution> solutions;
  std::optional<RefinedPose> first;
  for (const Pose& camera_from_tag : SolveByIppe(size, slopes)) {
    const auto refined = RefinePose(
        camera, seen, camera_from_tag.Inverse(), std::numeric_limits<double>::infinity());
    if (!refined) continue;
    if (first &&
        IsSameMinimum(
            first->world_from_camera, refined->world_from_camera, first->unit_covariance)) {
      continue;
    }
    if (!first) first = refined;
    solutions.push_back({refined->world_from_camera.Inverse(),
                         SquaredError(camera, seen, refined->world_from_camera)});
  }
  std::stable_sort(solutions.begin(), solutions.end(), [](const Solution& a, const Solution& b) {
    return a.squared_error < b.squared_error;
  });
  std::vector<Pose> poses;
  for (const Solution& solution : solutions) poses.push_back(solution.camera_from_tag);
  return poses;
}

std::vector<ViewPose> SolveView(const CameraModel& camera,
                                const MarkerMap& map,
                                std::span<const Detection> frame,
                                const ViewPoseOptions& options) {
  std::vector<std::vector<Pose>> squares;
  for (const Detection& detection : frame) {
    squares.push_back(SolveSquare(camera, map.Find(detection.tag_id)->size, detection.corners));
  }
  return SolveView(camera, map, frame, squares, options);
}

std::vector<ViewPose> SolveView(const CameraModel& camera,
                                const MarkerMap& map,
                                std::span<const Detection> frame,
                                std::span<const std::vector<Pose>> squares,
                                const ViewPoseOptions& options) {
  const Frame corners(camera, map, frame, options);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Pose& world_from_tag = map.Find(frame[i].tag_id)->world_from_tag;
    for (const Pose& camera_from_tag : squares[i]) {
      candidates.push_back({world_from_tag * camera_from_tag.Inverse(), static_cast<int>(i)});
    }
  }
  corners.KeepTheBest(&candidates);

  std::vector<ViewPose> poses;
  for (const Candidate& candidate : candidates) {
    auto explanation = corners.Explain(candidate);
    if (!explanation) continue;
    ViewPose view;
    view.world_from_camera = explanation->pose.world_from_camera;
    view.unit_covariance = explanation->pose.unit_covariance;
    view.used = std::move(explanation->used);
    for (const int i : view.used) view.squared_error += corners.Error(i, view.world_from_camera);
    view.degrees_of_freedom = 8 * static_cast<int>(view.used.size()) - 6;
    view.noise_scale = NoiseScaleOf(view, options.corner_sigma);
    const bool is_known = std::any_of(poses.begin(), poses.end(), [&](const ViewPose& other) {
      return other.used == view.used &&
             IsSameMinimum(other.world_from_camera, view.world_from_camera, other.unit_covariance);
    });
    if (!is_known) poses.push_back(std::move(view));
  }
  std::stable_sort(poses.begin(), poses.end(), [](const ViewPose& a, const ViewPose& b) {
    if (a.used.size() != b.used.size()) return a.used.size() > b.used.size();
    return a.squared_error < b.squared_error;
  });
  return poses;
}

}  // namespace fathom
