// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "noise_trial.h"

#include <cmath>
#include <utility>

#include <Eigen/Dense>

namespace fathom {

NoiseTrial::NoiseTrial(NoiseKind kind, double duration, double rate) : kind_(std::move(kind)) {
  run_.command = Multisine;
  run_.duration = duration;
  run_.rate = rate;
  samples_per_mean_ = static_cast<int>(std::lround(0.5 * rate));
  clean_ = Synthesize(run_, 0);
  const Eigen::VectorXd y = MeansOf(OutputOf(clean_));
  const bool is_velocity = kind_.output == FittedOutput::kVelocity;
  J_.setOnes(y.size(), kNumParameters + (is_velocity ? 1 : 2));  // the last: initial position
  for (int j = 0; j <= kNumParameters; ++j) {
    // Differences both ways.
    const double size = j < kNumParameters ? std::abs(ToVector(run_.truth)[j]) : 1.0;
    const double step = 1e-4 * size;
    const auto shifted = [&](double by) {
      SyntheticRun run = run_;
      ParameterVector parameters = ToVector(run.truth);
      (j < kNumParameters ? parameters[j] : run.initial_velocity) += by;
      run.truth = ModelFromVector(parameters);
      return MeansOf(OutputOf(Synthesize(run, 0)));
    };
    J_.col(j) = (shifted(step) - shifted(-step)) / (2.0 * step);
  }
  S_inverse_J_ = CovarianceOfNoise().llt().solve(J_);
  information_.compute(J_.transpose() * S_inverse_J_);
}

const std::vector<double>& NoiseTrial::OutputOf(const Segment& segment) const {
  return kind_.output == FittedOutput::kVelocity ? segment.velocity : segment.position;
}

Eigen::VectorXd NoiseTrial::MeansOf(const std::vector<double>& values) const {
  Eigen::VectorXd means(static_cast<Eigen::Index>(values.size()) / samples_per_mean_);
  for (Eigen::Index i = 0; i < means.size(); ++i) {
    means[i] =
        Eigen::Map<const Eigen::VectorXd>(&values[i * samples_per_mean_], samples_per_mean_).mean();
  }
  return means;
}

Eigen::MatrixXd NoiseTrial::CovarianceOfNoise() const {
  const Eigen::Index n = static_cast<Eigen::Index>(clean_.time.size()) / samples_per_mean_;
  const double sample = 1.0 / run_.rate;
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(n, n);
  S.diagonal().setConstant(kind_.white_std * kind_.white_std / samples_per_mean_);
  if (kind_.coloured_std > 0.0) {
    const auto C = [&](double lag) {
      return kind_.coloured_std * kind_.coloured_std *
             std::exp(-std::abs(lag) / kind_.coloured_time);
    };
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        double sum = 0.0;
        for (int k = -samples_per_mean_ + 1; k < samples_per_mean_; ++k) {
          const double lag = static_cast<double>(i - j) * samples_per_mean_ + k;
          sum += (samples_per_mean_ - std::abs(k)) * C(lag * sample);
        }
        S(i, j) += sum / (samples_per_mean_ * samples_per_mean_);
      }
    }
  }
  if (kind_.water.kind == WaterForce::Kind::kStill) return S;
  // The force at every other stamp; what each does to the output at all of them.
  constexpr int kStride = 2;
  const auto num_stamps = static_cast<Eigen::Index>(clean_.time.size());
  const Eigen::Index num_forces = num_stamps / kStride;
  Eigen::MatrixXd G(n, num_forces);
  const auto& m = run_.truth;
  for (Eigen::Index j = 0; j < num_forces; ++j) {
    std::vector<double> response(num_stamps, 0.0);
    double v = 0.0, x = 0.0;
    for (Eigen::Index i = j * kStride; i + 1 < num_stamps; ++i) {
      const double speed = 0.5 * (clean_.velocity[i] + clean_.velocity[i + 1]);
      const double a = (m.linear_damping + 2.0 * m.quadratic_damping * std::abs(speed)) / m.inertia;
      const double push = i < (j + 1) * kStride ? 1.0 / m.inertia : 0.0;
      const double next = (v * (1.0 - 0.5 * sample * a) + sample * push) / (1.0 + 0.5 * sample * a);
      x += 0.5 * sample * (v + next);
      v = next;
      response[i + 1] = kind_.output == FittedOutput::kVelocity ? v : x;
    }
    G.col(j) = MeansOf(response);
  }
  Eigen::MatrixXd R(num_forces, num_forces);
  for (Eigen::Index i = 0; i < num_forces; ++i) {
    for (Eigen::Index j = 0; j < num_forces; ++j) {
      R(i, j) = kind_.water.Covariance(static_cast<double>(i - j) * kStride * sample);
    }
  }
  return S + G * R * G.transpose();
}

