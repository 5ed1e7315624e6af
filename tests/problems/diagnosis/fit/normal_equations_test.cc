// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/normal_equations.h"

#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Three segments, whose free states have columns of their own.
TEST(NormalOf, IsThatOfTheWhitenedMatrixWrittenOut) {
  std::vector<NoiseSample> samples;
  RowMajorMatrix jacobian = RowMajorMatrix::Random(90, 5);
  for (int i = 0; i < 90; ++i) {
    NoiseSample sample;
    sample.time = 0.2 * i;
    sample.segment = i / 30;
    samples.push_back(sample);
    for (int k = 0; k < 3; ++k) {
      if (k != i / 30) jacobian(i, 2 + k) = 0.0;
    }
  }
  NoiseModel noise;
  noise.velocity = {.white_std = 0.02, .coloured = {.std = 0.03, .time = 1.5}};
  noise.disturbance = {.std = 0.01, .time = 4.0};
  noise.damping_rate = 0.1;
  const Whitener whitener(noise, samples);
  const Eigen::VectorXd residual = Eigen::VectorXd::Random(90);
  RowMajorMatrix W = RowMajorMatrix::Identity(90, 90);
  whitener.Apply(W, W);
  const Eigen::MatrixXd J = W * jacobian;
  const Eigen::MatrixXd A = J.transpose() * J;
  const Eigen::VectorXd g = J.transpose() * (W * residual);
  const Normal normal = NormalOf(whitener, jacobian, residual);
  EXPECT_LT((normal.A - A).norm(), 1e-10 * A.norm());
  EXPECT_LT((normal.g - g).norm(), 1e-10 * g.norm());
}

}  // namespace
}  // namespace fathom
