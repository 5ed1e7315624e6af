// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/joint_problem.h"

#include "fathom/joint_refinement/problem/active_set.h"
#include "fathom/joint_refinement/problem/clipped_loss.h"
#include "fathom/joint_refinement/problem/linear_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <ceres/cost_function.h>
#include <ceres/evaluation_callback.h>
#include <ceres/loss_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>

namespace fathom {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class Loss final : public ceres::LossFunction {
 public:
  explicit Loss(double limit) : limit_(limit) {}
  void Evaluate(double s, double rho[3]) const override {
    const ClippedLoss loss = ClippedLoss::Of(s, limit_);
    rho[0] = loss.value;
    rho[1] = loss.weight;
    rho[2] = loss.second_derivative;
  }

 private:
  const double limit_;
};

// Simulates every run once per point, before Ceres asks any corner.
class Simulate final : public ceres::EvaluationCallback {
 public:
  Simulate(JointData* data, const JointUnknowns* unknowns, bool is_model_held)
      : data_(data),
        unknowns_(unknowns),
        is_model_held_(is_model_held),
        is_valid_(data->runs.size(), false) {}

  void PrepareForEvaluation(bool /*evaluate_jacobians*/, bool new_evaluation_point) override {
    if (is_prepared_ && (!new_evaluation_point || is_model_held_)) return;
    for (size_t r = 0; r < data_->runs.size(); ++r) {
      is_valid_[r] = data_->runs[r].motion.Update(unknowns_->Motion(r));
    }
    is_prepared_ = true;
  }

  bool is_valid(size_t run) const { return is_valid_[run]; }

 private:
  JointData* const data_;
  const JointUnknowns* const unknowns_;
  const bool is_model_held_;
  std::vector<char> is_valid_;
  bool is_prepared_ = false;
};

// Which coordinates have deviations of their own.
std::vector<int> MovingCoordinates(const ProcessSet& processes, int excited) {
  std::vector<int> moving;
  for (int i = 0; i < 6; ++i) {
    if (processes.Of(i, excited).IsPresent()) moving.push_back(i);
  }
  return moving;
}

// Reprojection of one detection, whitened. Blocks: deviation of the frame (if any coordinate
// moves), model, start, response, and the clock if it is free.
class CornerCost final : public ceres::CostFunction {
 public:
  CornerCost(const JointData& data,
             const Simulate& simulate,
             const std::vector<int>& moving,
             const JointUnknowns& unknowns,
             double corner_sigma,
             size_t run,
             size_t frame,
             const Detection& detection,
             bool with_clock)
      : data_(data),
        simulate_(simulate),
        moving_(moving),
        unknowns_(unknowns),
        corner_sigma_(corner_sigma),
        run_(run),
        frame_(frame),
        detection_(detection),
        marker_(*data.runs[run].map.Find(detection.tag_id)) {
    set_num_residuals(8);
    auto* const sizes = mutable_parameter_block_sizes();
    if (!moving.empty()) sizes->push_back(static_cast<int>(moving.size()));
    sizes->insert(sizes->end(), {kModelColumns, 2, kNumResponse});
    first_columns_ = {0, kStartColumns, kResponseColumns};
    if (with_clock) {
      sizes->push_back(1);
      first_columns_.push_back(kClockColumn);
    }
  }

  bool Evaluate(const double* const* parameters,
                double* residuals,
                double** jacobians) const override {
    if (!simulate_.is_valid(run_)) return false;
    const PredictedMotion& motion = data_.runs[run_].motion;
    PoseVector eta = motion.Mean(frame_);
    for (size_t i = 0; i < moving_.size(); ++i) eta[moving_[i]] += parameters[0][i];
    CornerRows rows;
    if (!EvaluateCorners(
            data_.setup, unknowns_.setup, marker_, detection_, eta, corner_sigma_, false, &rows)) {
      return false;
    }
    std::copy_n(rows.residual.data(), 8, residuals);
    if (jacobians == nullptr) return true;
    size_t block = 0;
    if (!moving_.empty()) {
      if (double* const out = jacobians[block++]; out != nullptr) {
        for (int row = 0; row < 8; ++row) {
          for (size_t i = 0; i < moving_.size(); ++i) {
            out[row * moving_.size() + i] = rows.by_pose(row, moving_[i]);
          }
        }
      }
    }
    const bool is_model_held = std::all_of(
        jacobians + block, jacobians + parameter_block_sizes().size(), [](const double* jacobian) {
          return jacobian == nullptr;
        });
    if (is_model_held) return true;
    const PredictedMotion::Derivatives mean = motion.MeanDerivatives(frame_);
    for (const int first : first_columns_) {
      const int size = parameter_block_sizes()[block];
      if (double* const out = jacobians[block++]; out != nullptr) {
        Eigen::Map<RowMajor> J(out, 8, size);
        J.noalias() = rows.by_pose * mean.middleCols(first, size);
      }
    }
    return true;
  }

