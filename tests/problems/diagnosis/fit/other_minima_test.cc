// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/other_minima.h"

#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/fit/residual_noise.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Two tones in turbulence, and late: a delay that is off by a period of the faster one looks right
// but for the slower.
TrainingData LateTones(std::uint64_t seed) {
  SurgeRun run;
  MultisineInput tones;
  tones.rms = 40.0;
  tones.lowest_frequency = 0.3;
  tones.highest_frequency = 5.0;
  tones.num_lines = 2;
  run.input = {0.0, tones};
  run.duration = 300.0;
  run.rate = 10.0;
  run.velocity_noise = 0.0005;
  run.turbulence = 6.0;
  run.effects = "time_offset:offset=4";
  const std::vector<Log> logs = {LogOf(run, seed)};
  return TrainingData(MeasuredSegmentsOf(logs, Dof::kSurge).all);
}

StructureFit FitFrom(const TrainingData& data, double offset) {
  ExtendedModel model;
  model.baseline = kSurgeTruth;
  model.effects = {{FindEffect("time_offset"), {}, {offset}}};
  std::vector<InitialState> initial;
  for (const MeasuredSegment& segment : data.segments()) initial.push_back(segment.initial);
  const Eigen::VectorXd left = data.measured() - *data.Simulate(model, initial);
  return FitStructureAndNoise(data, model, initial, WhiteNoise(data, left));
}

double OffsetOf(const StructureFit& fit) { return fit.model.effects.front().values.front(); }

TEST(LikeliestMinimum, IsOneWhereverTheSearchBegan) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const TrainingData data = LateTones(seed);
    std::vector<double> ended, found;
    double std = 0.0;
    for (const double start : {1.0, 3.0, 5.0, 7.0}) {
      const StructureFit fit = FitFrom(data, start);
      const StructureFit likeliest = LikeliestMinimum(data, fit);
      EXPECT_GE(likeliest.log_likelihood, fit.log_likelihood);
      ended.push_back(OffsetOf(fit));
      found.push_back(OffsetOf(likeliest));
      std = std::sqrt(likeliest.covariance(kNumParameters, kNumParameters));
    }
    const auto [first, last] = std::minmax_element(ended.begin(), ended.end());
    EXPECT_GT(*last - *first, 1.0) << "nothing to choose from, seed " << seed;
    const auto [low, high] = std::minmax_element(found.begin(), found.end());
    EXPECT_LT(*high - *low, 0.5 * std) << "seed " << seed;
  }
}

}  // namespace
}  // namespace fathom
