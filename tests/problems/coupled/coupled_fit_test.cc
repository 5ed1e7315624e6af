// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_fit.h"

#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "drawn_vehicle.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(FitCoupled, FindsTheVehicleOfALogWithoutNoise) {
  std::mt19937 random(1);
  CoupledModel truth = DrawnPlanarVehicle(&random);
  truth.inertia(1, 5) = truth.inertia(5, 1) = 3.0;
  truth.linear_damping(1, 5) = 2.0;
  truth.linear_damping(5, 1) = -1.0;
  DrawnLogOptions options;
  options.noise = 1e-6;
  const std::vector<CoupledData> logs = {DrawnLog(truth, options, &random)};
  const MotionStructure structure = StructureOf(StandardStructure::kFull, truth.dofs);
  const CoupledSummary summary = FitCoupled(logs, structure);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  for (const FreeEntry& entry : structure.entries) {
    EXPECT_NEAR(ValueIn(summary.model, entry),
                ValueIn(truth, entry),
                1e-3 * std::max(1.0, std::abs(ValueIn(truth, entry))))
        << NameOf(entry);
  }
}

TEST(FitCoupled, IntervalsCoverTheTruth) {
  int num = 0, covered = 0;
  for (int seed = 0; seed < 40; ++seed) {
    std::mt19937 random(100 + seed);
    CoupledModel truth = DrawnPlanarVehicle(&random);
    const std::vector<CoupledData> logs = {DrawnLog(truth, {}, &random)};
    const MotionStructure structure = StructureOf(StandardStructure::kSymmetric, truth.dofs);
    const CoupledSummary summary = FitCoupled(logs, structure);
    ASSERT_TRUE(summary.IsUsable()) << summary.message;
    for (std::size_t k = 0; k < structure.entries.size(); ++k) {
      const double std = std::sqrt(summary.covariance(k, k));
      const double miss =
          ValueIn(summary.model, structure.entries[k]) - ValueIn(truth, structure.entries[k]);
      ++num;
      covered += std::abs(miss) < 1.96 * std;
      if (seed < 2)
        std::printf("%s %g %g %g\n",
                    NameOf(structure.entries[k]).c_str(),
                    ValueIn(truth, structure.entries[k]),
                    miss,
                    std);
    }
  }
  std::printf("covered %d of %d: %.3f\n", covered, num, double(covered) / num);
}

}  // namespace
}  // namespace fathom
