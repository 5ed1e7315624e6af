// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/joint_start.h"

#include "fathom/base/median.h"
#include "fathom/joint_refinement/motion/segment_frame.h"
#include "fathom/joint_refinement/search/first_guess.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fathom {
namespace {

double StandardDeviation(const std::vector<double>& values) {
  double sum = 0.0, mean = 0.0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  for (const double v : values) sum += (v - mean) * (v - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// How far and how fast the model moves along the segments.
MotionScales ScalesOf(const JointInput& input, const UncoupledModel<double>& model) {
  std::vector<double> x_all, v_all, a_all;
  for (const CameraSegment& segment : input.segments) {
    const Simulation simulation(segment.command, segment.time);
    std::vector<double> v(segment.time.size()), x(segment.time.size());
    if (!simulation.Run(model, {}, v, x)) continue;
    for (size_t k = 0; k < v.size(); ++k) {
      a_all.push_back(model.Acceleration(v[k], segment.command.At(segment.time[k])));
    }
    x_all.insert(x_all.end(), x.begin(), x.end());
    v_all.insert(v_all.end(), v.begin(), v.end());
  }
  MotionScales scales;
  if (x_all.empty()) return scales;
  const auto scale = [](const std::vector<double>& values) {
    return std::max(StandardDeviation(values), 1e-9);
  };
  return {scale(x_all), scale(v_all), scale(a_all)};
}

// Start: the mean motion of the first model, each held coordinate at its mean, and the deviations
// that lead to the steady poses.
JointUnknowns FirstUnknowns(const UncoupledModel<double>& model,
                            const std::vector<std::vector<PoseVector>>& steady,
                            JointData* data) {
  JointUnknowns unknowns;
  unknowns.model = {
      std::log(model.inertia), model.quadratic_damping, model.linear_damping, model.buoyancy};
  unknowns.segments.resize(data->segments.size());
  for (size_t r = 0; r < data->segments.size(); ++r) {
    SegmentUnknowns& segment = unknowns.segments[r];
    PredictedMotion& motion = data->segments[r].motion;
    const auto& eta = steady[r];
    const size_t n = eta.size();
    for (int j = 0; j < kNumHeld; ++j) {
      double& mean = segment.response[static_cast<size_t>(j) * kResponseTerms];
      for (const PoseVector& pose : eta) {
        mean += pose[motion.HeldCoordinate(j)] / static_cast<double>(n);
      }
    }
    // The start by linear regression on its sensitivities: velocity and position at the first
    // frame.
    segment.start = {0.0, eta[0][data->excited]};
    for (int iteration = 0; iteration < 3; ++iteration) {
      if (!motion.Update(unknowns.Motion(r))) break;
      Eigen::Matrix2d JJ = Eigen::Matrix2d::Zero();
      Eigen::Vector2d Jr = Eigen::Vector2d::Zero();
      for (size_t k = 0; k < n; ++k) {
        const auto D = motion.MeanDerivatives(k);
        const Eigen::Vector2d J = D.block<1, 2>(data->excited, kStartColumns).transpose();
        const double miss = eta[k][data->excited] - motion.Mean(k)[data->excited];
        JJ += J * J.transpose();
        Jr += miss * J;
      }
      const Eigen::Vector2d step = JJ.ldlt().solve(Jr);
      segment.start[0] += step[0];
      segment.start[1] += step[1];
    }
    motion.Update(unknowns.Motion(r));
    segment.deviation.resize(n);
    segment.rate.assign(n, {});
    for (size_t k = 0; k < n; ++k) {
      PoseVector::Map(segment.deviation[k].data()) = eta[k] - motion.Mean(k);
    }
  }
  return unknowns;
}

// Takes the deviations away, and puts each held coordinate at its median.
void HoldStill(const std::vector<std::vector<PoseVector>>& steady,
               JointData* data,
               JointUnknowns* unknowns) {
  for (size_t r = 0; r < steady.size(); ++r) {
    SegmentUnknowns& segment = unknowns->segments[r];
    PredictedMotion& motion = data->segments[r].motion;
    for (int j = 0; j < kNumHeld; ++j) {
      std::vector<double> values;
      for (const PoseVector& pose : steady[r]) values.push_back(pose[motion.HeldCoordinate(j)]);
      segment.response[static_cast<size_t>(j) * kResponseTerms] = Median(std::move(values));
    }
    segment.deviation.assign(steady[r].size(), {});
    motion.Update(unknowns->Motion(r));
  }
}

// Robust size of a corner's error about the present poses [px]: from the median squared residual of
// the detections, which for eight normal ones is 7.34 times the variance.
double MedianCornerSigma(const JointData& data, const JointUnknowns& unknowns) {
  std::vector<double> squares;
  for (size_t r = 0; r < data.segments.size(); ++r) {
    for (size_t k = 0; k < data.segments[r].detections.size(); ++k) {
      const PoseVector eta = PoseAt(data.segments[r], unknowns.segments[r], k);
      for (const Detection& detection : data.segments[r].detections[k]) {
        CornerRows rows;
        if (EvaluateCorners(data.setup,
                            unknowns.setup,
                            *data.segments[r].map.Find(detection.tag_id),
                            detection,
                            eta,
                            1.0,
                            false,
                            &rows)) {
          squares.push_back(rows.residual.squaredNorm());
        }
      }
    }
  }
  if (squares.empty()) return 1.0;
  return std::max(1e-4, std::sqrt(Median(std::move(squares)) / 7.34));
}

// That the excited DOF strays from the model by `drift` within `duration` [s].
void SetModelError(double drift, double duration, double damping_rate, ProcessSet* processes) {
  processes->model_error = 3.0 * drift * drift / std::pow(duration, 3);
  processes->damping_rate = std::max(1e-3, damping_rate);
}

// For a DOF that no model moves: it stands still, and nothing follows it.
constexpr UncoupledModel<double> kNoModel = {1.0, 0.0, 0.0, 0.0};
constexpr MotionScales kNoScales = {std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::infinity()};

double DisplacementStd(const std::vector<std::vector<PoseVector>>& steady, int excited) {
  std::vector<double> x;
  for (const auto& segment : steady) {
    for (const PoseVector& eta : segment) x.push_back(eta[excited]);
  }
  return std::max(StandardDeviation(x), 1e-6);
}

}  // namespace

JointStart StartOf(const JointInput& input,
                   const JointOptions& options,
                   StartPoses poses,
                   std::span<const Pose> world_from_frame,
                   std::span<const std::vector<Pose>> frame_from_body) {
  std::vector<std::vector<PoseVector>> steady;
  for (const std::vector<Pose>& poses : frame_from_body) steady.push_back(SteadyPoses(poses));
  const UncoupledModel<double> model = options.moves_freely    ? kNoModel
                                       : options.initial_guess ? *options.initial_guess
                                                               : FirstModel(input, steady);
  const MotionScales scales = options.moves_freely ? kNoScales : ScalesOf(input, model);
  JointStart start;
  start.scales = scales;
  start.data.setup = {input.camera, input.body_from_camera};
  start.data.excited = Index(input.dof);
  start.data.loss_limit = options.loss_limit;
  for (size_t r = 0; r < input.segments.size(); ++r) {
    const CameraSegment& segment = input.segments[r];
    const HeldCommand command =
        options.moves_freely ? HeldCommand{{segment.time.front()}, {0.0}} : segment.command;
    start.data.segments.push_back(
        {segment.detections,
         MapIn(world_from_frame[r].Inverse(), input.map),
         PredictedMotion(command, segment.time, start.data.excited, scales)});
  }
  start.unknowns = FirstUnknowns(model, steady, &start.data);
  start.poses = poses;
  if (poses == StartPoses::kHeldStill) HoldStill(steady, &start.data, &start.unknowns);
  start.processes.corner_sigma = MedianCornerSigma(start.data, start.unknowns);
  for (auto& wander : start.processes.wander) wander = {0.01, 0.5, 1.0};
  if (options.moves_freely) {  // a tenth of the motion in a second
    SetModelError(0.1 * DisplacementStd(steady, start.data.excited), 1.0, 0.0, &start.processes);
  } else {  // a hundredth in ten
    const double damping = model.linear_damping + 2.0 * model.quadratic_damping * scales.velocity;
    SetModelError(0.01 * scales.displacement, 10.0, damping / model.inertia, &start.processes);
  }
  return start;
}

}  // namespace fathom
