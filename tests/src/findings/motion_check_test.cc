// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/motion_check.h"

#include "fathom/log/read_log.h"
#include "fathom/signal/sources/choose_source.h"

#include <filesystem>

#include "real_data.h"
#include "values/noisy_motion.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Log NoisyLog() {
  const NoisyMotion motion = NoisyMotionOf(1000);
  Log log;
  log.path = "dive";
  log.velocity =
      Stream{.time = motion.time,
             .columns = {"u", "w"},
             .values = {Rounded(motion.value, 1e-4), Rounded(NoisyMotionOf(1000, 2).value, 1e-4)}};
  return log;
}

std::vector<Finding> Check(const Log& log) {
  return CheckMotion(log, Dof::kSurge, Source::kPoseEstimator);
}

TEST(MotionCheck, FindsNothingInASoundLog) { EXPECT_THAT(Check(NoisyLog()), IsEmpty()); }

TEST(MotionCheck, NamesFileColumnAndTime) {
  Log log = NoisyLog();
  std::vector<double>& u = log.velocity->values[0];
  for (int row = 40; row < 60; ++row) u[row] = 0.0;
  const std::vector<Finding> findings = Check(log);
  ASSERT_THAT(findings, ElementsAre(Field(&Finding::code, "lost_values")));
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_EQ(findings[0].sentence,
            "velocity.csv: u is exactly 0 in 20 rows (2 %) while the rows before and after "
            "them are far from 0, first at t = 4 s. The sensor had no reading. Take these rows "
            "out.");
}

TEST(MotionCheck, TellsOneDefectOnce) {
  Log log = NoisyLog();
  std::vector<double>& u = log.velocity->values[0];
  u[500] = -32.768;
  EXPECT_THAT(Check(log), ElementsAre(Field(&Finding::code, "sentinel")));
  log = NoisyLog();
  std::vector<double>& held = log.velocity->values[0];
  for (std::size_t row = 0; row < held.size(); ++row) held[row] = held[row - row % 20];
  EXPECT_THAT(Check(log), ElementsAre(Field(&Finding::code, "held_samples")));
}

TEST(MotionCheck, OnlyNotesSamplesHeldForAMoment) {
  Log log = NoisyLog();
  std::vector<double>& u = log.velocity->values[0];
  for (std::size_t row = 0; row < u.size(); ++row) u[row] = u[row - row % 2];
  EXPECT_THAT(Check(log), ElementsAre(Field(&Finding::severity, Severity::kNote)));
}

TEST(MotionCheck, LooksAtOtherColumnsOnlyWhereAsked) {
  Log log = NoisyLog();
  for (int row = 40; row < 60; ++row) log.velocity->values[1][row] = 0.0;
  EXPECT_THAT(Check(log), IsEmpty());
  EXPECT_THAT(CheckOtherMotion(log, Dof::kSurge),
              ElementsAre(Field(&Finding::sentence, HasSubstr("velocity.csv: w"))));
}

class MotionCheckOfRealLogs : public OnRealData {};

TEST_F(MotionCheckOfRealLogs, WarnsOfNoSoundLog) {
  namespace fs = std::filesystem;
  std::vector<fs::path> places = {folder_ / "lbv_surge",
                                  folder_ / "lbv_yaw",
                                  folder_ / "pool_rov_surge",
                                  folder_ / "emps_pulses_pose",
                                  folder_ / "emps_pulses_velocity",
                                  folder_ / "dc_motor_stairs",
                                  folder_ / "silverbox_small",
                                  folder_ / "silverbox_sweep"};
  for (const char* many : {"hsm150_runs", "kingfisher_runs", "boat_archive", "ship_zigzags"}) {
    for (const auto& entry : fs::directory_iterator(folder_ / many)) {
      if (fs::exists(entry.path() / "log.yaml")) places.push_back(entry.path());
    }
  }
  for (const fs::path& place : places) {
    const Log log = ReadLog(place);
    for (const Dof dof : kAllDofs) {
      for (const Source source : SourcesOf(log, dof)) {
        for (const Finding& finding : CheckMotion(log, dof, source)) {
          EXPECT_EQ(finding.severity, Severity::kNote) << finding.sentence;
        }
      }
    }
  }
}

// The tracker of this run stood still four times, once for 6.7 s, and then jumped.
TEST_F(MotionCheckOfRealLogs, WarnsOfATrackerThatStoodStill) {
  const Log log = ReadLog(folder_ / "auv_6dof" / "surge_1");
  const std::vector<Finding> findings = CheckMotion(log, Dof::kSurge, Source::kCamera);
  ASSERT_THAT(findings, ElementsAre(Field(&Finding::code, "stuck_values")));
  EXPECT_THAT(findings[0].sentence, HasSubstr("pose.csv: "));
}

}  // namespace
}  // namespace fathom