Segment NoiseTrial::Draw(unsigned seed) const {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  SyntheticRun run = run_;
  run.disturbance = kind_.water.Draw(run.duration, generator);
  Segment segment = Synthesize(run, 0);
  const double kept = std::exp(-1.0 / (run.rate * kind_.coloured_time));
  double coloured = kind_.coloured_std * normal(generator);
  auto& output = kind_.output == FittedOutput::kVelocity ? segment.velocity : segment.position;
  for (double& y : output) {
    y += kind_.white_std * normal(generator) + coloured;
    coloured =
        kept * coloured + kind_.coloured_std * std::sqrt(1.0 - kept * kept) * normal(generator);
  }
  return segment;
}

ParameterVector NoiseTrial::Oracle(const Segment& segment) const {
  const Eigen::VectorXd e = MeansOf(OutputOf(segment)) - MeansOf(OutputOf(clean_));
  return ToVector(run_.truth) +
         information_.solve(S_inverse_J_.transpose() * e).head(kNumParameters);
}

ParameterVector NoiseTrial::OracleStd() const {
  const Eigen::Index n = J_.cols();
  return information_.solve(Eigen::MatrixXd::Identity(n, n))
      .diagonal()
      .head(kNumParameters)
      .cwiseSqrt();
}

std::vector<NoiseKind> AllNoiseKinds() {
  using Kind = WaterForce::Kind;
  constexpr FittedOutput kV = FittedOutput::kVelocity, kX = FittedOutput::kPosition;
  return {{"white", kV, 0.01, 0.0, 1.0, {}},
          {"coloured", kV, 0.0, 0.01, 0.95, {}},
          {"white and coloured", kV, 0.01, 0.01, 3.0, {}},
          {"mild turbulence", kV, 0.01, 0.0, 1.0, {Kind::kTurbulence, 6.0, 3.0}},
          {"slow turbulence", kV, 0.01, 0.0, 1.0, {Kind::kTurbulence, 6.0, 10.0}},
          {"strong turbulence", kV, 0.01, 0.0, 1.0, {Kind::kTurbulence, 20.0, 2.0}},
          {"turbulence, coloured sensor", kV, 0.005, 0.01, 1.0, {Kind::kTurbulence, 6.0, 3.0}},
          {"wander", kV, 0.01, 0.0, 1.0, {Kind::kWander, 6.0, 1.0}},
          {"steps of force", kV, 0.01, 0.0, 1.0, {Kind::kSteps, 6.0, 20.0}},
          {"gusts", kV, 0.01, 0.0, 1.0, {Kind::kGusts, 6.0, 4.0}},
          {"white, positions", kX, 0.01, 0.0, 1.0, {}},
          {"mild turbulence, positions", kX, 0.01, 0.0, 1.0, {Kind::kTurbulence, 6.0, 3.0}},
          {"wander, positions", kX, 0.01, 0.0, 1.0, {Kind::kWander, 6.0, 1.0}},
          {"steps of force, positions", kX, 0.01, 0.0, 1.0, {Kind::kSteps, 6.0, 20.0}}};
}

}  // namespace fathom
