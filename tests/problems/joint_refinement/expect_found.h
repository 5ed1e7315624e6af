// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/joint_refinement.h"

#include <vector>

#include "camera_experiment.h"
#include <gtest/gtest.h>

namespace fathom {

inline double PathError(const std::vector<Pose>& path, const SyntheticCameraRun& run) {
  double sum = 0.0;
  for (size_t k = 0; k < path.size(); ++k) {
    sum += (path[k].translation - run.true_world_from_body[k].translation).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(path.size()));
}

// The truth lies within four reported standard deviations (of 16 normal numbers in these tests, one
// in a thousand seeds would not), and those are small.
inline void ExpectFound(const JointSummary& summary,
                        const SyntheticCameraRun& run,
                        double largest_std) {
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  const ParameterVector found = ToVector(summary.model), truth = ToVector(run.truth);
  for (int i = 0; i < kNumParameters; ++i) {
    const double std = std::sqrt(summary.covariance(i, i));
    EXPECT_NEAR(found[i], truth[i], 4.0 * std) << kParameterInfo[i].name;
  }
  EXPECT_LT(std::sqrt(summary.covariance(kInertia, kInertia)), largest_std * run.truth.inertia);
  EXPECT_NEAR(summary.model.inertia, run.truth.inertia, 4.0 * largest_std * run.truth.inertia);
  EXPECT_LT(PathError(summary.segments[0].world_from_body, run),
            0.6 * PathError(run.input.segments[0].world_from_body, run));
}

}  // namespace fathom
