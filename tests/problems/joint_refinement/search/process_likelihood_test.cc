// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/process_likelihood.h"

#include <cmath>
#include <vector>

#include "random_segment.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(ProcessLikelihood, HasTheSlopeOfItsValue) {
  const std::vector<LinearSegment> segments = {RandomSegment(40)};
  const std::vector<GlobalsPrior> priors(1);
  const ProcessParameters parameters(SomeProcesses());
  const ProcessLikelihood likelihood(segments, priors, parameters, 1);
  Eigen::VectorXd x = parameters.ToVector();
  x.array() += 0.1;
  const auto here = likelihood.At(x, true);
  ASSERT_TRUE(here.is_usable);
  for (int i = 0; i < parameters.size(); ++i) {
    constexpr double kMove = 1e-4;
    Eigen::VectorXd up = x, down = x;
    up[i] += kMove;
    down[i] -= kMove;
    const double slope =
        (likelihood.At(up, false).value - likelihood.At(down, false).value) / (2.0 * kMove);
    EXPECT_NEAR(here.slope[i], slope, 1e-3 * (1.0 + std::abs(slope))) << i;
  }
}

}  // namespace
}  // namespace fathom
