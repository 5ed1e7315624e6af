// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/caveats.h"

#include "fathom/vehicle/parameters.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// 3.16 - 1.96 x 3.1 < 0: the interval is cut there, and written as tables write it.
TEST(CaveatOnDamping, GivesTheIntervalThatTheTableShows) {
  EXPECT_EQ(CaveatOnDamping(kQuadraticDamping, 3.16, 3.1),
            "This log does not determine quadratic damping: its 95 % interval, 0.0 ... 9.2, is "
            "wider than ± 100 % of its value. Steady runs at several speeds up to the highest "
            "determine it.");
}

TEST(CaveatOnDamping, IsSilentWhereTheIntervalIsWithinTheValue) {
  EXPECT_EQ(CaveatOnDamping(kLinearDamping, 40.7, 20.7), "");
  EXPECT_NE(CaveatOnDamping(kLinearDamping, 40.7, 20.8), "");
}

TEST(CaveatOnDamping, HasNoIntervalWhereNothingIsKnown) {
  EXPECT_EQ(CaveatOnDamping(kLinearDamping, 40.7, std::numeric_limits<double>::infinity()),
            "This log does not determine linear damping: any value fits. Slow steady runs and "
            "coasting to rest determine it.");
}

// Of 360 s at 10 Hz.
HeldCommand CommandOf(double (*force)(double t)) {
  HeldCommand command;
  for (int i = 0; i < 3600; ++i) {
    command.time.push_back(0.1 * i);
    command.value.push_back(force(0.1 * i));
  }
  return command;
}

double Sine(double t) { return 50.0 * std::sin(0.3 * t); }

// As data/experiments/steps.yaml drives them.
double Steps(double t) {
  constexpr std::array kLevels = {20.0, 0.0, -20.0, 0.0, 60.0, 0.0, -60.0, 0.0};
  return kLevels[static_cast<std::size_t>(t / 30.0) % kLevels.size()];
}

TEST(CaveatOnDelay, IsSilentWhereStepsTellTheInertiaWithAnUnknownDelay) {
  DelayDoubt doubt = {.inertia = 851.0, .half_width = 0.027, .half_width_with_delay = 0.056};
  EXPECT_EQ(CaveatOnDelay(CommandOf(Steps), doubt), "");
  EXPECT_THAT(CaveatOnDelay(CommandOf(Sine), doubt), HasSubstr("a single sine of 0.3 rad/s"));
  doubt.half_width_with_delay = std::numeric_limits<double>::infinity();
  EXPECT_THAT(CaveatOnDelay(CommandOf(Steps), doubt),
              AllOf(StartsWith("This log cannot separate inertia, damping and a command delay. "),
                    HasSubstr("the inertia is not determined. To separate them, use")));
}

// Steps have all frequencies: what they cannot tell is no matter of the command.
TEST(CaveatOnDelay, SendsToTheDiagnosisWhereStepsLeaveADelayOpen) {
  const DelayDoubt doubt = {.inertia = 851.0,
                            .inertia_per_second = -70.0,
                            .linear_damping_per_second = 4.1,
                            .half_width = 0.027,
                            .half_width_with_delay = 8.6};  // just over a hundredth
  EXPECT_EQ(CaveatOnDelay(CommandOf(Steps), doubt),
            "The values hold only if there is no delay. One second of delay would change the "
            "inertia by -70 and the linear damping by 4.1. With an unknown delay the inertia is "
            "known to ± 8.6 and not to ± 0.027 (95 %). Run fathom_diagnose on this log: it looks "
            "for a delay of the command (time_offset).");
}

}  // namespace
}  // namespace fathom
