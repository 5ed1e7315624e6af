// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/joint_problem.h"

#include "fathom/joint_refinement/problem/deviation_blocks.h"
#include "fathom/joint_refinement/problem/frame_cost.h"
#include "fathom/joint_refinement/problem/linear_cost.h"
#include "fathom/joint_refinement/problem/motion_callback.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include <ceres/cost_function.h>
#include <ceres/problem.h>

namespace fathom {
namespace {

// Which coordinates have deviations of their own.
std::vector<int> MovingCoordinates(const ProcessSet& processes, int excited) {
  std::vector<int> moving;
  for (int i = 0; i < 6; ++i) {
    if (processes.Of(i, excited).IsPresent()) moving.push_back(i);
  }
  return moving;
}

// The Ceres problem while it is put together. Borrows all of it.
struct Assembly {
  const JointData& data;
  const ProcessSet& processes;
  const std::vector<int>& moving;
  JointUnknowns* unknowns;
  DeviationBlocks* blocks;
  ceres::Problem* problem;
};

// The corners of a segment.
void AddCorners(const Assembly& to, size_t r, bool with_clock, const MotionCallback& motions) {
  const JointSegment& segment = to.data.segments[r];
  SegmentUnknowns& own = to.unknowns->segments[r];
  const size_t n = to.moving.size();
  for (size_t k = 0; k < segment.detections.size(); ++k) {
    if (segment.detections[k].empty()) continue;
    std::vector<double*> list;
    if (n > 0) list.push_back(&to.blocks->deviation[r][k * n]);
    list.insert(list.end(), {to.unknowns->model.data(), own.start.data(), own.response.data()});
    if (with_clock) list.push_back(&own.clock_offset);
    auto cost = MakeFrameCost(
        {to.data, motions, to.moving, *to.unknowns, to.processes.corner_sigma, r, k, with_clock});
    to.problem->AddResidualBlock(cost.release(), nullptr, list);
  }
}

// How the moving coordinates of a segment go from frame to frame.
void AddChain(const Assembly& to, size_t r) {
  const size_t n = to.moving.size();
  if (n == 0) return;
  const JointSegment& segment = to.data.segments[r];
  std::vector<double>& deviation = to.blocks->deviation[r];
  std::vector<double>& rate = to.blocks->rate[r];
  const int excited = to.data.excited;
  LinearSegment layout;
  LayOutDurations(segment.motion.time(), &layout);
  std::vector<ceres::CostFunction*> step_costs;
  for (const double duration : layout.durations) {
    step_costs.push_back(MakeStepCost(to.processes, excited, to.moving, duration).release());
  }
  for (size_t k = 0; k + 1 < segment.detections.size(); ++k) {
    to.problem->AddResidualBlock(step_costs[layout.duration_after[k]],
                                 nullptr,
                                 &deviation[k * n],
                                 &rate[k * n],
                                 &deviation[(k + 1) * n],
                                 &rate[(k + 1) * n]);
  }
  to.problem->AddResidualBlock(MakeFirstCost(to.processes, excited, to.moving).release(),
                               nullptr,
                               deviation.data(),
                               rate.data());
}

// The entries whose std is 0: what a prior knows for certain.
std::vector<int> Certain(const std::vector<double>& std) {
  std::vector<int> entries;
  for (size_t i = 0; i < std.size(); ++i) {
    if (std[i] == 0.0) entries.push_back(static_cast<int>(i));
  }
  return entries;
}

// What is known beforehand of a segment's responses and clock.
void AddPriors(const Assembly& to, size_t r, const GlobalsPrior& prior) {
  SegmentUnknowns& own = to.unknowns->segments[r];
  std::vector<double> response_std(kNumResponse, std::numeric_limits<double>::infinity());
  for (int i = 0; i < kNumResponse; ++i) {
    if (i % kResponseTerms != 0) response_std[i] = to.processes.response_std[i / kResponseTerms];
  }
  const auto add = [&](std::unique_ptr<ceres::CostFunction> cost, double* block) {
    if (cost != nullptr) to.problem->AddResidualBlock(cost.release(), nullptr, block);
  };
  add(MakePriorCost(response_std, std::vector<double>(kNumResponse)), own.response.data());
  HoldEntries(own.response.data(), Certain(response_std), to.problem);
  if (!(prior.std[kClockColumn] > 0.0)) return;
  const double mean = own.clock_offset - prior.offset[kClockColumn];
  add(MakePriorCost({prior.std[kClockColumn]}, {mean}), &own.clock_offset);
}

BoundedSolve SolveWithDampings(const std::vector<double>& model_std,
                               int max_iterations,
                               double* model,
                               ceres::Problem* problem) {
  BoundedSolveOptions options;
  options.max_iterations = max_iterations;
  options.function_tolerance = 1e-8;  // of a cost of half the rows: no parameter moves visibly
  options.initial_trust_region_radius = 1e8;
  std::vector<int> bounded;
  for (const int i : {kQuadraticDamping, kLinearDamping}) {
    if (model_std[i] > 0.0) bounded.push_back(i);
  }
  return SolveWithBounds(options, bounded, Certain(model_std), model, problem);
}

}  // namespace

BoundedSolve SolveJoint(JointData* data,
                        const ProcessSet& processes,
                        const std::vector<GlobalsPrior>& priors,
                        const JointSolveOptions& options,
                        JointUnknowns* unknowns) {
  const std::vector<int> moving = options.without_model
                                      ? std::vector<int>{0, 1, 2, 3, 4, 5}
                                      : MovingCoordinates(processes, data->excited);
  DeviationBlocks blocks;
  blocks.Load(*unknowns, moving);
  MotionCallback motions(data, unknowns, options.without_model);
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = &motions;
  ceres::Problem problem(problem_options);
  const Assembly assembly = {*data, processes, moving, unknowns, &blocks, &problem};
  for (size_t r = 0; r < data->segments.size(); ++r) {
    AddCorners(assembly, r, priors[r].std[kClockColumn] > 0.0, motions);
    if (options.without_model) {
      problem.SetParameterBlockConstant(unknowns->segments[r].start.data());
      problem.SetParameterBlockConstant(unknowns->segments[r].response.data());
      continue;
    }
    AddChain(assembly, r);
    AddPriors(assembly, r, priors[r]);
  }
  std::vector<double> model_std(kModelColumns);
  if (!options.without_model) std::copy_n(priors[0].std.begin(), kModelColumns, model_std.begin());
  BoundedSolve result =
      SolveWithDampings(model_std, options.max_iterations, unknowns->model.data(), &problem);
  blocks.Store(moving, unknowns);
  return result;
}

}  // namespace fathom
