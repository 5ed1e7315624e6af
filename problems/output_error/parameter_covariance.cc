// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/parameter_covariance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace fathom {
namespace {

constexpr int kColumns = kNumParameters + 1;  // the parameters and a time offset
constexpr int kSensitivities = Simulation::kNumSensitivities;
constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

using Matrix = Eigen::MatrixXd;

// A segment's signatures (columns: parameters, time offset, initial state) and residuals.
struct Signatures {
  Matrix J;                           // by the whitened output
  std::vector<double> influence;      // psi(r): r where it is small, k beyond
  std::vector<Eigen::Index> clipped;  // rows where psi'(r) is 0, not 1
  double sum_of_squares = 0.0;        // of the raw residuals
};

bool Simulate(const UncoupledModel<double>& model,
              const Segment& segment,
              const InitialState& initial,
              FittedOutput output,
              double sigma,
              double huber_k,
              Signatures* signatures) {
  const auto n = static_cast<Eigen::Index>(segment.time.size());
  const Simulation simulation(segment.command, segment.time);
  const bool is_velocity = output == FittedOutput::kVelocity;
  std::vector<double> v(n), x(is_velocity ? 0 : n), derivatives(n * kSensitivities);
  const std::span<double> none;
  if (!simulation.RunWithSensitivities(model,
                                       initial,
                                       v,
                                       x,
                                       is_velocity ? derivatives : none,
                                       is_velocity ? none : derivatives)) {
    return false;
  }
  Matrix& J = signatures->J;
  J.resize(n, kColumns + StateSize(output));
  signatures->influence.reserve(n);
  const HeldCommand& command = segment.command;
  size_t num_given = 0;  // command samples given so far
  for (Eigen::Index i = 0; i < n; ++i) {
    while (num_given < command.time.size() && command.time[num_given] <= segment.time[i]) {
      ++num_given;
    }
    const double force = num_given > 0 ? command.value[num_given - 1] : 0.0;
    const double* row = &derivatives[i * kSensitivities];
    for (int j = 0; j < kNumParameters; ++j) J(i, j) = row[j];
    // A command that comes later shifts the response: d y / d offset = -dy/dt.
    const double acceleration = model.Acceleration(v[i], force);
    J(i, kNumParameters) = is_velocity ? -acceleration : -v[i];
    J(i, kColumns) = row[kNumParameters];
    if (!is_velocity) J(i, kColumns + 1) = 1.0;

    const double miss = is_velocity ? v[i] - segment.velocity[i] : x[i] - segment.position[i];
    const double r = miss / sigma;
    signatures->influence.push_back(std::clamp(r, -huber_k, huber_k));
    if (std::abs(r) > huber_k) signatures->clipped.push_back(i);
    signatures->sum_of_squares += miss * miss;
  }
  J /= sigma;
  return true;
}

// Row ranges without a missing sample inside: the autoregression counts samples, not seconds.
std::vector<std::pair<size_t, size_t>> UnbrokenPieces(const std::vector<double>& time) {
  std::vector<double> steps(time.size() - 1);
  for (size_t i = 0; i + 1 < time.size(); ++i) steps[i] = time[i + 1] - time[i];
  auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double longest = 1.8 * *middle;
  std::vector<std::pair<size_t, size_t>> pieces;
  size_t begin = 0;
  for (size_t i = 1; i <= time.size(); ++i) {
    if (i == time.size() || time[i] - time[i - 1] > longest) {
      pieces.emplace_back(begin, i);
      begin = i;
    }
  }
  return pieces;
}

// Normal matrix A and score variance B of the parameters and the offset, after the segments'
// initial states are eliminated; docs/output_error.md (7).
struct Reduced {
  Matrix A = Matrix::Zero(kColumns, kColumns);
  Matrix B = Matrix::Zero(kColumns, kColumns);
  Eigen::VectorXd norm_squared = Eigen::VectorXd::Zero(kColumns);  // of the full signatures
};

void Accumulate(const Signatures& signatures,
                const std::vector<std::pair<size_t, size_t>>& pieces,
                const Autoregression& noise,
                Reduced* reduced) {
  const Matrix& J = signatures.J;
  const Eigen::Index num_states = J.cols() - kColumns;
  Matrix A = J.transpose() * J;
  for (const Eigen::Index row : signatures.clipped) A -= J.row(row).transpose() * J.row(row);
  Matrix B = Matrix::Zero(J.cols(), J.cols());
  for (const auto& [begin, end] : pieces) {
    B += ColouredGram(
        noise,
        J.middleRows(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin)));
  }
  const Matrix A_ps = A.topRightCorner(kColumns, num_states);
  const Matrix A_ss = A.bottomRightCorner(num_states, num_states);
  Matrix eliminate(kColumns, J.cols());
  eliminate << Matrix::Identity(kColumns, kColumns), -A_ps * A_ss.inverse();
  reduced->A += A.topLeftCorner(kColumns, kColumns) - A_ps * A_ss.inverse() * A_ps.transpose();
  reduced->B += eliminate * B * eliminate.transpose();
  reduced->norm_squared += A.diagonal().head(kColumns);
}

// A^-1 B A^-1 of the leading `size` columns, and each one's surviving share; computed on columns of
// unit length, since the parameters' units differ by orders of magnitude.
struct Solved {
  Matrix covariance;
  Eigen::VectorXd share;
  double condition_number = kNotComputed;
};

