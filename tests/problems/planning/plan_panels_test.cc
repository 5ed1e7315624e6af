// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_panels.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(PlanPanels, ShowBothLimitsInOneColour) {
  const PlannedBand band = {{0.0, 0.5}, {-0.1, 0.3}, {0.1, 0.7}};
  const TimePanel panel = MotionPanel("surge velocity", "m/s", {0.0, 1.0}, band, {-0.6, 0.8});
  ASSERT_EQ(panel.responses.size(), 3U);
  EXPECT_EQ(panel.responses[1].name, "limit -0.6 m/s");
  EXPECT_EQ(panel.responses[2].name, "limit 0.8 m/s");
  EXPECT_EQ(panel.responses[1].ColorName(), panel.responses[2].ColorName());
  EXPECT_NE(panel.responses[1].ColorName(), panel.responses[0].ColorName());
}

}  // namespace
}  // namespace fathom
