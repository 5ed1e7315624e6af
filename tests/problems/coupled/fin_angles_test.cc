// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/fin_angles.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

// 0.2 rad/s towards 0.5 rad for 2 s, then back to 0.1 rad.
TEST(FinAngles, FollowTheirCommandNoFasterThanTheirRate) {
  CoupledCommand command;
  command.time = {1.0, 3.0};
  command.fins = {{"rudder", {}, {0.5, 0.1}}, {"plane", {}, {0.3, 0.2}}};
  CoupledModel model;
  model.fin_rate_limit = {{"rudder", 0.2}};
  const FinAngles angles(command, model);
  EXPECT_NEAR(angles.At(0, 0, 1.5), 0.3, 1e-15);
  EXPECT_NEAR(angles.At(0, 1, 0.0), 0.4, 1e-15);
  EXPECT_NEAR(angles.At(0, 1, 1.0), 0.2, 1e-15);
  EXPECT_EQ(angles.At(0, 1, 2.0), 0.1);
  EXPECT_EQ(angles.At(1, 0, 0.0), 0.3);
}

}  // namespace
}  // namespace fathom
