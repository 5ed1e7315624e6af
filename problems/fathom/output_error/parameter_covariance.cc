// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/parameter_covariance.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

namespace fathom {
namespace {

constexpr int kColumns = kNumParameters + 1;  // the parameters and a time offset
constexpr int kSensitivities = Simulation::kNumSensitivities;
constexpr size_t kStretch = 4096;  // samples simulated at once: they fit into the cache
constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

using Matrix = Eigen::MatrixXd;
using Derivatives = Eigen::Matrix<double, Eigen::Dynamic, kSensitivities, Eigen::RowMajor>;
using Pieces = std::vector<std::pair<size_t, size_t>>;

// Row ranges without a missing sample inside: the autoregression counts samples, not seconds.
Pieces UnbrokenPieces(const std::vector<double>& time) {
  const double longest = 1.8 * MedianStep(time);
  Pieces pieces;
  size_t begin = 0;
  for (size_t i = 1; i <= time.size(); ++i) {
    if (i == time.size() || time[i] - time[i - 1] > longest) {
      pieces.emplace_back(begin, i);
      begin = i;
    }
  }
  return pieces;
}

// Derivatives by the parameters and the velocity at the start of a stretch, turned into those by
// the parameters and the velocity at the start of the segment; `start` is how the former velocity
// follows the latter ones.
Derivatives Chained(const Derivatives& by_stretch, const Derivatives& start) {
  Derivatives by_segment = by_stretch.col(kNumParameters) * start;
  by_segment.leftCols(kNumParameters) += by_stretch.leftCols(kNumParameters);
  return by_segment;
}

// Simulates a segment, a stretch of it at a time so that memory does not grow with the log, and
// calls visit(J, residual, is_end) for consecutive samples of an unbroken piece, both by the
// whitened output. J holds the signatures: of the parameters, the time offset, the initial state.
// `is_end` tells that the piece ends. False if the simulation diverges.
template <typename Visit>
bool VisitSamples(const UncoupledModel<double>& model,
                  const Segment& segment,
                  const Pieces& pieces,
                  InitialState state,
                  FittedOutput output,
                  double sigma,
                  Visit visit) {
  const bool is_velocity = output == FittedOutput::kVelocity;
  const HeldCommand& command = segment.command;
  size_t num_given = 0;  // command samples given so far
  auto piece = pieces.begin();
  // Derivatives of the state at the start of the stretch.
  Derivatives v_start = Derivatives::Zero(1, kSensitivities), x_start = v_start;
  v_start(kNumParameters) = 1.0;
  Derivatives dv, dx;
  std::vector<double> v, x;
  Matrix J;
  Eigen::ArrayXd residual;
  for (size_t begin = 0; begin < segment.time.size(); begin += kStretch) {
    // The next stretch's first sample is simulated as well: that is where it starts.
    const size_t end = std::min(begin + kStretch, segment.time.size());
    const size_t num_outputs = std::min(end + 1, segment.time.size()) - begin;
    const size_t num_positions = is_velocity ? 0 : num_outputs;
    const auto time = std::span(segment.time).subspan(begin, num_outputs);
    v.resize(num_outputs);
    x.resize(num_positions);
    dv.resize(static_cast<Eigen::Index>(num_outputs), kSensitivities);
    dx.resize(static_cast<Eigen::Index>(num_positions), kSensitivities);
    if (!Simulation(command, time)
             .RunWithSensitivities(model,
                                   state,
                                   v,
                                   x,
                                   {dv.data(), num_outputs * kSensitivities},
                                   {dx.data(), num_positions * kSensitivities})) {
      return false;
    }
    dx = Chained(dx, v_start).rowwise() + x_start.row(0);
    dv = Chained(dv, v_start);
    state = {v.back(), is_velocity ? 0.0 : x.back()};
    v_start = dv.bottomRows(1);
    if (!is_velocity) x_start = dx.bottomRows(1);

    const auto n = static_cast<Eigen::Index>(end - begin);
    const Derivatives& dy = is_velocity ? dv : dx;
    J.setOnes(n, kColumns + StateSize(output));  // the last column: of the initial position
    J.leftCols(kNumParameters) = dy.topLeftCorner(n, kNumParameters);
    J.col(kColumns) = dy.col(kNumParameters).head(n);
    residual.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      while (num_given < command.time.size() && command.time[num_given] <= time[i]) ++num_given;
      const double force = num_given > 0 ? command.value[num_given - 1] : 0.0;
      // A command that comes later shifts the response: d y / d offset = -dy/dt.
      J(i, kNumParameters) = is_velocity ? -model.Acceleration(v[i], force) : -v[i];
      residual[i] =
          is_velocity ? v[i] - segment.velocity[begin + i] : x[i] - segment.position[begin + i];
    }
    J /= sigma;
    residual /= sigma;
    for (size_t first = begin; first < end;) {
      const size_t last = std::min(end, piece->second);
      const auto from = static_cast<Eigen::Index>(first - begin);
      const auto count = static_cast<Eigen::Index>(last - first);
      visit(J.middleRows(from, count), residual.segment(from, count), last == piece->second);
      if (last == piece->second) ++piece;
      first = last;
    }
  }
  return true;
}

// Normal matrix A and score variance B of the parameters and the offset, after the segments'
// initial states are eliminated; docs/output_error.md (7).
struct Reduced {
  Matrix A = Matrix::Zero(kColumns, kColumns);
  Matrix B = Matrix::Zero(kColumns, kColumns);
  Eigen::VectorXd norm_squared = Eigen::VectorXd::Zero(kColumns);  // of the full signatures
};

// Adds a segment, given the two matrices before elimination.
void Eliminate(const Matrix& A, const Matrix& B, Reduced* reduced) {
  const Eigen::Index num_states = A.cols() - kColumns;
  const Matrix A_ps = A.topRightCorner(kColumns, num_states);
  // Where (nearly) all samples are clipped, an initial state leaves no trace in A, and nothing of
  // the parameters' can be laid at its door: the pseudoinverse.
  Eigen::CompleteOrthogonalDecomposition<Matrix> A_ss;
  A_ss.setThreshold(1e-13);
  A_ss.compute(A.bottomRightCorner(num_states, num_states));
  Matrix eliminate(kColumns, A.cols());
  eliminate << Matrix::Identity(kColumns, kColumns), -A_ps * A_ss.pseudoInverse();
  reduced->A += eliminate * A.leftCols(kColumns);
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

  // First the residuals and their colour, then what the colour does to the parameters: simulating
  // twice is cheaper than keeping the signatures of a long log.
  std::vector<Pieces> pieces;
  std::vector<std::vector<double>> influence;  // psi(r), by piece: r where it is small, k beyond
  double num_samples = 0.0, sum_of_squares = 0.0, product = 0.0, power = 0.0;
  for (size_t s = 0; s < segments.size(); ++s) {
    pieces.push_back(UnbrokenPieces(segments[s].time));
    size_t piece = influence.size();
    for (const auto& [begin, end] : pieces[s]) influence.emplace_back().reserve(end - begin);
    const auto visit = [&](const auto& /*J*/, const auto& residual, bool is_end) {
      for (const double r : residual) influence[piece].push_back(std::clamp(r, -huber_k, huber_k));
      sum_of_squares += sigma * sigma * residual.square().sum();
      if (is_end) ++piece;
    };
    if (!VisitSamples(model, segments[s], pieces[s], initial_states[s], output, sigma, visit)) {
      return evidence;
    }
  }
  for (const auto& psi : influence) {
    num_samples += static_cast<double>(psi.size());
    for (size_t i = 0; i < psi.size(); ++i) {
      power += psi[i] * psi[i];
      if (i > 0) product += psi[i] * psi[i - 1];
    }
  }
  const int max_order =
      static_cast<int>(std::min({60.0, 10.0 * std::log10(num_samples), num_samples / 10.0}));
  evidence.noise = FitAutoregression(std::move(influence), max_order);
  evidence.noise_correlation = product / power;

  Reduced reduced;
  const int num_columns = kColumns + StateSize(output);
  ColouredGram coloured(evidence.noise, num_columns);
  for (size_t s = 0; s < segments.size(); ++s) {
    Matrix A = Matrix::Zero(num_columns, num_columns), B = A;
    const auto visit = [&](const auto& J, const auto& residual, bool is_end) {
      const Eigen::VectorXd is_small = (residual.abs() <= huber_k).template cast<double>();
      A += J.transpose() * is_small.asDiagonal() * J;
      coloured.Add(J);
      if (is_end) B += coloured.EndPiece();
    };
    VisitSamples(model, segments[s], pieces[s], initial_states[s], output, sigma, visit);
    Eliminate(A, B, &reduced);
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
  if (std::isfinite(alone.condition_number) && !std::isfinite(with_offset.condition_number)) {
    evidence.covariance_with_time_offset.setConstant(std::numeric_limits<double>::infinity());
  }
  evidence.share_with_time_offset = with_offset.share.head(kNumParameters);
  // The residuals that an offset leaves, fitted by the parameters alone.
  const Matrix A_pp = reduced.A.topLeftCorner(kNumParameters, kNumParameters);
  evidence.change_per_second_of_offset =
      -A_pp.ldlt().solve(reduced.A.topRightCorner(kNumParameters, 1));
  return evidence;
}

}  // namespace fathom
