// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The next experiment, by thrusters.

#include <cmath>

#include "plan_inputs.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// Thrusts give the wrench, pulse widths the thrusts, both by arithmetic of the test.
TEST(PlanTool, WritesWhatTheThrustersDo) {
  const ThrusterInputs inputs;
  const ToolRun run = inputs.PlanThrusters();
  EXPECT_THAT(run.out, HasSubstr("note: The plan takes at most "));
  EXPECT_THAT(run.out, HasSubstr(" % of what a thruster gives (`front_"));
  const std::vector<double> force = inputs.Column("command.csv", "tau_surge");
  ASSERT_EQ(inputs.Column("thrusters.csv", "t"), inputs.Column("command.csv", "t"));
  ASSERT_EQ(inputs.Column("pulses.csv", "t"), inputs.Column("command.csv", "t"));
  std::vector<double> along(force.size()), squares(force.size());
  for (int k = 1; k <= 4; ++k) {
    const std::vector<double> thrust =
        inputs.Column("thrusters.csv", "thruster_" + std::to_string(k));
    for (std::size_t i = 0; i < force.size(); ++i) {
      along[i] += (k <= 2 ? -1.0 : 1.0) * std::sqrt(0.5) * thrust[i];
      squares[i] += thrust[i] * thrust[i];
      EXPECT_LE(thrust[i], 51.5);
      EXPECT_GE(thrust[i], -39.9);
    }
  }
  for (std::size_t i = 0; i < force.size(); ++i) {
    EXPECT_NEAR(along[i], force[i], 1e-4);
    EXPECT_NEAR(squares[i], 0.5 * force[i] * force[i], 1e-3);  // as short as can be: all alike
  }
  // 16 V, from the table: 3.9 N at 1580 us and 1.5 N at 1552 us, 6.4 N back at 1380 us and 3.1 N at
  // 1420 us, still at 1500 us.
  const std::vector<double> thrust = inputs.Column("thrusters.csv", "thruster_3");
  const std::vector<double> pulse = inputs.Column("pulses.csv", "thruster_3");
  int num_compared = 0;
  for (std::size_t i = 0; i < thrust.size(); ++i) {
    double expected = -1.0;
    if (thrust[i] == 0.0) expected = 1500.0;
    if (thrust[i] >= 1.5 && thrust[i] <= 3.9) expected = 1552.0 + 28.0 * (thrust[i] - 1.5) / 2.4;
    if (thrust[i] <= -3.1 && thrust[i] >= -6.4) expected = 1420.0 + 40.0 * (thrust[i] + 3.1) / 3.3;
    if (expected < 0.0) continue;
    EXPECT_NEAR(pulse[i], expected, 0.5 + 1e-6) << thrust[i];
    ++num_compared;
  }
  EXPECT_GT(num_compared, 5);
  EXPECT_EQ(pulse.back(), 1500.0);
}

TEST(PlanTool, RefusesWhatTheThrustersCannotGive) {
  const ThrusterInputs inputs;
  EXPECT_THAT(inputs.Refusal({inputs.heavy}), HasSubstr("--voltage: is missing"));
  EXPECT_THAT(inputs.Refusal({"--voltage=16"}), HasSubstr("--voltage: goes with --vehicle"));
  EXPECT_THAT(inputs.Refusal({"--vehicle=" + inputs.vehicle}),
              HasSubstr(inputs.vehicle + ": has no thrusters"));
  WriteTestFile(inputs.tank, "force: 140\n");
  // 39.9 N of four thrusters at 45 degrees.
  EXPECT_THAT(inputs.Refusal({inputs.heavy, "--voltage=16"}),
              HasSubstr(inputs.tank + ": key 'force' is 140 N, expected at most 112.853: the "
                                      "thrusters of"));
  WriteTestFile(inputs.tank, "force: 12\nthruster_force: 4\n");
  EXPECT_THAT(inputs.Refusal({inputs.heavy, "--voltage=16"}),
              HasSubstr("give surge -11.31 to 11.31 N"));
  EXPECT_THAT(inputs.Refusal({}),
              HasSubstr(inputs.tank + ": key 'thruster_force' goes with --vehicle"));
}

}  // namespace
}  // namespace fathom
