// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/drawn_figures.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Of four logs two have a moment of their own.
TEST(DrawModels, GivesAnotherRunAnOffsetOfTheScatterThatRunsHave) {
  FittedCoupledModel fitted;
  fitted.model.dofs = {Dof::kSway, Dof::kYaw};
  fitted.model.run_offset["a"] << 0.0, 0.0, 0.0, 0.0, 0.0, 3.0;
  fitted.model.run_offset["b"] << 0.0, 0.0, 0.0, 0.0, 0.0, -4.0;
  fitted.log_fingerprints = {"1", "2", "3", "4"};
  fitted.covariance.resize(0, 0);
  constexpr int kCount = 4000;
  double sum = 0.0, squares = 0.0;
  for (const CoupledModel& model : DrawModels(fitted, kCount, 1)) {
    EXPECT_EQ(model.offset[Index(Dof::kSway)], 0.0);
    sum += model.offset[Index(Dof::kYaw)];
    squares += model.offset[Index(Dof::kYaw)] * model.offset[Index(Dof::kYaw)];
  }
  const double scatter = std::sqrt((9.0 + 16.0) / 3.0);
  // Four standard deviations of a mean and of a root mean square.
  EXPECT_NEAR(sum / kCount, 0.0, 4.0 * scatter / std::sqrt(kCount));
  EXPECT_NEAR(std::sqrt(squares / kCount), scatter, 4.0 * scatter / std::sqrt(2.0 * kCount));
}

}  // namespace
}  // namespace fathom
