// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/output_error.h"
#include "fathom/vehicle/parameters.h"

#include <string>
#include <vector>

#include "disturbed_water.h"
#include "synthetic_run.h"
#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace fathom {

// What spoils a log.
struct NoiseKind {
  std::string name;
  FittedOutput output = FittedOutput::kVelocity;
  double white_std = 0.01;     // of the sensor [m/s] or [m]
  double coloured_std = 0.0;   // of its Ornstein-Uhlenbeck part [m/s] or [m]
  double coloured_time = 1.0;  // [s]
  WaterForce water;

  bool IsWhite() const { return coloured_std == 0.0 && water.kind == WaterForce::Kind::kStill; }
};

// Logs of a known vehicle under one kind of noise, and the estimator that knows the noise.
//
// That oracle is generalised least squares about the truth, with the covariance S of the noise of
// half-second means written out: the water's force has a covariance in closed form, and passes
// through the vehicle's dynamics, dv'/dt = -(d_L + 2 d_Q |v|) / m v' + f / m, by the trapezoidal
// rule along the true motion. None of Fathom's code is in it. It is the best linear estimator for
// every kind; for normal noise there is no better one.
class NoiseTrial {
 public:
  explicit NoiseTrial(NoiseKind kind, double duration = 300.0, double rate = 10.0);

  const NoiseKind& kind() const { return kind_; }
  const UncoupledModel<double>& truth() const { return run_.truth; }

  Segment Draw(unsigned seed) const;

  // Its estimate of the parameters from a drawn log, and the standard deviations of that.
  ParameterVector Oracle(const Segment& segment) const;
  ParameterVector OracleStd() const;

 private:
  Eigen::MatrixXd CovarianceOfNoise() const;
  Eigen::VectorXd MeansOf(const std::vector<double>& values) const;
  const std::vector<double>& OutputOf(const Segment& segment) const;

  NoiseKind kind_;
  SyntheticRun run_;  // without noise
  Segment clean_;     // of the same
  int samples_per_mean_ = 5;
  Eigen::MatrixXd J_;  // of the means: the parameters, the initial velocity and position
  Eigen::MatrixXd S_inverse_J_;
  Eigen::LDLT<Eigen::MatrixXd> information_;
};

// Every kind of the table in docs/output_error.md.
std::vector<NoiseKind> AllNoiseKinds();

}  // namespace fathom
