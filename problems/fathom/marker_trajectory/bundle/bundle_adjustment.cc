// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/bundle/bundle_adjustment.h"

#include "fathom/marker_trajectory/bundle/bundle_corners.h"
#include "fathom/marker_trajectory/bundle/bundle_covariance.h"

#include <cmath>
#include <cstddef>
#include <memory>

#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

// How far the cameras of the frames and the free markers are moved from their start.
struct BundleSteps {
  std::vector<PoseIncrement> of_camera;
  std::vector<PoseIncrement> of_tag;
};

void AddCorners(const Bundle& bundle,
                ceres::LossFunction* loss,
                BundleSteps* steps,
                ceres::Problem* problem) {
  ForEachCorner(bundle, [&](std::size_t frame, int free_index, const CornerResidual& residual) {
    if (free_index < 0) {
      problem->AddResidualBlock(
          new ceres::AutoDiffCostFunction<CornerResidual, 2, 6>(new CornerResidual(residual)),
          loss,
          steps->of_camera[frame].data());
    } else {
      problem->AddResidualBlock(
          new ceres::AutoDiffCostFunction<CornerResidual, 2, 6, 6>(new CornerResidual(residual)),
          loss,
          steps->of_camera[frame].data(),
          steps->of_tag[free_index].data());
    }
  });
}

ceres::Solver::Options SolverOptions(const BundleAdjustmentOptions& options,
                                     const ceres::Problem& problem,
                                     BundleSteps* steps) {
  ceres::Solver::Options solver;
  solver.max_num_iterations = options.max_num_iterations;
  // What is left to gain is below 1e-9 of the sum of squares: a few thousandths of a standard
  // deviation.
  solver.function_tolerance = 1e-9;
  solver.gradient_tolerance = 1e-9;
  solver.parameter_tolerance = 1e-12;
  solver.logging_type = ceres::SILENT;
  if (steps->of_tag.empty()) {
    solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    return solver;
  }
  solver.linear_solver_type = ceres::DENSE_SCHUR;
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (PoseIncrement& step : steps->of_camera) ordering->AddElementToGroup(step.data(), 0);
  for (PoseIncrement& step : steps->of_tag) {
    if (problem.HasParameterBlock(step.data())) ordering->AddElementToGroup(step.data(), 1);
  }
  solver.linear_solver_ordering = ordering;
  return solver;
}

// Searches the steps. Says in the summary why they are of no use, and returns false, if it fails.
bool Search(const Bundle& bundle, BundleSteps* steps, BundleAdjustmentSummary* summary) {
  const BundleAdjustmentOptions& options = bundle.options;
  // One loss for all corners, which outlives the problem.
  std::unique_ptr<ceres::LossFunction> loss;
  if (std::isfinite(options.huber)) loss = std::make_unique<ceres::HuberLoss>(options.huber);
  ceres::Problem::Options problem_options;
  problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(problem_options);
  AddCorners(bundle, loss.get(), steps, &problem);
  ceres::Solver::Summary report;
  ceres::Solve(SolverOptions(options, problem, steps), &problem, &report);
  summary->num_iterations = static_cast<int>(report.iterations.size());
  if (!report.IsSolutionUsable()) {
    summary->message = "the bundle adjustment failed: " + report.message;
    return false;
  }
  if (report.termination_type != ceres::CONVERGENCE) {
    summary->message = fmt::format("the bundle adjustment did not converge in {} iterations.",
                                   options.max_num_iterations);
    return false;
  }
  return true;
}

MarkerMap MovedMap(const Bundle& bundle, const BundleSteps& steps) {
  MarkerMap map = bundle.map;
  for (Marker& marker : map.markers) {
    const auto free = bundle.index_of_free_id.find(marker.id);
    if (free == bundle.index_of_free_id.end()) continue;
    marker.world_from_tag = Moved(marker.world_from_tag, steps.of_tag[free->second]);
    marker.is_surveyed = true;
  }
  return map;
}

}  // namespace

BundleAdjustmentSummary AdjustBundle(const CameraModel& camera,
                                     const MarkerMap& map,
                                     const std::set<int>& free_ids,
                                     std::span<const Detection> detections,
                                     std::span<const AdjustedFrame> frames,
                                     const BundleAdjustmentOptions& options) {
  CHECK_GT(options.corner_sigma, 0.0);
  CHECK_GT(options.huber, 0.0);
  BundleAdjustmentSummary summary;
  if (frames.empty()) {
    summary.map = map;
    summary.message = "there is no frame with a pose.";
    return summary;
  }
  const Bundle bundle = {camera, map, detections, frames, options, IndexOf(free_ids)};
  BundleSteps steps = {
      std::vector<PoseIncrement>(frames.size(), PoseIncrement(PoseIncrement::Zero())),
      std::vector<PoseIncrement>(free_ids.size(), PoseIncrement(PoseIncrement::Zero()))};
  if (!Search(bundle, &steps, &summary)) return summary;
  summary.map = MovedMap(bundle, steps);
  summary.free_ids.assign(free_ids.begin(), free_ids.end());
  std::vector<AdjustedFrame> at_end(frames.begin(), frames.end());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    at_end[i].world_from_camera = Moved(frames[i].world_from_camera, steps.of_camera[i]);
    summary.world_from_camera.push_back(at_end[i].world_from_camera);
  }
  // Covariances are about the poses found: steps of the steps.
  SetCovariances({camera, summary.map, detections, at_end, options, bundle.index_of_free_id},
                 &summary);
  return summary;
}

}  // namespace fathom
