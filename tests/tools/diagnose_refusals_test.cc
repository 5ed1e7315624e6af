// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Flags and logs that fathom_diagnose refuses beside those that every tool does.

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Path = std::filesystem::path;

class DiagnoseRefusals : public ::testing::Test {
 protected:
  std::string Refused(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {Flag("log", log_),
                                          Flag("verdict", folder_ / "out/verdict.json"),
                                          Flag("report", folder_ / "out/page.html")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return ExpectRefusal("fathom_diagnose", arguments, folder_);
  }

  const Path folder_ = EmptyTestFolder();
  const Path log_ = WriteSmallLog(folder_ / "log");
};

TEST_F(DiagnoseRefusals, AFlagOfAnotherRange) {
  const std::string rate = "--false_alarm_rate", above = ", expected above 0 and at most 0.5.\n";
  for (const auto& [flag, value, said] : std::vector<std::array<std::string, 3>>{
           {rate, "0", "0" + above},
           {rate, "-0.1", "-0.1" + above},
           {rate, "0.6", "0.6" + above},
           {rate, "1e300", "1e+300" + above},
           {rate, "often", "'often', expected a number.\n"},
           {rate, "nan", "'nan', expected a number.\n"},
           {rate, "inf", "'inf', expected a number.\n"},
           {"--seed", "-1", "'-1', expected a whole number, at least 0.\n"},
           {"--dof", "up", "'up', expected surge, sway, heave, roll, pitch or yaw.\n"}}) {
    EXPECT_EQ(Refused({flag + "=" + value}), "fathom_diagnose: " + flag + ": is " + said);
  }
}

// A diagnosis chooses it: its help does not list what it would refuse.
TEST_F(DiagnoseRefusals, AStructureThatItsHelpDoesNotList) {
  EXPECT_THAT(Refused({"--dofs=surge,yaw", "--structure=full"}),
              HasSubstr("--structure: there is no such flag"));
  EXPECT_THAT(RunsWell("fathom_diagnose", {"--help"}).out, Not(HasSubstr("--structure")));
  EXPECT_THAT(Refused({"--window=5"}), HasSubstr("--window: goes with --dofs"));
}

TEST_F(DiagnoseRefusals, ALogOfSeveralDofsWithoutSayingWhich) {
  WriteTestFile(log_ / "log.yaml", "name: small\ndof: [surge, yaw]\n");
  EXPECT_EQ(Refused({}),
            "fathom_diagnose: --dof: is missing, and " + (log_ / "log.yaml").string() +
                " names 2 DOFs; say which, or take them as one motion with --dofs=surge,yaw.\n");
}

// The heave of the second log is not what the surge of the first one lacks.
TEST_F(DiagnoseRefusals, LogsOfDifferentDofsWithoutSayingWhich) {
  const Path second = WriteSmallLog(folder_ / "second");
  WriteTestFile(second / "velocity.csv", SmallVelocityCsv() + "60.1,0\n");
  WriteTestFile(second / "log.yaml", "name: second\ndof: heave\n");
  EXPECT_EQ(Refused({Flag("log", second)}),
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
  EXPECT_EQ(Refused({Flag("log", second), "--velocity=velocity.csv"}),
            "fathom_diagnose: --velocity: belongs to one log, expected a single --log with it.\n");
}

TEST_F(DiagnoseRefusals, TheSameLogTwice) {
  const std::string again = (log_ / ".." / log_.filename()).string();
  EXPECT_EQ(Refused({"--log=" + again}),
            "fathom_diagnose: --log: names " + again + " twice, expected each log once.\n");
}

TEST_F(DiagnoseRefusals, TheSecondOfTwoLogs) {
  const Path second = folder_ / "second";
  EXPECT_EQ(Refused({Flag("log", second)}),
            "fathom_diagnose: " + second.string() +
                ": there is no such log folder or CSV file. Check the path.\n");
}

TEST_F(DiagnoseRefusals, LogsWhoseForcesHaveDifferentUnits) {
  const Path second = WriteSmallLog(folder_ / "second");
  WriteTestFile(second / "velocity.csv", SmallVelocityCsv() + "60.1,0\n");
  WriteTestFile(second / "log.yaml", "name: second\ndof: surge\ncommand_unit: A\n");
  EXPECT_THAT(Refused({Flag("log", second)}),
              AllOf(StartsWith("fathom_diagnose: "), HasSubstr("second"), HasSubstr("A")));
}

// Nothing is printed as if all were well, and neither output is left behind by the other.
TEST_F(DiagnoseRefusals, AnOutputThatCannotBeWritten) {
  WriteTestFile(folder_ / "file", "not a folder\n");
  for (const auto& [wrong, other] : {std::pair{"verdict", "report"}, {"report", "verdict"}}) {
    const Path output = folder_ / "file/output";
    EXPECT_THAT(
        ExpectRefusal("fathom_diagnose",
                      {Flag("log", log_), Flag(wrong, output), Flag(other, folder_ / "out/other")},
                      folder_),
        StartsWith("fathom_diagnose: " + output.string() + ": cannot write this file: "));
  }
}

}  // namespace
}  // namespace fathom