 private:
  const JointData& data_;
  const Simulate& simulate_;
  const std::vector<int>& moving_;
  const JointUnknowns& unknowns_;
  const double corner_sigma_;
  const size_t run_, frame_;
  const Detection& detection_;
  const Marker& marker_;
  std::vector<int> first_columns_;
};

// Holds the entries whose std is 0, and those in `also`.
void Hold(double* block,
          const std::vector<double>& std,
          std::vector<int> also,
          ceres::Problem* problem) {
  for (size_t i = 0; i < std.size(); ++i) {
    if (std[i] == 0.0) also.push_back(static_cast<int>(i));
  }
  std::sort(also.begin(), also.end());
  also.erase(std::unique(also.begin(), also.end()), also.end());
  if (also.size() == std.size()) {
    problem->SetParameterBlockConstant(block);
    return;
  }
  problem->SetParameterBlockVariable(block);
  problem->SetManifold(
      block,
      also.empty() ? nullptr : new ceres::SubsetManifold(static_cast<int>(std.size()), also));
}

// What Ceres moves of the deviations: the moving coordinates side by side.
struct Blocks {
  std::vector<std::vector<double>> deviation, rate;  // by run; n numbers a frame

  void Load(const JointUnknowns& unknowns, const std::vector<int>& moving) {
    deviation.assign(unknowns.runs.size(), {});
    rate = deviation;
    for (size_t r = 0; r < unknowns.runs.size(); ++r) {
      for (size_t k = 0; k < unknowns.runs[r].deviation.size(); ++k) {
        for (const int i : moving) {
          deviation[r].push_back(unknowns.runs[r].deviation[k][i]);
          rate[r].push_back(unknowns.runs[r].rate[k][i]);
        }
      }
    }
  }

  void Store(const std::vector<int>& moving, JointUnknowns* unknowns) const {
    for (size_t r = 0; r < unknowns->runs.size(); ++r) {
      RunUnknowns& run = unknowns->runs[r];
      for (size_t k = 0; k < run.deviation.size(); ++k) {
        run.deviation[k] = run.rate[k] = {};
        for (size_t i = 0; i < moving.size(); ++i) {
          run.deviation[k][moving[i]] = deviation[r][k * moving.size() + i];
          run.rate[k][moving[i]] = rate[r][k * moving.size() + i];
        }
      }
    }
  }
};

// The search of the joint problem with dampings held or free.
class DampingSearch final : public BoundedSearch {
 public:
  // `model`: its block. Counts and times go to `counts`.
  DampingSearch(const ceres::Solver::Options& options,
                std::vector<double> model_std,
                double* model,
                ceres::Problem* problem,
                JointSolve* counts)
      : options_(options),
        model_std_(std::move(model_std)),
        model_(model),
        problem_(problem),
        counts_(counts) {
    problem->GetParameterBlocks(&blocks_);
  }

  Optimum Solve(const std::vector<int>& held) override {
    Hold(model_, model_std_, held, problem_);
    ceres::Solver::Summary summary;
    ceres::Solve(options_, problem_, &summary);
    if (counts_->num_iterations == 0) counts_->initial_cost = summary.initial_cost;
    counts_->num_iterations += static_cast<int>(summary.iterations.size());
    if (summary.iterations.size() > 1) {
      double seconds = 0.0;
      for (size_t i = 1; i < summary.iterations.size(); ++i) {
        seconds += summary.iterations[i].iteration_time_in_seconds;
      }
      counts_->seconds_per_iteration = seconds / static_cast<double>(summary.iterations.size() - 1);
    }
    return {summary.termination_type == ceres::CONVERGENCE, summary.final_cost, summary.message};
  }

  double Value(int unknown) const override { return model_[unknown]; }
  void SetToZero(int unknown) override { model_[unknown] = 0.0; }

  std::vector<double> Point() const override {
    std::vector<double> point;
    for (const double* const block : blocks_) {
      point.insert(point.end(), block, block + problem_->ParameterBlockSize(block));
    }
    return point;
  }

  void GoTo(const std::vector<double>& point) override {
    const double* from = point.data();
    for (double* const block : blocks_) {
      const int size = problem_->ParameterBlockSize(block);
      std::copy_n(from, size, block);
      from += size;
    }
  }

 private:
  const ceres::Solver::Options options_;
  const std::vector<double> model_std_;
  double* const model_;
  ceres::Problem* const problem_;
  JointSolve* const counts_;
  std::vector<double*> blocks_;
};

}  // namespace

