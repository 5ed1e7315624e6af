// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// All checks of a log, over logs that are sound.

#include "fathom/findings/log_check.h"

#include "fathom/log/read_log.h"
#include "fathom/signal/sources/choose_source.h"

#include <filesystem>
#include <string>
#include <vector>

#include "real_data.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> WarningsOf(const Log& log, Dof dof) {
  std::vector<std::string> sentences;
  for (const Finding& finding : CheckLogs({&log, 1}, dof)) {
    if (finding.severity == Severity::kWarning) sentences.push_back(finding.sentence);
  }
  return sentences;
}

void ExpectNoWarning(const Log& log) {
  for (const Dof dof : log.dofs) {
    if (SourcesOf(log, dof).empty()) continue;
    EXPECT_THAT(WarningsOf(log, dof), IsEmpty()) << log.path << ", " << Name(dof);
  }
}

TEST(LogCheck, WarnsOfNothingInTheBundledLog) {
  const Log log = ReadLog(FATHOM_DATA_DIR "/flatfish");
  ASSERT_THAT(log.dofs, ElementsAre(Dof::kSurge, Dof::kHeave, Dof::kYaw));
  ExpectNoWarning(log);
}

TEST(LogCheck, TakesTheBodyThatTheLogsAgreeOn) {
  Log one, other;
  one.path = other.path = FATHOM_DATA_DIR "/vehicles";
  EXPECT_FALSE(BodyOf(std::vector{one, other}));
  one.mass = 274.0;
  ASSERT_TRUE(BodyOf(std::vector{one, other}));
  EXPECT_FALSE(BodyOf(std::vector{one, other})->size);
  one.vehicle = "flatfish.yaml";
  EXPECT_THAT(BodyOf(std::vector{one, other})->size.value(), ElementsAre(2.10, 1.02, 0.50));
  other.mass = 275.0;
  EXPECT_FALSE(BodyOf(std::vector{one, other}));
}

// flatfish.yaml weighs 274 kg; the log's mass is in t.
TEST(LogCheck, WarnsOfAMassThatIsNotTheVehicles) {
  Log log = ReadLog(FATHOM_DATA_DIR "/flatfish");
  log.path = FATHOM_DATA_DIR "/vehicles";
  log.vehicle = "flatfish.yaml";
  log.mass = 274.0;
  EXPECT_THAT(WarningsOf(log, Dof::kSurge), IsEmpty());
  log.mass = 0.274;
  EXPECT_THAT(WarningsOf(log, Dof::kSurge), ElementsAre(HasSubstr("the vehicle file 274 kg")));
}

TEST(LogCheck, KnowsWhatTheLogsHold) {
  Log forces, speeds;
  forces.mass = 274.0;
  speeds.thrusters = Stream();
  speeds.velocity = Stream();
  const LoggedQuantities of_one = BodyOf(std::vector{forces})->logged;
  EXPECT_TRUE(of_one.force);
  EXPECT_FALSE(of_one.thruster_speed);
  EXPECT_FALSE(of_one.velocity);
  const LoggedQuantities of_both = BodyOf(std::vector{forces, speeds})->logged;
  EXPECT_TRUE(of_both.force && of_both.thruster_speed && of_both.velocity);
  speeds.thruster_unit = "N";
  EXPECT_FALSE(BodyOf(std::vector{forces, speeds})->logged.thruster_speed);
}

// The speed of yaw has the wrong sign, that of surge the right one.
TEST(LogCheck, NamesTheDofOfSeveral) {
  Log log = ReadLog(FATHOM_DATA_DIR "/flatfish");
  for (double& r : log.velocity->values[log.velocity->columns.size() - 1]) r = -r;
  ASSERT_EQ(log.velocity->columns.back(), "r");
  const std::vector<Dof> dofs = {Dof::kSurge, Dof::kYaw};
  std::vector<std::string> sentences;
  for (const Finding& finding : CheckLogs({&log, 1}, dofs)) {
    if (finding.code == "passivity") sentences.push_back(finding.sentence);
  }
  EXPECT_THAT(sentences, ElementsAre(testing::StartsWith("yaw: The mean power")));
}

TEST(LogCheck, SaysAtOnceThatNothingDrivesTheOthersOfSeveralDofs) {
  Log log = ReadLog(FATHOM_DATA_DIR "/flatfish");
  const std::vector<Dof> dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  const auto undriven = [&] {
    std::vector<std::string> sentences;
    for (const Finding& finding : CheckLogs({&log, 1}, dofs)) {
      if (finding.code == "undriven") sentences.push_back(finding.sentence);
    }
    return sentences;
  };
  EXPECT_THAT(undriven(), ::testing::IsEmpty());  // surge and yaw are driven
  const std::vector<double> surge = *log.command->Find("tau_surge");
  log.command->columns = {"tau_surge"};
  log.command->values = {surge};
  EXPECT_THAT(undriven(), ElementsAre(testing::StartsWith("No command acts on sway, yaw: ")));
  log.fins = Stream{.time = log.command->time, .columns = {"fin_rudder"}, .values = {surge}};
  EXPECT_THAT(undriven(), ::testing::IsEmpty());
}

void AddRuns(const fs::path& folder, std::vector<fs::path>* places) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (fs::exists(entry.path() / "log.yaml")) places->push_back(entry.path());
  }
}

class LogCheckOfRealLogs : public OnRealData {};

TEST_F(LogCheckOfRealLogs, WarnsOfNoSoundLog) {
  std::vector<fs::path> places;
  for (const char* one :
       {"lbv_surge", "pool_rov_surge", "emps_pulses_pose", "emps_pulses_velocity"}) {
    places.push_back(folder_ / one);
  }
  AddRuns(folder_ / "kingfisher_runs", &places);
  places.push_back(folder_ / "dc_motor_stairs");
  AddRuns(folder_ / "hsm150_runs", &places);
  ASSERT_EQ(places.size(), 4u + 12u + 1u + 12u);
  for (const fs::path& place : places) ExpectNoWarning(ReadLog(place));
}

}  // namespace
}  // namespace fathom
