// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/bundle/bundle_covariance.h"

#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Cholesky>
#include <ceres/autodiff_cost_function.h>
#include <fmt/format.h>

namespace fathom {
namespace {

using Matrix6 = PoseCovariance;
using Jacobian = Eigen::Matrix<double, 2, 6, Eigen::RowMajor>;

// The normal equations of a frame, whitened: its own block and its couplings to free markers.
struct FrameInformation {
  Matrix6 own = Matrix6::Zero();
  std::map<int, Matrix6> with_marker;  // by the marker's index among the free ones
  double squares = 0.0;                // of its residuals
  int num_corners = 0;
};

struct BundleInformation {
  std::vector<FrameInformation> frames;
  Eigen::MatrixXd markers;  // the free ones' own blocks
};

// A corner's residual and its derivatives by small moves of its camera and of its marker.
struct LinearCorner {
  Eigen::Vector2d value;
  Jacobian by_camera = Jacobian::Zero(), by_tag = Jacobian::Zero();
};

LinearCorner LinearisedWithTag(const CornerResidual& residual) {
  LinearCorner corner;
  const PoseIncrement none = PoseIncrement::Zero();
  const double* steps[] = {none.data(), none.data()};
  double* jacobians[] = {corner.by_camera.data(), corner.by_tag.data()};
  const ceres::AutoDiffCostFunction<CornerResidual, 2, 6, 6> cost(new CornerResidual(residual));
  cost.Evaluate(steps, corner.value.data(), jacobians);
  return corner;
}

// With by_tag 0.
LinearCorner LinearisedWithoutTag(const CornerResidual& residual) {
  LinearCorner corner;
  const PoseIncrement none = PoseIncrement::Zero();
  const double* steps[] = {none.data()};
  double* jacobians[] = {corner.by_camera.data()};
  const ceres::AutoDiffCostFunction<CornerResidual, 2, 6> cost(new CornerResidual(residual));
  cost.Evaluate(steps, corner.value.data(), jacobians);
  return corner;
}

BundleInformation InformationOf(const Bundle& end) {
  const std::size_t num_free = end.index_of_free_id.size();
  BundleInformation information;
  information.frames.resize(end.frames.size());
  information.markers = Eigen::MatrixXd::Zero(6 * num_free, 6 * num_free);
  ForEachCorner(end, [&](std::size_t frame, int free_index, const CornerResidual& residual) {
    const LinearCorner corner =
        free_index < 0 ? LinearisedWithoutTag(residual) : LinearisedWithTag(residual);
    FrameInformation& own = information.frames[frame];
    own.squares += corner.value.squaredNorm();
    ++own.num_corners;
    const double weight = std::min(1.0, end.options.huber / corner.value.norm());
    own.own += weight * corner.by_camera.transpose() * corner.by_camera;
    if (free_index < 0) return;
    own.with_marker.try_emplace(free_index, Matrix6::Zero()).first->second +=
        weight * corner.by_camera.transpose() * corner.by_tag;
    information.markers.block<6, 6>(6 * free_index, 6 * free_index) +=
        weight * corner.by_tag.transpose() * corner.by_tag;
  });
  return information;
}

// Fills the frames' rms and the corner sigma. The factor of all variances; nothing if there are not
// more corners than unknowns.
std::optional<double> SetNoise(const BundleInformation& information,
                               std::span<const AdjustedFrame> at_end,
                               double assumed_sigma,
                               BundleAdjustmentSummary* summary) {
  double sum = 0.0, dof = -static_cast<double>(information.markers.rows());
  for (std::size_t i = 0; i < at_end.size(); ++i) {
    const FrameInformation& frame = information.frames[i];
    sum += frame.squares;
    dof += 2.0 * frame.num_corners - 6.0;
    const double sigma = assumed_sigma * at_end[i].noise_scale;
    summary->frame_rms.push_back(sigma * std::sqrt(frame.squares / frame.num_corners));
  }
  if (!(dof > 0.0)) return std::nullopt;
  const double factor = sum / dof;
  summary->corner_sigma = assumed_sigma * std::sqrt(factor);
  summary->corner_sigma_std = summary->corner_sigma / std::sqrt(2.0 * dof);
  return factor;
}

// Takes out of `markers` what every frame's pose adapts to (Schur's complement). The inverses of
// the frames' own blocks, up to the first that does not determine its pose.
std::vector<Matrix6> EliminateFrames(const std::vector<FrameInformation>& frames,
                                     Eigen::MatrixXd* markers) {
  std::vector<Matrix6> inverses;
  for (const FrameInformation& frame : frames) {
    const Eigen::LDLT<Matrix6> ldlt(frame.own);
    const Matrix6 inverse = ldlt.solve(Matrix6::Identity());
    if (!ldlt.isPositive() || !inverse.allFinite()) return inverses;
    for (const auto& [a, by_a] : frame.with_marker) {
      for (const auto& [b, by_b] : frame.with_marker) {
        markers->block<6, 6>(6 * a, 6 * b) -= by_a.transpose() * inverse * by_b;
      }
    }
    inverses.push_back(inverse);
  }
  return inverses;
}

// Nothing if some direction is without information, in units of the markers' own: free markers then
// do not hang together with the fixed ones.
std::optional<Eigen::MatrixXd> MarkerCovariance(const Eigen::MatrixXd& markers) {
  if (markers.size() == 0) return Eigen::MatrixXd();
  const Eigen::VectorXd scale = markers.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * markers * scale.asDiagonal();
  const SymmetricEigen eigen = EigenOf(scaled);
  constexpr double kSmallest = 1e-10;
  if (!(eigen.values.minCoeff() > kSmallest)) return std::nullopt;
  return scale.asDiagonal() * eigen.vectors * eigen.values.cwiseInverse().asDiagonal() *
         eigen.vectors.transpose() * scale.asDiagonal();
}

// Of a frame's pose, with what is not known of the markers that it shows.
Matrix6 WithMarkers(const FrameInformation& frame,
                    const Matrix6& inverse,
                    const Eigen::MatrixXd& marker_covariance) {
  Matrix6 covariance = inverse;
  for (const auto& [a, by_a] : frame.with_marker) {
    for (const auto& [b, by_b] : frame.with_marker) {
      covariance +=
          inverse * by_a * marker_covariance.block<6, 6>(6 * a, 6 * b) * by_b.transpose() * inverse;
    }
  }
  return covariance;
}

}  // namespace

void SetCovariances(const Bundle& end, BundleAdjustmentSummary* summary) {
  BundleInformation information = InformationOf(end);
  const auto factor = SetNoise(information, end.frames, end.options.corner_sigma, summary);
  if (!factor) {
    summary->message = "there are too few corners for the unknowns.";
    return;
  }
  const std::vector<Matrix6> inverses = EliminateFrames(information.frames, &information.markers);
  if (inverses.size() < end.frames.size()) {
    const AdjustedFrame& frame = end.frames[inverses.size()];
    summary->message =
        fmt::format("the corners of the frame at t = {} do not determine the camera's pose.",
                    end.detections[frame.detections.front()].time);
    return;
  }
  const auto marker_covariance = MarkerCovariance(information.markers);
  if (!marker_covariance) {
    summary->message =
        "the corners do not determine the positions of the free markers: some are never seen "
        "together with markers of known position.";
    return;
  }
  for (std::size_t i = 0; i < end.frames.size(); ++i) {
    const Matrix6 covariance = WithMarkers(information.frames[i], inverses[i], *marker_covariance);
    summary->pose_covariance.push_back(*factor * covariance);
  }
  for (std::size_t k = 0; k < end.index_of_free_id.size(); ++k) {
    summary->marker_covariance.push_back(*factor * marker_covariance->block<6, 6>(6 * k, 6 * k));
  }
  summary->is_usable = true;
}

}  // namespace fathom
