// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/stamp_check.h"

#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Stamps, AreRedWhereOverAHundredthOfAStreamIsOutOfOrder) {
  Log log;
  EXPECT_THAT(CheckStamps(log), IsEmpty());
  log.origin.emplace();
  log.origin->file = "dive.csv";
  log.origin->out_of_order = {{"command", 0.01}, {"velocity", 0.1}};
  const std::vector<Finding> findings = CheckStamps(log);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_EQ(findings[0].code, "stamp_order");
  EXPECT_THAT(findings[0].sentence,
              AllOf(HasSubstr("10 % of the stamps of the velocity"), HasSubstr("dive.csv")));
}

TEST(Stamps, AreRedWhereTheyCountRows) {
  Log log;
  log.origin.emplace();
  log.origin->file = "dive.csv";
  log.origin->row_counter = "index";
  const std::vector<Finding> findings = CheckStamps(log);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_EQ(findings[0].code, "row_counter");
  EXPECT_THAT(findings[0].sentence, HasSubstr("column 'index' of dive.csv"));
}

}  // namespace
}  // namespace fathom
