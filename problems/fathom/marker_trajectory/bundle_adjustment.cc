// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/bundle_adjustment.h"

#include "fathom/marker_trajectory/corner_residual.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

using Matrix6 = PoseCovariance;
using Jacobian = Eigen::Matrix<double, 2, 6, Eigen::RowMajor>;

// The normal equations of a frame, whitened: its own block and its couplings to free markers.
struct FrameInformation {
  Matrix6 own = Matrix6::Zero();
  std::map<int, Matrix6> with_marker;  // by the marker's index among the free ones
};

class Bundle {
 public:
  Bundle(const CameraModel& camera,
         const MarkerMap& map,
         const std::set<int>& free_ids,
         std::span<const Detection> detections,
         std::span<const AdjustedFrame> frames,
         const BundleAdjustmentOptions& options)
      : camera_(camera), map_(map), detections_(detections), frames_(frames), options_(options) {
    for (const int id : free_ids) {
      const int index = static_cast<int>(index_of_free_id_.size());
      index_of_free_id_[id] = index;
    }
    camera_steps_.assign(frames.size(), PoseIncrement::Zero());
    tag_steps_.assign(free_ids.size(), PoseIncrement::Zero());
  }

  BundleAdjustmentSummary Solve() {
    BundleAdjustmentSummary summary;
    // One loss for all corners, which outlives the problem.
    std::unique_ptr<ceres::LossFunction> loss;
    if (std::isfinite(options_.huber)) loss = std::make_unique<ceres::HuberLoss>(options_.huber);
    ceres::Problem::Options problem_options;
    problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(problem_options);
    ForEachCorner([&](std::size_t frame, int free_index, const CornerResidual& residual) {
      if (free_index < 0) {
        problem.AddResidualBlock(
            new ceres::AutoDiffCostFunction<CornerResidual, 2, 6>(new CornerResidual(residual)),
            loss.get(),
            camera_steps_[frame].data());
      } else {
        problem.AddResidualBlock(
            new ceres::AutoDiffCostFunction<CornerResidual, 2, 6, 6>(new CornerResidual(residual)),
            loss.get(),
            camera_steps_[frame].data(),
            tag_steps_[free_index].data());
      }
    });
    ceres::Solver::Options solver;
    solver.max_num_iterations = options_.max_num_iterations;
    // What is left to gain is below 1e-9 of the sum of squares: a few thousandths of a standard
    // deviation.
    solver.function_tolerance = 1e-9;
    solver.gradient_tolerance = 1e-9;
    solver.parameter_tolerance = 1e-12;
    solver.logging_type = ceres::SILENT;
    if (tag_steps_.empty()) {
      solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    } else {
      solver.linear_solver_type = ceres::DENSE_SCHUR;
      auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
      for (PoseIncrement& step : camera_steps_) ordering->AddElementToGroup(step.data(), 0);
      for (PoseIncrement& step : tag_steps_) {
        if (problem.HasParameterBlock(step.data())) ordering->AddElementToGroup(step.data(), 1);
      }
      solver.linear_solver_ordering = ordering;
    }
    ceres::Solver::Summary report;
    ceres::Solve(solver, &problem, &report);
    summary.num_iterations = static_cast<int>(report.iterations.size());
    if (!report.IsSolutionUsable()) {
      summary.message = "the bundle adjustment failed: " + report.message;
      return summary;
    }
    if (report.termination_type != ceres::CONVERGENCE) {
      summary.message = fmt::format("the bundle adjustment did not converge in {} iterations.",
                                    options_.max_num_iterations);
      return summary;
    }
    TakeOver(&summary);
    return summary;
  }

 private:
  // Calls visit(frame, index of the free marker or -1, residual) for every corner.
  template <typename Visit>
  void ForEachCorner(Visit visit) const {
    for (std::size_t frame = 0; frame < frames_.size(); ++frame) {
      CHECK(!frames_[frame].detections.empty()) << "frame " << frame << " holds no detection";
      for (const int index : frames_[frame].detections) {
        const Detection& detection = detections_[index];
        const Marker* marker = map_.Find(detection.tag_id);
        CHECK(marker != nullptr) << "tag " << detection.tag_id << " is not in the map";
        const auto free = index_of_free_id_.find(detection.tag_id);
        const auto corners_in_tag = CornersInTag(marker->size);
        for (std::size_t i = 0; i < 4; ++i) {
          visit(frame,
                free == index_of_free_id_.end() ? -1 : free->second,
                CornerResidual{.camera = &camera_,
                               .world_from_camera = &frames_[frame].world_from_camera,
                               .world_from_tag = &marker->world_from_tag,
                               .corner_in_tag = corners_in_tag[i],
                               .pixel = detection.corners[i],
                               .corner_sigma = options_.corner_sigma});
        }
      }
    }
  }