JointSolve SolveJoint(JointData* data,
                      const ProcessSet& processes,
                      const std::vector<GlobalsPrior>& priors,
                      const JointSolveOptions& options,
                      JointUnknowns* unknowns) {
  const std::vector<int> moving = options.without_model
                                      ? std::vector<int>{0, 1, 2, 3, 4, 5}
                                      : MovingCoordinates(processes, data->excited);
  const size_t n = moving.size();
  Blocks blocks;
  blocks.Load(*unknowns, moving);
  Simulate simulate(data, unknowns, options.without_model);
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = &simulate;
  problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  Loss loss(data->loss_limit);
  ceres::Problem problem(problem_options);

  for (size_t r = 0; r < data->runs.size(); ++r) {
    const JointRun& run = data->runs[r];
    RunUnknowns& own = unknowns->runs[r];
    const bool with_clock = priors[r].std[kClockColumn] > 0.0;
    for (size_t k = 0; k < run.detections.size(); ++k) {
      for (const Detection& detection : run.detections[k]) {
        std::vector<double*> list;
        if (n > 0) list.push_back(&blocks.deviation[r][k * n]);
        list.insert(list.end(), {unknowns->model.data(), own.start.data(), own.response.data()});
        if (with_clock) list.push_back(&own.clock_offset);
        problem.AddResidualBlock(new CornerCost(*data,
                                                simulate,
                                                moving,
                                                *unknowns,
                                                processes.corner_sigma,
                                                r,
                                                k,
                                                detection,
                                                with_clock),
                                 &loss,
                                 list);
      }
    }
    if (options.without_model) {
      problem.SetParameterBlockConstant(own.start.data());
      problem.SetParameterBlockConstant(own.response.data());
      continue;
    }
    if (n > 0) {
      LinearRun layout;
      LayOutDurations(run.motion.time(), &layout);
      std::vector<ceres::CostFunction*> step_costs;
      for (const double duration : layout.durations) {
        step_costs.push_back(MakeStepCost(processes, data->excited, moving, duration).release());
      }
      for (size_t k = 0; k + 1 < run.detections.size(); ++k) {
        problem.AddResidualBlock(step_costs[layout.duration_after[k]],
                                 nullptr,
                                 &blocks.deviation[r][k * n],
                                 &blocks.rate[r][k * n],
                                 &blocks.deviation[r][(k + 1) * n],
                                 &blocks.rate[r][(k + 1) * n]);
      }
      problem.AddResidualBlock(MakeFirstCost(processes, data->excited, moving).release(),
                               nullptr,
                               blocks.deviation[r].data(),
                               blocks.rate[r].data());
    }
    std::vector<double> response_std(kNumResponse, std::numeric_limits<double>::infinity());
    for (int i = 0; i < kNumResponse; ++i) {
      if (i % kResponseTerms != 0) response_std[i] = processes.response_std[i / kResponseTerms];
    }
    const auto add_prior = [&](std::unique_ptr<ceres::CostFunction> cost, double* block) {
      if (cost != nullptr) problem.AddResidualBlock(cost.release(), nullptr, block);
    };
    add_prior(MakePriorCost(response_std, std::vector<double>(kNumResponse)), own.response.data());
    Hold(own.response.data(), response_std, {}, &problem);
    if (with_clock) {
      const double mean = own.clock_offset - priors[r].offset[kClockColumn];
      add_prior(MakePriorCost({priors[r].std[kClockColumn]}, {mean}), &own.clock_offset);
    }
  }

  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.max_num_iterations = options.max_iterations;
  solver.num_threads = 1;  // with more the cost is summed in another order: other last bits
  solver.initial_trust_region_radius = 1e8;
  solver.function_tolerance = 1e-8;  // of a cost of half the rows: no parameter moves visibly
  solver.parameter_tolerance = 1e-9;
  solver.gradient_tolerance = 1e-12;
  solver.logging_type = ceres::SILENT;

  // Ceres' own bounds report convergence at a wrong point when one is active, so the active set is
  // found outside.
  JointSolve result;
  const auto model_std =
      options.without_model
          ? std::vector<double>(kModelColumns)
          : std::vector<double>(priors[0].std.begin(), priors[0].std.begin() + kModelColumns);
  DampingSearch search(solver, model_std, unknowns->model.data(), &problem, &result);
  std::vector<int> bounded;
  for (const int i : {kQuadraticDamping, kLinearDamping}) {
    if (model_std[i] > 0.0) bounded.push_back(i);
  }
  const BoundedOptimum optimum = SearchActiveSet(bounded, solver.function_tolerance, &search);
  result.converged = optimum.converged;
  result.cost = optimum.cost;
  result.message = optimum.message;
  result.held_at_zero = optimum.held;
  blocks.Store(moving, unknowns);
  return result;
}

}  // namespace fathom
