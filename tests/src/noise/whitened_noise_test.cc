// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/fit_noise.h"
#include "fathom/noise/whitener.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include "dense_covariance.h"
#include "null_noises.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Of the whitened noise: unit variance, and Ljung-Box's sum of squared autocorrelations beyond the
// 95 % point of chi-square in 5 % of logs.
TEST(WhitenedNoise, IsWhite) {
  const auto samples = VelocitySamples(200.0, 0.2, [](int i) { return i % 70 > 60; });
  const auto n = static_cast<Eigen::Index>(samples.size());
  double num_logs = 0.0, sum_of_squares = 0.0, rejected = 0.0, rejected_of_fit = 0.0;
  const auto is_rejected = [n](const Eigen::VectorXd& e) {
    double sum = 0.0;
    for (Eigen::Index lag = 1; lag <= 20; ++lag) {
      const double r = e.head(n - lag).dot(e.tail(n - lag)) / e.squaredNorm();
      sum += r * r / static_cast<double>(n - lag);
    }
    const auto length = static_cast<double>(n);
    return length * (length + 2.0) * sum > 31.410;  // chi-square with 20 degrees of freedom
  };
  const std::vector<NullNoise> noises = NullNoises();
  for (const unsigned kind : {0u, 1u, 6u, 12u, 17u}) {
    DenseDraws draws(noises[kind].model, samples, 70u + kind);
    for (int draw = 0; draw < 60; ++draw) {
      const Eigen::VectorXd e = draws.Draw();
      Eigen::VectorXd white(n);
      Whitener(noises[kind].model, samples).Apply(Span(e), {white.data(), samples.size()});
      num_logs += 1.0;
      sum_of_squares += white.squaredNorm() / static_cast<double>(n);
      rejected += is_rejected(white);
      const NoiseFit fit = FitNoise(samples, Span(e), RowMajorMatrix(n, 0), {});
      Whitener(fit.model, samples).Apply(Span(e), {white.data(), samples.size()});
      rejected_of_fit += is_rejected(white);
    }
  }
  std::printf("Ljung-Box rejects %.1f %% with the true model, %.1f %% with the fitted one\n",
              100.0 * rejected / num_logs,
              100.0 * rejected_of_fit / num_logs);
  EXPECT_NEAR(
      sum_of_squares / num_logs, 1.0, 4.0 * std::sqrt(2.0 / (num_logs * static_cast<double>(n))));
  // 300 logs: a standard deviation of 1.3 %; three of these. A fit takes some of it away.
  EXPECT_NEAR(rejected / num_logs, 0.05, 0.038);
  EXPECT_LT(rejected_of_fit / num_logs, 0.05 + 0.038);
}

}  // namespace
}  // namespace fathom