  void TakeOver(BundleAdjustmentSummary* summary) {
    summary->map = map_;
    for (Marker& marker : summary->map.markers) {
      const auto free = index_of_free_id_.find(marker.id);
      if (free == index_of_free_id_.end()) continue;
      marker.world_from_tag = Moved(marker.world_from_tag, tag_steps_[free->second]);
      marker.is_surveyed = true;
    }
    for (const auto& [id, index] : index_of_free_id_) summary->free_ids.push_back(id);
    std::vector<AdjustedFrame> at_end(frames_.begin(), frames_.end());
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      at_end[i].world_from_camera = Moved(frames_[i].world_from_camera, camera_steps_[i]);
      summary->world_from_camera.push_back(at_end[i].world_from_camera);
    }
    // Covariances are about the poses found: steps of the steps.
    std::set<int> free_ids(summary->free_ids.begin(), summary->free_ids.end());
    Bundle end(camera_, summary->map, free_ids, detections_, at_end, options_);
    end.SetCovariances(summary);
  }

  void SetCovariances(BundleAdjustmentSummary* summary) {
    const std::size_t num_free = tag_steps_.size();
    std::vector<FrameInformation> information(frames_.size());
    Eigen::MatrixXd markers = Eigen::MatrixXd::Zero(6 * num_free, 6 * num_free);
    std::vector<double> squares(frames_.size(), 0.0);
    std::vector<int> num_corners(frames_.size(), 0);
    ForEachCorner([&](std::size_t frame, int free_index, const CornerResidual& residual) {
      const double* steps[] = {camera_steps_[frame].data(),
                               free_index < 0 ? nullptr : tag_steps_[free_index].data()};
      Eigen::Vector2d value;
      Jacobian by_camera, by_tag;
      double* jacobians[] = {by_camera.data(), by_tag.data()};
      if (free_index < 0) {
        const ceres::AutoDiffCostFunction<CornerResidual, 2, 6> cost(new CornerResidual(residual));
        cost.Evaluate(steps, value.data(), jacobians);
      } else {
        const ceres::AutoDiffCostFunction<CornerResidual, 2, 6, 6> cost(
            new CornerResidual(residual));
        cost.Evaluate(steps, value.data(), jacobians);
      }
      squares[frame] += value.squaredNorm();
      ++num_corners[frame];
      const double weight = std::min(1.0, options_.huber / value.norm());
      FrameInformation& own = information[frame];
      own.own += weight * by_camera.transpose() * by_camera;
      if (free_index < 0) return;
      own.with_marker.try_emplace(free_index, Matrix6::Zero()).first->second +=
          weight * by_camera.transpose() * by_tag;
      markers.block<6, 6>(6 * free_index, 6 * free_index) += weight * by_tag.transpose() * by_tag;
    });

    double sum = 0.0, dof = -6.0 * static_cast<double>(num_free);
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      sum += squares[i];
      dof += 2.0 * num_corners[i] - 6.0;
      summary->frame_rms.push_back(options_.corner_sigma * std::sqrt(squares[i] / num_corners[i]));
    }
    if (!(dof > 0.0)) {
      summary->message = "there are not more corners than unknowns.";
      return;
    }
    const double factor = sum / dof;  // of all variances
    summary->corner_sigma = options_.corner_sigma * std::sqrt(factor);
    summary->corner_sigma_std = summary->corner_sigma / std::sqrt(2.0 * dof);

    // Schur: what the markers know once every frame's pose has adapted to them.
    std::vector<Matrix6> inverse(frames_.size());
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const Eigen::LDLT<Matrix6> ldlt(information[i].own);
      inverse[i] = ldlt.solve(Matrix6::Identity());
      if (!ldlt.isPositive() || !inverse[i].allFinite()) {
        summary->message =
            fmt::format("the corners of the frame at t = {} do not determine the camera's pose.",
                        detections_[frames_[i].detections.front()].time);
        return;
      }
      for (const auto& [a, by_a] : information[i].with_marker) {
        for (const auto& [b, by_b] : information[i].with_marker) {
          markers.block<6, 6>(6 * a, 6 * b) -= by_a.transpose() * inverse[i] * by_b;
        }
      }
    }
    Eigen::MatrixXd marker_covariance;
    if (num_free > 0) {
      // Whether the free markers hang together with the fixed ones: no direction without
      // information, in units of the markers' own.
      const Eigen::VectorXd scale = markers.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
      const Eigen::MatrixXd scaled = scale.asDiagonal() * markers * scale.asDiagonal();
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
      constexpr double kSmallest = 1e-10;
      if (!(eigen.eigenvalues().minCoeff() > kSmallest)) {
        summary->message =
            "the corners do not determine where the free markers are: some are never seen together "
            "with markers whose place is known.";
        return;
      }
      marker_covariance = scale.asDiagonal() * eigen.eigenvectors() *
                          eigen.eigenvalues().cwiseInverse().asDiagonal() *
                          eigen.eigenvectors().transpose() * scale.asDiagonal();
    }
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      Matrix6 covariance = inverse[i];
      for (const auto& [a, by_a] : information[i].with_marker) {
        for (const auto& [b, by_b] : information[i].with_marker) {
          covariance += inverse[i] * by_a * marker_covariance.block<6, 6>(6 * a, 6 * b) *
                        by_b.transpose() * inverse[i];
        }
      }
      summary->pose_covariance.push_back(factor * covariance);
    }
    for (std::size_t k = 0; k < num_free; ++k) {
      summary->marker_covariance.push_back(factor * marker_covariance.block<6, 6>(6 * k, 6 * k));
    }
    summary->is_usable = true;
  }

  const CameraModel& camera_;
  const MarkerMap& map_;
  std::span<const Detection> detections_;
  std::span<const AdjustedFrame> frames_;
  const BundleAdjustmentOptions& options_;
  std::map<int, int> index_of_free_id_;
  std::vector<PoseIncrement> camera_steps_;
  std::vector<PoseIncrement> tag_steps_;
};

}  // namespace

BundleAdjustmentSummary AdjustBundle(const CameraModel& camera,
                                     const MarkerMap& map,
                                     const std::set<int>& free_ids,
                                     std::span<const Detection> detections,
                                     std::span<const AdjustedFrame> frames,
                                     const BundleAdjustmentOptions& options) {
  CHECK_GT(options.corner_sigma, 0.0);
  CHECK_GT(options.huber, 0.0);
  if (frames.empty()) {
    BundleAdjustmentSummary summary;
    summary.map = map;
    summary.message = "there is no frame with a pose.";
    return summary;
  }
  return Bundle(camera, map, free_ids, detections, frames, options).Solve();
}

}  // namespace fathom
