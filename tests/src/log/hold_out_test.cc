// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/hold_out.h"

#include <vector>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// A sample a second for a minute and a half, from `start` on; log.yaml holds 10 s to 20 s of it
// out.
Log LogFrom(double start) {
  Log log;
  Stream velocity{.time = {}, .columns = {"u"}, .values = {{}}};
  for (int i = 0; i < 90; ++i) {
    velocity.time.push_back(start + i);
    velocity.values[0].push_back(0.0);
  }
  log.velocity = velocity;
  log.held_out = {{.from = start + 10.0, .to = start + 20.0}};
  return log;
}

void ExpectHeldOut(const Log& log, double from, double to) {
  ASSERT_EQ(log.held_out.size(), 1U);
  EXPECT_EQ(log.held_out[0].from, from);
  EXPECT_EQ(log.held_out[0].to, to);
  EXPECT_TRUE(log.remarks.empty());
}

TEST(HoldOut, KeepsWhatTheLogSaysWhereNothingIsAsked) {
  Log log = LogFrom(0.0);
  HoldOut({}, &log);
  ExpectHeldOut(log, 10.0, 20.0);
}

TEST(HoldOut, TakesThePlaceOfWhatTheLogSays) {
  Log log = LogFrom(7.0);
  HoldOut({{.from = 30.0, .to = 40.0}}, &log);
  ExpectHeldOut(log, 30.0, 40.0);
}

TEST(HoldOut, CountsFromTheFirstSampleWhereStampsAreOfAnEpoch) {
  const double epoch = 1433350600.25;
  Log log = LogFrom(epoch);
  HoldOut({{.from = 30.0, .to = 40.0}}, &log);
  ExpectHeldOut(log, epoch + 30.0, epoch + 40.0);
  HoldOut({{.from = epoch + 50.0, .to = epoch + 60.0}}, &log);
  ExpectHeldOut(log, epoch + 50.0, epoch + 60.0);
}

TEST(HoldOut, SaysWhoHoldsNothingOut) {
  Log log = LogFrom(0.0);
  HoldOut({{.from = 100.0, .to = 200.0}}, &log);
  ASSERT_EQ(log.remarks.size(), 1U);
  EXPECT_EQ(log.remarks[0].text, "--held_out: [100, 200] holds no sample of the motion.");
  HoldOut({}, &log);
  EXPECT_THAT(log.remarks.back().text, HasSubstr("log.yaml: held_out [100, 200] holds no sample"));
}

TEST(HoldOut, RefusesAnIntervalOutsideTheLog) {
  const std::vector<TimeInterval> asked = {{.from = 80.0, .to = 200.0},
                                           {.from = 100.0, .to = 200.0}};
  const auto refusal = [&](std::vector<Log> logs) {
    for (Log& log : logs) HoldOut(asked, &log);
    return ErrorFrom([&] { RequireHeldOutInside(asked, logs); });
  };
  Log dive = LogFrom(0.0), epoch = LogFrom(1433350600.25);
  dive.path = "dive";
  epoch.path = "epoch";
  EXPECT_EQ(refusal({dive}),
            "--held_out: 100:200 lies outside the data, expected seconds within them: dive lasts "
            "from 0.0 to 89.0 s.");
  EXPECT_THAT(refusal({epoch}), HasSubstr("epoch lasts from 0.0 to 89.0 s."));
  EXPECT_THAT(refusal({dive, epoch}), HasSubstr("dive lasts from 0.0 to 89.0 s, epoch lasts from"));
  // In one of several logs is enough.
  Log later = LogFrom(90.0);
  EXPECT_EQ(refusal({dive, later}), "no error");
}

}  // namespace
}  // namespace fathom
