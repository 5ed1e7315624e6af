// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/least_squares/least_squares.h"

#include "fathom/base/input_error.h"
#include "fathom/base/interval95.h"
#include "fathom/least_squares/regression.h"

#include <cmath>

#include <Eigen/SVD>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr int kFewestSamples = 8;  // two for each unknown

// A parameter takes part in an undetermined direction (of length 1) with at least this.
constexpr double kTakesPart = 0.1;

// What the parameters are worth once they exist.
void AddCaveats(LeastSquaresSummary* summary) {
  const ParameterVector parameters = ToVector(summary->model);
  for (const int index : {kQuadraticDamping, kLinearDamping}) {
    const double half_width = kStdsOf95 * std::sqrt(summary->covariance(index, index));
    if (parameters[index] < 0.0) {
      summary->caveats.push_back(fmt::format(
          "{} is negative ({:.4g} +- {:.2g}): unphysical. Another term or an unmodelled "
          "effect is taken for damping.",
          kParameterInfo[index].name,
          parameters[index],
          half_width));
    } else if (half_width > parameters[index]) {
      summary->caveats.push_back(fmt::format("{} is not distinguishable from 0 ({:.4g} +- {:.2g}).",
                                             kParameterInfo[index].name,
                                             parameters[index],
                                             half_width));
    }
  }
  summary->caveats.emplace_back(
      "The intervals take force and velocity as exact: noise of the velocity in v and v|v|, and "
      "whatever the model lacks, bias the parameters by an amount that they do not cover.");
}

}  // namespace

std::vector<std::string> LeastSquaresOptions::Problems() const {
  std::vector<std::string> problems;
  if (!(smallest_singular_value > 0.0 && smallest_singular_value < 1.0)) {
    problems.push_back(fmt::format("smallest_singular_value is {}, expected above 0 and below 1",
                                   smallest_singular_value));
  }
  if (max_noise_order < 0) {
    problems.push_back(fmt::format("max_noise_order is {}, expected at least 0", max_noise_order));
  }
  return problems;
}

LeastSquaresSummary FitLeastSquares(std::span<const Segment> segments,
                                    const LeastSquaresOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(
        fmt::format("The options of least squares cannot be used: {}", fmt::join(problems, "; ")));
  }
  LeastSquaresSummary summary;
  const Regression regression = RegressionOf(segments);
  const Eigen::MatrixX4d& F = regression.F;
  summary.num_samples = static_cast<int>(F.rows());
  if (F.rows() < kFewestSamples) {
    summary.message = fmt::format(
        "Only {} samples have an acceleration, expected at least {}.", F.rows(), kFewestSamples);
    return summary;
  }

  // F = U S V' diag(length): columns of unit length, so that no unit decides what is determined.
  Eigen::Vector4d length = F.colwise().norm();
  for (int k = 0; k < 4; ++k) {
    if (length[k] == 0.0) length[k] = 1.0;
  }
  const Eigen::MatrixXd scaled = F * length.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::Vector4d S = svd.singularValues();
  const Eigen::Matrix4d V = svd.matrixV();
  summary.singular_values = Eigen::JacobiSVD<Eigen::MatrixX4d>(F).singularValues();
  summary.condition_number = S[0] / S[3];

  // Parameter k of (1) belongs to column k, and alpha to all of (2): without it there is no
  // inertia.
  for (int k = 0; k < 4; ++k) {
    for (int direction = 0; direction < 4; ++direction) {
      if (S[direction] >= options.smallest_singular_value * S[0]) continue;
      if (std::abs(V(k, direction)) < kTakesPart) continue;
      summary.not_determined.emplace_back(kParameterInfo[k].name);
      break;
    }
  }
  if (!summary.not_determined.empty()) {
    summary.message = fmt::format(
        "The data do not determine {}: the columns of the regression are linearly dependent "
        "(condition number {:.2g}). Excite the vehicle with several frequencies or amplitudes.",
        fmt::join(summary.not_determined, ", "),
        summary.condition_number);
    return summary;
  }

  const Eigen::Matrix4d scaled_inverse = length.cwiseInverse().asDiagonal() * V *
                                         S.cwiseInverse().asDiagonal();  // (F'F)^-1 = its square
  const Eigen::Vector4d lumped =
      scaled_inverse * (svd.matrixU().transpose() * regression.acceleration);  // (3)
  const Eigen::VectorXd residual = regression.acceleration - F * lumped;
  summary.relative_error = residual.norm() / regression.acceleration.norm();
  const Eigen::Matrix4d lumped_covariance =
      CovarianceOf(regression,
                   residual,
                   scaled_inverse * scaled_inverse.transpose(),
                   options.max_noise_order);  // (4)
  const double alpha = lumped[0], alpha_std = std::sqrt(lumped_covariance(0, 0));
  if (!lumped.allFinite() || !lumped_covariance.allFinite()) {
    summary.message = "The solution is not finite: the samples are out of range.";
    return summary;
  }
  if (!(alpha > 0.0)) {
    summary.message = fmt::format(
        "The inertia would be {:.4g}, expected above 0: force and acceleration point in opposite "
        "directions. Check the sign of the force, the axes and the clocks.",
        1.0 / alpha);
    return summary;
  }
  if (alpha < kStdsOf95 * alpha_std) {
    summary.not_determined = {kParameterInfo[kInertia].name};
    summary.message = fmt::format(
        "The data do not determine the inertia: its inverse is {:.3g} +- {:.2g} (95 %), which "
        "includes 0.",
        alpha,
        kStdsOf95 * alpha_std);
    return summary;
  }
  summary.model = ModelFromVector(ParametersOf(lumped));  // (2)
  const Eigen::Matrix4d J = ParameterJacobian(lumped);
  summary.covariance = J * lumped_covariance * J.transpose();
  summary.usable = true;
  summary.message = fmt::format("Least squares over {} samples.", summary.num_samples);
  AddCaveats(&summary);
  return summary;
}

}  // namespace fathom
