// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Statistics are claims: a 95 % interval covers 95 %.

#include "fathom/output_error/output_error.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "synthetic_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr int kNumRuns = 1000;
// Three binomial standard deviations of a rate of 0.95 over 1000 runs are 0.021.
constexpr double kLowestRate = 0.93, kHighestRate = 0.97;

void ExpectIntervalsToCover(double noise_correlation) {
  SyntheticRun run = {.command = Multisine};
  run.noise = 0.01;
  run.noise_correlation = noise_correlation;
  OutputErrorOptions options;
  options.initial_guess = run.truth;
  const ParameterVector truth = ToVector(run.truth);
  std::array<int, kNumParameters> num_covered = {};
  for (unsigned seed = 1; seed <= kNumRuns; ++seed) {
    const std::vector<Segment> segments = {Synthesize(run, seed)};
    const auto summary = FitOutputError(segments, options);
    ASSERT_TRUE(summary.IsUsable()) << "seed " << seed << ": " << summary.message;
    for (int i = 0; i < kNumParameters; ++i) {
      const double half_width = 1.96 * std::sqrt(summary.covariance(i, i));
      if (std::abs(ToVector(summary.model)[i] - truth[i]) <= half_width) ++num_covered[i];
    }
  }
  for (int i = 0; i < kNumParameters; ++i) {
    const double rate = static_cast<double>(num_covered[i]) / kNumRuns;
    std::printf("noise correlation %.1f: %-18s covered in %.1f %% of %d runs\n",
                noise_correlation,
                kParameterInfo[i].name,
                100.0 * rate,
                kNumRuns);
    EXPECT_GE(rate, kLowestRate) << kParameterInfo[i].name;
    EXPECT_LE(rate, kHighestRate) << kParameterInfo[i].name;
  }
}

TEST(OutputErrorCoverage, Is95PercentUnderWhiteNoise) { ExpectIntervalsToCover(0.0); }

TEST(OutputErrorCoverage, Is95PercentUnderNoiseThatRemembers) { ExpectIntervalsToCover(0.9); }

}  // namespace
}  // namespace fathom
