// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/fin_check.h"

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::IsEmpty;
using ::testing::StartsWith;

Log LogWithFins(double rudder, double stern) {
  Log log;
  log.fins = Stream{.time = {0.0, 1.0},
                    .columns = {"fin_rudder", "fin_stern"},
                    .values = {{0.0, rudder}, {0.0, stern}}};
  return log;
}

TEST(CheckFins, TellsAnglesInDegrees) {
  const auto findings = CheckFins(LogWithFins(-20.0, 0.3));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].code, "fin_angle");
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_THAT(findings[0].sentence, StartsWith("command.csv: fin_rudder goes to 20,"));
}

TEST(CheckFins, SaysNothingOfAnglesBelowARightOne) {
  EXPECT_THAT(CheckFins(LogWithFins(1.5, -0.3)), IsEmpty());
  EXPECT_THAT(CheckFins(Log()), IsEmpty());
}

}  // namespace
}  // namespace fathom
