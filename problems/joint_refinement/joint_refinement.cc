// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/joint_refinement.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/joint_refinement/chain_smoother.h"
#include "fathom/joint_refinement/clipped_loss.h"
#include "fathom/joint_refinement/first_guess.h"
#include "fathom/joint_refinement/joint_problem.h"
#include "fathom/joint_refinement/pose_spread.h"
#include "fathom/joint_refinement/process_fit.h"
#include "fathom/joint_refinement/setup_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

void RequireUsable(const JointInput& input, const JointOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(fmt::format("The options of the joint refinement cannot be used: {}",
                                 fmt::join(problems, "; ")));
  }
  if (input.runs.empty()) throw InputError("The joint refinement needs at least one run.");
  for (const CameraRun& run : input.runs) {
    const size_t n = run.time.size();
    if (n < 10 || run.detections.size() != n || run.world_from_body.size() != n) {
      throw InputError(
          fmt::format("A run has {} frames, {} lists of detections and {} poses, expected at least "
                      "10 of each and as many of one as of the other.",
                      n,
                      run.detections.size(),
                      run.world_from_body.size()));
    }
    for (const auto& detections : run.detections) {
      for (const Detection& detection : detections) {
        const Marker* const marker = input.map.Find(detection.tag_id);
        if (marker != nullptr && marker->is_surveyed) continue;
        throw InputError(
            fmt::format("A detection at {} s is of tag {}, expected a surveyed one of the map.",
                        detection.time,
                        detection.tag_id));
      }
    }
  }
}

double RootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0, mean = 0.0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  for (const double v : values) sum += (v - mean) * (v - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// How far and how fast the model moves along the runs.
MotionScales ScalesOf(const JointInput& input, const UncoupledModel<double>& model) {
  std::vector<double> x_all, v_all, a_all;
  for (const CameraRun& run : input.runs) {
    const Simulation simulation(run.command, run.time);
    std::vector<double> v(run.time.size()), x(run.time.size());
    if (!simulation.Run(model, {}, v, x)) continue;
    for (size_t k = 0; k < v.size(); ++k) {
      a_all.push_back(model.Acceleration(v[k], run.command.At(run.time[k])));
    }
    x_all.insert(x_all.end(), x.begin(), x.end());
    v_all.insert(v_all.end(), v.begin(), v.end());
  }
  MotionScales scales;
  if (x_all.empty()) return scales;
  const auto scale = [](const std::vector<double>& values) {
    return std::max(RootMeanSquare(values), 1e-9);
  };
  return {scale(x_all), scale(v_all), scale(a_all)};
}

// Start: the mean motion of the first model, each held coordinate at its mean, and the deviations
// that lead to the steady poses.
JointUnknowns FirstUnknowns(const UncoupledModel<double>& model,
                            const std::vector<std::vector<PoseVector>>& steady,
                            const ExcitedCoordinate& excited,
                            JointData* data) {
  JointUnknowns unknowns;
  unknowns.model = {
      std::log(model.inertia), model.quadratic_damping, model.linear_damping, model.buoyancy};
  unknowns.runs.resize(data->runs.size());
  for (size_t r = 0; r < data->runs.size(); ++r) {
    RunUnknowns& run = unknowns.runs[r];
    PredictedMotion& motion = data->runs[r].motion;
    const auto& eta = steady[r];
    const size_t n = eta.size();
    for (int j = 0; j < kNumHeld; ++j) {
      double& mean = run.response[static_cast<size_t>(j) * kResponseTerms];
      for (const PoseVector& pose : eta) {
        mean += pose[motion.HeldCoordinate(j)] / static_cast<double>(n);
      }
    }
    // The start by linear regression on its sensitivities: velocity and position at the first
    // frame.
    run.start = {0.0, excited.sign * eta[0][excited.index]};
    for (int iteration = 0; iteration < 3; ++iteration) {
      if (!motion.Update(unknowns.Motion(r))) break;
      Eigen::Matrix2d JJ = Eigen::Matrix2d::Zero();
      Eigen::Vector2d Jr = Eigen::Vector2d::Zero();
      for (size_t k = 0; k < n; ++k) {
        const auto D = motion.MeanDerivatives(k);
        const Eigen::Vector2d J = D.block<1, 2>(excited.index, kStartColumns).transpose();
        const double miss = eta[k][excited.index] - motion.Mean(k)[excited.index];
        JJ += J * J.transpose();
        Jr += miss * J;
      }
      const Eigen::Vector2d step = JJ.ldlt().solve(Jr);
      run.start[0] += step[0];
      run.start[1] += step[1];
    }
    motion.Update(unknowns.Motion(r));
    run.deviation.resize(n);
    run.rate.assign(n, {});
    for (size_t k = 0; k < n; ++k) {
      PoseVector::Map(run.deviation[k].data()) = eta[k] - motion.Mean(k);
    }
  }
  return unknowns;
}

// Robust size of a corner's error about the present poses [px]: from the median squared residual of
// the detections, which for eight normal ones is 7.34 times the variance.
double MedianCornerSigma(const JointData& data, const JointUnknowns& unknowns) {
  std::vector<double> squares;
  for (size_t r = 0; r < data.runs.size(); ++r) {
    for (size_t k = 0; k < data.runs[r].detections.size(); ++k) {
      const PoseVector eta = PoseAt(data.runs[r], unknowns.runs[r], k);
      for (const Detection& detection : data.runs[r].detections[k]) {
        CornerRows rows;
        if (EvaluateCorners(data.setup,
                            unknowns.setup,
                            *data.setup.map.Find(detection.tag_id),
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

std::vector<GlobalsPrior> PriorsOf(const JointOptions& options,
                                   const JointUnknowns& unknowns,
                                   const std::vector<int>& held_at_zero) {
  std::vector<GlobalsPrior> priors(unknowns.runs.size());
  for (size_t r = 0; r < priors.size(); ++r) {
    GlobalsPrior& prior = priors[r];
    for (const int i : held_at_zero) prior.std[i] = 0.0;
    prior.std[kClockColumn] = options.clock_offset_std;
    prior.offset[kClockColumn] = unknowns.runs[r].clock_offset;
    prior.std[kSizeColumn] = options.size_scale_std;
    prior.offset[kSizeColumn] = unknowns.setup.size_scale - 1.0;
    for (int i = 0; i < 6; ++i) {
      prior.std[kMountColumns + i] = i < 3 ? options.mount_position_std : options.mount_angle_std;
      prior.offset[kMountColumns + i] = unknowns.setup.mount[i];
    }
  }
  return priors;
}

ProcessSet FirstProcesses(double corner_sigma,
                          const UncoupledModel<double>& model,
                          const MotionScales& scales) {
  ProcessSet processes;
  processes.corner_sigma = corner_sigma;
  for (auto& wander : processes.wander) wander = {0.01, 0.5, 1.0};
  // A hundredth of the motion in ten seconds.
  const double drift = 0.01 * scales.displacement;
  processes.model_error = drift * drift / 333.0;
  processes.damping_rate = std::max(
      1e-3,
      (model.linear_damping + 2.0 * model.quadratic_damping * scales.velocity) / model.inertia);
  return processes;
}

int CountOutliers(const JointData& data,
                  const JointUnknowns& unknowns,
                  double corner_sigma,
                  size_t run) {
  int count = 0;
  for (size_t k = 0; k < data.runs[run].detections.size(); ++k) {
    const PoseVector eta = PoseAt(data.runs[run], unknowns.runs[run], k);
    for (const Detection& detection : data.runs[run].detections[k]) {
      CornerRows rows;
      const bool is_ahead = EvaluateCorners(data.setup,
                                            unknowns.setup,
                                            *data.setup.map.Find(detection.tag_id),
                                            detection,
                                            eta,
                                            corner_sigma,
                                            false,
                                            &rows);
      if (!is_ahead || rows.residual.squaredNorm() > data.loss_limit) ++count;
    }
  }
  return count;
}

}  // namespace

std::vector<std::string> JointOptions::Problems() const {
  std::vector<std::string> problems;
  const auto require_positive = [&](const char* name, double value) {
    if (!(value > 0.0)) {
      problems.push_back(fmt::format("{} is {}, expected a value above 0", name, value));
    }
  };
  const auto require_not_negative = [&](const char* name, double value) {
    if (!(value >= 0.0)) {
      problems.push_back(fmt::format("{} is {}, expected 0 or more", name, value));
    }
  };
  require_positive("loss_limit", loss_limit);
  require_positive("max_iterations", max_iterations);
  require_positive("num_threads", num_threads);
  require_positive("max_rounds", max_rounds);
  require_not_negative("clock_offset_std", clock_offset_std);
  require_not_negative("size_scale_std", size_scale_std);
  require_not_negative("mount_position_std", mount_position_std);
  require_not_negative("mount_angle_std", mount_angle_std);
  if (initial_guess) require_positive("initial_guess.inertia", initial_guess->inertia);
  return problems;
}

JointSummary FitJoint(const JointInput& input, const JointOptions& options) {
  RequireUsable(input, options);
  JointSummary summary;

  // Start.
  const ExcitedCoordinate excited = ExcitedCoordinateOf(input.dof, input.runs);
  std::vector<std::vector<PoseVector>> steady;
  for (const CameraRun& run : input.runs) steady.push_back(SteadyPoses(run));
  const UncoupledModel<double> first =
      options.initial_guess ? *options.initial_guess : FirstModel(input, excited, steady);
  const MotionScales scales = ScalesOf(input, first);
  JointData data;
  data.setup = {input.camera, input.map, input.body_from_camera};
  data.excited = excited.index;
  data.loss_limit = options.loss_limit;
  for (const CameraRun& run : input.runs) {
    data.runs.push_back({run.detections, PredictedMotion(run.command, run.time, excited, scales)});
    for (const auto& detections : run.detections) {
      summary.num_detections += static_cast<int>(detections.size());
    }
  }
  JointUnknowns unknowns = FirstUnknowns(first, steady, excited, &data);
  ProcessSet processes = FirstProcesses(MedianCornerSigma(data, unknowns), first, scales);

  summary.num_rounds = summary.num_iterations = 0;
  std::vector<LinearRun> linear;
  double likelihood = -std::numeric_limits<double>::infinity();
  std::vector<int> held_at_zero;
  bool processes_settled = false;
  SetupFit setup;
  constexpr double kSettled = 0.5;  // of the log-likelihood
  for (int round = 0; round < options.max_rounds; ++round) {
    if (options.on_round) options.on_round(round + 1, options.max_rounds);
    if (!Linearise(&data, unknowns, processes.corner_sigma, &linear)) {
      summary.message = "the simulation diverges, or a marker falls behind the camera.";
      return summary;
    }
    const auto priors = WithSetupHeld(PriorsOf(options, unknowns, held_at_zero));
    const double before =
        round == 0 ? -std::numeric_limits<double>::infinity()
                   : LinearJoint(linear, priors, processes, excited.index).log_likelihood();
    const ProcessFit fit = FitProcesses(linear, priors, processes, excited.index);
    if (!std::isfinite(fit.log_likelihood)) {
      summary.message = "some unknown leaves no trace in the corners.";
      return summary;
    }
    processes_settled = fit.converged;
    likelihood = fit.log_likelihood;
    if (round > 0 && likelihood < before + kSettled) break;
    processes = fit.processes;
    for (RunUnknowns& run : unknowns.runs) {
      for (int i = 0; i < kNumResponse; ++i) {
        const bool is_mean = i % kResponseTerms == 0;
        if (!is_mean && processes.response_std[i / kResponseTerms] == 0.0) run.response[i] = 0.0;
      }
    }
    const JointSolve solve =
        SolveJoint(&data,
                   processes,
                   PriorsOf(options, unknowns, {}),
                   {.max_iterations = options.max_iterations, .num_threads = options.num_threads},
                   &unknowns);
    ++summary.num_rounds;
    if (round == 0) summary.initial_cost = solve.initial_cost;
    summary.num_iterations += solve.num_iterations;
    summary.seconds_per_iteration = solve.seconds_per_iteration;
    summary.final_cost = solve.cost;
    summary.message = solve.message;
    summary.converged = solve.converged;
    held_at_zero = solve.held_at_zero;
    if (!solve.converged) return summary;
    setup = FitSetup([&](const JointUnknowns& at) { return PriorsOf(options, at, held_at_zero); },
                     &data,
                     &processes,
                     &unknowns);
    if (!setup.converged) {
      summary.converged = false;
      summary.message = setup.message;
      return summary;
    }
  }

  // The covariance at the end.
  if (!Linearise(&data, unknowns, processes.corner_sigma, &linear)) {
    summary.converged = false;
    summary.message = "the corners cannot be projected at the end of the search.";
    return summary;
  }
  const LinearJoint end(
      linear, PriorsOf(options, unknowns, {}), processes, excited.index, &setup.information);
  summary.model = data.runs[0].motion.size() > 0 ? unknowns.Motion(0).Model() : summary.model;
  for (const int i : held_at_zero) summary.on_bound[i] = true;
  summary.determined = end.is_usable();
  if (!end.is_usable()) {
    summary.message = "some unknown leaves no trace in the corners.";
    return summary;
  }
  Eigen::Vector4d by_log = Eigen::Vector4d::Ones();
  by_log[kInertia] = summary.model.inertia;
  summary.covariance =
      by_log.asDiagonal() * end.covariance(0).topLeftCorner<4, 4>() * by_log.asDiagonal();
  summary.size_scale = unknowns.setup.size_scale;
  summary.mount = unknowns.setup.mount;
  const auto std_of = [&](size_t run, int column) {
    return std::sqrt(end.covariance(run)(column, column));
  };
  if (options.size_scale_std > 0.0) summary.size_scale_std = std_of(0, kSizeColumn);
  for (int i = 0; i < 6; ++i) {
    const bool is_free = (i < 3 ? options.mount_position_std : options.mount_angle_std) > 0.0;
    if (is_free) summary.mount_std[i] = std_of(0, kMountColumns + i);
  }
  summary.processes = processes;
  if (!processes_settled) {
    summary.caveats.push_back(
        "The search for how the held coordinates wander did not settle: the intervals are less "
        "sure "
        "than they look.");
  }
  for (size_t r = 0; r < unknowns.runs.size(); ++r) {
    const RunUnknowns& own = unknowns.runs[r];
    RefinedRun run;
    run.start = {own.start[0], own.start[1]};
    for (int j = 0; j < kNumHeld; ++j) {
      std::copy_n(
          own.response.begin() + j * kResponseTerms, kResponseTerms, run.response[j].begin());
    }
    run.clock_offset = own.clock_offset;
    if (options.clock_offset_std > 0.0) run.clock_offset_std = std_of(r, kClockColumn);
    for (size_t k = 0; k < own.deviation.size(); ++k) {
      run.world_from_body.push_back(PoseFromVector(PoseAt(data.runs[r], own, k)));
      run.displacement.push_back(data.runs[r].motion.displacement(k));
      run.velocity.push_back(data.runs[r].motion.velocity(k));
    }
    run.pose_covariance = PoseSpread(
        end, r, data.runs[r].motion, [&](size_t k) { return PoseAt(data.runs[r], own, k); });
    run.num_outliers = CountOutliers(data, unknowns, processes.corner_sigma, r);
    summary.runs.push_back(std::move(run));
  }
  return summary;
}

}  // namespace fathom
