// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log.h"
#include "fathom/log/read_log.h"

#include "real_data.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

// The row counts are those of `wc -l`, less the header.
using RealLogs = OnRealData;

TEST_F(RealLogs, LbvSurgeIsReadWithPosesAndHeldOutTime) {
  const Log log = ReadLog(folder_ / "lbv_surge");
  EXPECT_EQ(log.command->time.size(), 1500u);
  EXPECT_EQ(log.command->columns.size(), 6u);
  EXPECT_EQ(log.pose->time.size(), 1754u);
  EXPECT_FALSE(log.velocity.has_value());
  EXPECT_THAT(log.dofs, ElementsAre(Dof::kSurge));
  ASSERT_EQ(log.held_out.size(), 1u);
  EXPECT_EQ(log.held_out[0].from, 1433350770.0);
  EXPECT_EQ(log.pose->time[0], 1433350639.315205);
  EXPECT_EQ((*log.pose->Find("x"))[0], -2.473268986);
  EXPECT_EQ((*log.pose->Find("qw"))[1], 0.9912175943);
  EXPECT_THAT(log.remarks, IsEmpty());
}

TEST_F(RealLogs, LbvSurgeIsReadWithItsAuthorsVelocity) {
  const Log log = ReadLog(folder_ / "lbv_surge", {.dof = {}, .velocity = "author_velocity.csv"});
  EXPECT_THAT(log.velocity->columns, ElementsAre("u", "v", "w", "p", "q", "r"));
  EXPECT_EQ((*log.velocity->Find("u"))[1], -0.00773000542298773);
  EXPECT_THAT(
      TextsOf(log.remarks),
      ElementsAre(StartsWith("author_velocity.csv: 12 further columns are not read: du, dv, ")));
}

TEST_F(RealLogs, LbvYawIsReadWithVelocityOnly) {
  const Log log = ReadLog(folder_ / "lbv_yaw");
  EXPECT_THAT(log.dofs, ElementsAre(Dof::kYaw));
  EXPECT_THAT(log.velocity->columns, ElementsAre("r"));
  EXPECT_FALSE(log.pose.has_value());
  EXPECT_EQ((*log.velocity->Find("r"))[1], 0.0087177401);
}

TEST_F(RealLogs, PoolRovSurgeIsReadWithItsCommandInAmpere) {
  const Log log = ReadLog(folder_ / "pool_rov_surge");
  EXPECT_EQ(log.velocity->time.size(), 6201u);
  EXPECT_EQ(log.command_unit, "A");
  EXPECT_THAT(log.command->columns, ElementsAre("tau_surge", "tau_sway", "tau_heave"));
}

}  // namespace
}  // namespace fathom