Solved Solve(const Reduced& reduced, int size) {
  const Eigen::VectorXd scale = reduced.norm_squared.head(size).cwiseSqrt();
  const Eigen::VectorXd unscale = scale.cwiseInverse();
  const Matrix A =
      unscale.asDiagonal() * reduced.A.topLeftCorner(size, size) * unscale.asDiagonal();
  const Matrix B =
      unscale.asDiagonal() * reduced.B.topLeftCorner(size, size) * unscale.asDiagonal();
  Solved solved;
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(A);
  const double smallest = eigen.eigenvalues().minCoeff();
  solved.covariance = Matrix::Constant(size, size, kNotComputed);
  solved.share = Eigen::VectorXd::Constant(size, 0.0);
  if (!(smallest > 1e-13 * eigen.eigenvalues().maxCoeff())) return solved;
  solved.condition_number = std::sqrt(eigen.eigenvalues().maxCoeff() / smallest);
  const Matrix A_inverse = A.inverse();
  solved.covariance = unscale.asDiagonal() * (A_inverse * B * A_inverse) * unscale.asDiagonal();
  solved.share = A_inverse.diagonal().cwiseInverse().cwiseSqrt();
  return solved;
}

// The fit bends the residuals towards zero by as many degrees of freedom as it has unknowns, and
// coloured residuals have fewer to give: the effective number of samples is n times the variance of
// a white residual's mean over that of this one.
double FreedomFactor(const Autoregression& noise,
                     double sum_of_squares,
                     double num_samples,
                     double num_unknowns) {
  double sum = 1.0;
  for (const double phi : noise.coefficients) sum -= phi;
  const double variance = sum_of_squares / num_samples;
  const double shrink = std::min(1.0, variance * sum * sum / noise.innovation_variance);
  const double num_effective = std::max(num_samples * shrink, 2.0 * num_unknowns);
  return num_effective / (num_effective - num_unknowns);
}

}  // namespace

ParameterEvidence EvidenceAt(const UncoupledModel<double>& model,
                             std::span<const Segment> segments,
                             std::span<const InitialState> initial_states,
                             FittedOutput output,
                             double sigma,
                             double huber_k) {
  ParameterEvidence evidence;
  evidence.covariance.setConstant(kNotComputed);
  evidence.covariance_with_time_offset.setConstant(kNotComputed);
  evidence.share.setConstant(kNotComputed);
  evidence.share_with_time_offset.setConstant(kNotComputed);
  evidence.change_per_second_of_offset.setConstant(kNotComputed);
  evidence.condition_number = evidence.residual_sd = evidence.noise_correlation = kNotComputed;

  std::vector<Signatures> signatures(segments.size());
  std::vector<std::vector<std::pair<size_t, size_t>>> pieces;
  std::vector<std::vector<double>> residuals;
  double num_samples = 0.0, sum_of_squares = 0.0, product = 0.0, power = 0.0;
  for (size_t s = 0; s < segments.size(); ++s) {
    if (!Simulate(model, segments[s], initial_states[s], output, sigma, huber_k, &signatures[s])) {
      return evidence;
    }
    pieces.push_back(UnbrokenPieces(segments[s].time));
    const auto& influence = signatures[s].influence;
    for (const auto& [begin, end] : pieces.back()) {
      residuals.emplace_back(influence.begin() + static_cast<std::ptrdiff_t>(begin),
                             influence.begin() + static_cast<std::ptrdiff_t>(end));
      for (size_t i = begin + 1; i < end; ++i) product += influence[i] * influence[i - 1];
    }
    for (const double psi : influence) power += psi * psi;
    num_samples += static_cast<double>(influence.size());
    sum_of_squares += signatures[s].sum_of_squares;
  }
  const int max_order =
      static_cast<int>(std::min({60.0, 10.0 * std::log10(num_samples), num_samples / 10.0}));
  evidence.noise = FitAutoregression(residuals, max_order);
  evidence.noise_correlation = product / power;

  Reduced reduced;
  for (size_t s = 0; s < segments.size(); ++s) {
    Accumulate(signatures[s], pieces[s], evidence.noise, &reduced);
  }
  const double num_unknowns =
      kNumParameters + static_cast<double>(segments.size()) * StateSize(output);
  const double freedom = FreedomFactor(evidence.noise, power, num_samples, num_unknowns);
  evidence.residual_sd = std::sqrt(freedom * sum_of_squares / num_samples);

  const Solved alone = Solve(reduced, kNumParameters);
  evidence.covariance = freedom * alone.covariance;
  evidence.share = alone.share;
  evidence.condition_number = alone.condition_number;
  const Solved with_offset = Solve(reduced, kColumns);
  evidence.covariance_with_time_offset =
      freedom * with_offset.covariance.topLeftCorner(kNumParameters, kNumParameters);
  evidence.share_with_time_offset = with_offset.share.head(kNumParameters);
  // The residuals that an offset leaves, fitted by the parameters alone.
  const Matrix A_pp = reduced.A.topLeftCorner(kNumParameters, kNumParameters);
  evidence.change_per_second_of_offset =
      -A_pp.ldlt().solve(reduced.A.topRightCorner(kNumParameters, 1));
  return evidence;
}

}  // namespace fathom
