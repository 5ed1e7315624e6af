// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Flags and logs that fathom_diagnose refuses beside those that every tool does.

#include <filesystem>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include "small_log.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Path = std::filesystem::path;

class DiagnoseRefusals : public ::testing::Test {
 protected:
  std::string Refused(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"--log=" + log_.string(),
                                          "--verdict=" + (folder_ / "out/verdict.json").string(),
                                          "--report=" + (folder_ / "out/page.html").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return ExpectRefusal("fathom_diagnose", arguments, folder_);
  }

  const Path folder_ = EmptyTestFolder();
  const Path log_ = WriteSmallLog(folder_ / "log");
};

TEST_F(DiagnoseRefusals, AFalseAlarmRateThatIsNone) {
  for (const std::string rate : {"0", "-0.1", "0.6", "1e300"}) {
    const std::string shown = rate == "1e300" ? "1e+300" : rate;
    EXPECT_EQ(Refused({"--false_alarm_rate=" + rate}),
              "fathom_diagnose: --false_alarm_rate: is " + shown +
                  ", expected above 0 and at most 0.5.\n");
  }
  for (const std::string rate : {"often", "nan", "inf"}) {
    EXPECT_EQ(Refused({"--false_alarm_rate=" + rate}),
              "fathom_diagnose: --false_alarm_rate: is '" + rate + "', expected a number.\n");
  }
}

TEST_F(DiagnoseRefusals, ASeedThatIsNone) {
  EXPECT_EQ(Refused({"--seed=-1"}),
            "fathom_diagnose: --seed: is '-1', expected a whole number, at least 0.\n");
}

TEST_F(DiagnoseRefusals, AnUnknownDof) {
  EXPECT_EQ(Refused({"--dof=forward"}),
            "fathom_diagnose: --dof: is 'forward', expected surge, sway, heave, roll, pitch or "
            "yaw.\n");
}

TEST_F(DiagnoseRefusals, ALogOfSeveralDofsWithoutSayingWhich) {
  WriteTestFile(log_ / "log.yaml", "name: small\ndof: [surge, yaw]\n");
  EXPECT_EQ(Refused({}),
            "fathom_diagnose: --dof: is missing, and " + (log_ / "log.yaml").string() +
                " names 2 DOFs; say which.\n");
}

// The heave of the second log is not what the surge of the first one lacks.
TEST_F(DiagnoseRefusals, LogsOfDifferentDofsWithoutSayingWhich) {
  const Path second = WriteSmallLog(folder_ / "second");
  WriteTestFile(second / "velocity.csv", SmallVelocityCsv() + "60.1,0\n");
  WriteTestFile(second / "log.yaml", "name: second\ndof: heave\n");
  EXPECT_EQ(Refused({"--log=" + second.string()}),
            "fathom_diagnose: --dof: is missing, and " + (log_ / "log.yaml").string() +
                " names surge, but " + (second / "log.yaml").string() + " heave; say which.\n");
}

TEST_F(DiagnoseRefusals, PosesThatAreTooFew) {
  std::filesystem::remove(log_ / "velocity.csv");
  WriteTestFile(log_ / "pose.csv",
                "t,x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n0.1,0.01,0,0,0,0,0,1\n"
                "0.2,0.02,0,0,0,0,0,1\n");
  EXPECT_EQ(Refused({}),
            "fathom_diagnose: small: holds 3 poses, expected at least 20 to use them.\n");
}

TEST_F(DiagnoseRefusals, ADofThatTheLogDoesNotMeasure) {
  EXPECT_EQ(Refused({"--dof=heave"}),
            "fathom_diagnose: " + (log_ / "velocity.csv").string() +
                ": column 'w' is missing; the columns are u. Choose a DOF that was measured.\n");
}

TEST_F(DiagnoseRefusals, AVelocityFileForSeveralLogs) {
  const Path second = WriteSmallLog(folder_ / "second");
  EXPECT_EQ(Refused({"--log=" + second.string(), "--velocity=velocity.csv"}),
            "fathom_diagnose: --velocity: belongs to one log, expected a single --log with it.\n");
}

TEST_F(DiagnoseRefusals, TheSameLogTwice) {
  const std::string again = (log_ / ".." / log_.filename()).string();
  EXPECT_EQ(Refused({"--log=" + again}),
            "fathom_diagnose: --log: names " + again + " twice, expected each log once.\n");
}

TEST_F(DiagnoseRefusals, TheSecondOfTwoLogs) {
  const Path second = folder_ / "second";
  EXPECT_EQ(Refused({"--log=" + second.string()}),
            "fathom_diagnose: " + second.string() +
                ": there is no such log folder or CSV file. Check the path.\n");
}

TEST_F(DiagnoseRefusals, LogsWhoseForcesHaveDifferentUnits) {
  const Path second = WriteSmallLog(folder_ / "second");
  WriteTestFile(second / "velocity.csv", SmallVelocityCsv() + "60.1,0\n");
  WriteTestFile(second / "log.yaml", "name: second\ndof: surge\ncommand_unit: A\n");
  EXPECT_THAT(Refused({"--log=" + second.string()}),
              AllOf(StartsWith("fathom_diagnose: "), HasSubstr("second"), HasSubstr("A")));
}

// Nothing is printed as if all were well, and no page is left.
TEST_F(DiagnoseRefusals, AVerdictThatCannotBeWritten) {
  WriteTestFile(folder_ / "file", "not a folder\n");
  const std::string verdict = (folder_ / "file/verdict.json").string();
  EXPECT_THAT(ExpectRefusal("fathom_diagnose",
                            {"--log=" + log_.string(),
                             "--verdict=" + verdict,
                             "--report=" + (folder_ / "out/page.html").string()},
                            folder_),
              StartsWith("fathom_diagnose: " + verdict + ": cannot write this file: "));
}

// The verdict is not left behind by the page that cannot be written.
TEST_F(DiagnoseRefusals, APageThatCannotBeWritten) {
  WriteTestFile(folder_ / "file", "not a folder\n");
  const std::string page = (folder_ / "file/page.html").string();
  EXPECT_THAT(ExpectRefusal("fathom_diagnose",
                            {"--log=" + log_.string(),
                             "--verdict=" + (folder_ / "verdict.json").string(),
                             "--report=" + page},
                            folder_),
              StartsWith("fathom_diagnose: " + page + ": cannot write this file: "));
}

}  // namespace
}  // namespace fathom
