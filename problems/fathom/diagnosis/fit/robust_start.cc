// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/robust_start.h"

#include "fathom/base/input_error.h"
#include "fathom/output_error/output_error.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace fathom {
namespace {

constexpr double kWindow = 2.0;  // [s]

// Momentum over windows: m (v1 - v0) + d_Q int v|v| + d_L int v + b h = int tau, solved for the
// ratios to m. Biased by noise in v, but near enough to start from.
UncoupledModel<double> MomentumGuess(std::span<const Segment> segments) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  Eigen::Vector4d g = Eigen::Vector4d::Zero();
  double force = 0.0, change = 0.0;
  for (const Segment& segment : segments) {
    size_t i = 0;
    while (i + 1 < segment.time.size()) {
      double push = 0.0, square = 0.0, way = 0.0;
      size_t j = i;
      while (j + 1 < segment.time.size() && segment.time[j] - segment.time[i] < kWindow) {
        const double h = segment.time[j + 1] - segment.time[j];
        const double v = 0.5 * (segment.velocity[j] + segment.velocity[j + 1]);
        push += h * segment.command.At(segment.time[j] + 0.5 * h);
        square += h * v * std::abs(v);
        way += h * v;
        ++j;
      }
      const Eigen::Vector4d row(push, -square, -way, -(segment.time[j] - segment.time[i]));
      const double dv = segment.velocity[j] - segment.velocity[i];
      A += row * row.transpose();
      g += row * dv;
      force += std::abs(push);
      change += std::abs(dv);
      i = j;
    }
  }
  const Eigen::Vector4d scale = A.diagonal().cwiseSqrt().cwiseMax(1e-12).cwiseInverse();
  Eigen::Matrix4d scaled = scale.asDiagonal() * A * scale.asDiagonal();
  scaled.diagonal().array() += 1e-6;
  const Eigen::Vector4d ratios = scale.asDiagonal() * scaled.ldlt().solve(scale.asDiagonal() * g);
  const double rough = force / std::max(change, 1e-9);
  if (!(ratios[0] > 0.1 / rough)) return {rough, 0.0, 0.1 * rough, 0.0};
  const double inertia = 1.0 / ratios[0];
  return {inertia,
          std::max(0.0, ratios[1] * inertia),
          std::max(1e-3 * inertia, ratios[2] * inertia),
          ratios[3] * inertia};
}

}  // namespace

std::optional<RobustStart> FindRobustStart(std::span<const MeasuredSegment> segments) {
  std::vector<Segment> plain_segments;
  bool has_velocity = false;
  for (const MeasuredSegment& segment : segments) {
    plain_segments.push_back(PlainSegment(segment));
    has_velocity = has_velocity || !segment.velocity.empty();
  }
  OutputErrorOptions options;
  options.initial_guess = MomentumGuess(plain_segments);
  if (!(options.initial_guess->inertia > 0.0)) return std::nullopt;  // no force ever acted
  options.output = has_velocity ? FittedOutput::kVelocity : FittedOutput::kPosition;
  OutputErrorSummary summary = FitOutputError(plain_segments, options);
  if (!summary.converged) {
    options.initial_guess.reset();
    summary = FitOutputError(plain_segments, options);
  }
  if (!summary.converged) return std::nullopt;
  RobustStart start = {{summary.model, {}}, {}, summary.covariance};
  for (size_t r = 0; r < segments.size(); ++r) {
    InitialState state = segments[r].initial;
    state.velocity = summary.initial_states[r].velocity;
    if (!has_velocity) state.position = summary.initial_states[r].position;
    start.initial.push_back(state);
  }
  return start;
}

}  // namespace fathom
