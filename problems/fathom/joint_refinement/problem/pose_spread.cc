// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/pose_spread.h"

#include <cmath>

namespace fathom {
namespace {

// d(translation, rotation vector about the body's axes) / d eta.
Eigen::Matrix<double, 6, 6> BodyFromChart(const PoseVector& eta) {
  const double cr = std::cos(eta[3]), sr = std::sin(eta[3]);
  const double cp = std::cos(eta[4]), sp = std::sin(eta[4]);
  Eigen::Matrix<double, 6, 6> M = Eigen::Matrix<double, 6, 6>::Identity();
  M.bottomRightCorner<3, 3>() << 1.0, 0.0, -sp,  //
      0.0, cr, sr * cp,                          //
      0.0, -sr, cr * cp;
  return M;
}

}  // namespace

std::vector<Eigen::Matrix<double, 6, 6>> PoseSpread(
    const LinearJoint& joint,
    size_t segment,
    const PredictedMotion& motion,
    const Eigen::Quaterniond& world_from_frame,
    const std::function<PoseVector(size_t)>& eta_of) {
  std::vector<Eigen::Matrix<double, 6, 6>> spread(motion.size());
  const std::vector<int>& columns = joint.columns(segment);
  const Eigen::MatrixXd covariance = joint.covariance(segment)(columns, columns);
  joint.ForEachFrame(segment,
                     [&](size_t k, const ChainSmoother::Square& P, const ChainSmoother::Border& G) {
                       const PredictedMotion::Derivatives mean = motion.MeanDerivatives(k);
                       Eigen::Matrix<double, 6, Eigen::Dynamic> J = mean(Eigen::all, columns);
                       Eigen::Matrix<double, 6, 6> S;
                       for (int i = 0; i < 6; ++i) {
                         J.row(i) += G.row(2 * i);
                         for (int j = 0; j < 6; ++j) S(i, j) = P(2 * i, 2 * j);
                       }
                       S.noalias() += J * covariance * J.transpose();
                       Eigen::Matrix<double, 6, 6> M = BodyFromChart(eta_of(k));
                       M.topLeftCorner<3, 3>() = world_from_frame.toRotationMatrix();
                       spread[k] = M * S * M.transpose();
                     });
  return spread;
}

}  // namespace fathom
