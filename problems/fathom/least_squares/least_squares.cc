// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/least_squares/least_squares.h"

#include "fathom/base/input_error.h"
#include "fathom/base/interval95.h"
#include "fathom/base/short_number.h"
#include "fathom/least_squares/regression.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>
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
    const double std = std::sqrt(summary->covariance(index, index));
    if (parameters[index] < 0.0) {
      summary->caveats.push_back(fmt::format(
          "{} is negative (95 % interval {}), which is unphysical. The fit takes another term or "
          "an unmodelled effect for damping.",
          kParameterInfo[index].name,
          FormatInterval(parameters[index], std)));
    } else if (kStdsOf95 * std > parameters[index]) {
      summary->caveats.push_back(
          fmt::format("{} cannot be distinguished from 0 (95 % interval {}).",
                      kParameterInfo[index].name,
                      FormatInterval(parameters[index], std)));
    }
  }
  summary->caveats.emplace_back(
      "The intervals treat force and velocity as exact. They do not cover the bias from velocity "
      "noise in v and v|v|, or from effects that the model lacks.");
}

// F = U S V' diag(length): columns of unit length, so that no unit decides what is determined.
struct Decomposition {
  Eigen::Vector4d length;
  Eigen::Vector4d S;
  Eigen::Matrix4d V;
  Eigen::Vector4d projected;  // U' acceleration
};

// R of (scaled F, acceleration) = Q R, a stretch of rows at a time: U is as long as the log, and is
// needed only as U' times the acceleration.
Decomposition Decompose(const Regression& regression) {
  constexpr Eigen::Index kStretch = 1024;
  const Eigen::MatrixX4d& F = regression.F;
  Decomposition decomposition;
  decomposition.length = F.colwise().norm();
  for (double& length : decomposition.length) {
    if (length == 0.0) length = 1.0;
  }
  const Eigen::Vector4d unscale = decomposition.length.cwiseInverse();
  Eigen::Matrix<double, 5, 5> R = Eigen::Matrix<double, 5, 5>::Zero();
  for (Eigen::Index begin = 0; begin < F.rows(); begin += kStretch) {
    const Eigen::Index count = std::min(kStretch, F.rows() - begin);
    Eigen::MatrixXd rows(5 + count, 5);
    rows.topRows<5>() = R;
    rows.bottomRows(count) << F.middleRows(begin, count) * unscale.asDiagonal(),
        regression.acceleration.segment(begin, count);
    const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(rows);
    R = rows.topRows<5>().triangularView<Eigen::Upper>();
  }
  const Eigen::JacobiSVD<Eigen::Matrix4d> svd(R.topLeftCorner<4, 4>(),
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  decomposition.S = svd.singularValues();
  decomposition.V = svd.matrixV();
  decomposition.projected = svd.matrixU().transpose() * R.topRightCorner<4, 1>();
  return decomposition;
}

// Names of the parameters that take part in a direction whose singular value is below the share
// `smallest` of the largest. Parameter k of (1) belongs to column k, and alpha to all of (2):
// without it there is no inertia.
std::vector<std::string> NotDetermined(const Decomposition& decomposition, double smallest) {
  const auto& [length, S, V, projected] = decomposition;
  std::vector<std::string> names;
  for (int k = 0; k < 4; ++k) {
    for (int direction = 0; direction < 4; ++direction) {
      if (S[direction] >= smallest * S[0]) continue;
      if (std::abs(V(k, direction)) < kTakesPart) continue;
      names.emplace_back(kParameterInfo[k].name);
      break;
    }
  }
  return names;
}

// alpha, beta, mu and nu of (1).
struct Lumped {
  Eigen::Vector4d value;
  Eigen::Matrix4d covariance;

  double alpha() const { return value[0]; }
  double alpha_std() const { return std::sqrt(covariance(0, 0)); }
  bool IsFinite() const { return value.allFinite() && covariance.allFinite(); }
};

Lumped SolveLumped(const Decomposition& decomposition,
                   const Regression& regression,
                   int max_noise_order) {
  const auto& [length, S, V, projected] = decomposition;
  const Eigen::Matrix4d scaled_inverse = length.cwiseInverse().asDiagonal() * V *
                                         S.cwiseInverse().asDiagonal();  // (F'F)^-1 = its square
  Lumped lumped;
  lumped.value = scaled_inverse * projected;  // (3)
  const Eigen::VectorXd residual = regression.acceleration - regression.F * lumped.value;
  lumped.covariance = CovarianceOf(regression,
                                   residual,
                                   scaled_inverse * scaled_inverse.transpose(),
                                   max_noise_order);  // (4)
  return lumped;
}

// Why there is no model; empty if there is one.
std::string WhyNoModel(const Lumped& lumped) {
  if (!lumped.IsFinite()) {
    return "The solution is not finite: the samples are out of range.";
  }
  const double alpha = lumped.alpha(), half_width = kStdsOf95 * lumped.alpha_std();
  if (!(alpha > 0.0)) {
    return fmt::format(
        "The inertia would be {:.4g}, expected above 0: force and acceleration point in opposite "
        "directions. Check the sign of the force, the axes and the clocks.",
        1.0 / alpha);
  }
  if (alpha < half_width) {
    return fmt::format(
        "The data do not determine the inertia: its inverse is {:.3g} ± {} (95 %), which "
        "includes 0.",
        alpha,
        ShortNumber(half_width, 2));
  }
  return "";
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
  const Decomposition decomposition = Decompose(regression);
  summary.condition_number = decomposition.S[0] / decomposition.S[3];
  summary.not_determined = NotDetermined(decomposition, options.smallest_singular_value);
  if (!summary.not_determined.empty()) {
    summary.message = fmt::format(
        "The data do not determine {}: the columns of the regression are linearly dependent "
        "(condition number {:.2g}). Excite the vehicle with several frequencies or amplitudes.",
        fmt::join(summary.not_determined, ", "),
        summary.condition_number);
    return summary;
  }
  const Lumped lumped = SolveLumped(decomposition, regression, options.max_noise_order);
  summary.message = WhyNoModel(lumped);
  if (!summary.message.empty()) {
    const bool is_open = lumped.IsFinite() && lumped.alpha() > 0.0;
    summary.has_wrong_sign =
        lumped.IsFinite() && lumped.alpha() + kStdsOf95 * lumped.alpha_std() < 0.0;
    if (is_open) summary.not_determined = {kParameterInfo[kInertia].name};
    return summary;
  }
  summary.model = ModelFromVector(ParametersOf(lumped.value));  // (2)
  const Eigen::Matrix4d J = ParameterJacobian(lumped.value);
  summary.covariance = J * lumped.covariance * J.transpose();
  summary.usable = true;
  summary.message = fmt::format("Least squares over {} samples.", summary.num_samples);
  AddCaveats(&summary);
  return summary;
}

}  // namespace fathom
