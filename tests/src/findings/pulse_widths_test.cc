// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/pulse_widths.h"

#include <optional>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

std::optional<Finding> CheckPulses(const std::vector<double>& command) {
  Segment segment;
  segment.command.value = command;
  return CheckPulseWidths({&segment, 1});
}

TEST(PulseWidths, AreSaidWhereEveryCommandIsOne) {
  const auto finding = CheckPulses({1500.0, 1180.0, 1820.0, 1500.0});
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, Severity::kWarning);
  EXPECT_EQ(finding->code, "pulse_widths");
  EXPECT_THAT(finding->sentence, HasSubstr("lies between 1180 and 1820"));
}

TEST(PulseWidths, AreNotSaidOfForces) {
  EXPECT_FALSE(CheckPulses({0.0, 1180.0, 1820.0}));
  EXPECT_FALSE(CheckPulses({-1500.0, 1500.0}));
  EXPECT_FALSE(CheckPulses({-1500.0, -1180.0}));
  EXPECT_FALSE(CheckPulses({900.0, 2400.0}));
  EXPECT_FALSE(CheckPulses({12.0, 40.0}));
  EXPECT_FALSE(CheckPulses({}));
}

}  // namespace
}  // namespace fathom
