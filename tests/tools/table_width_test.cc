// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A terminal of 100 columns shows every table whole.

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "bundled_data.h"
#include "real_data.h"
#include "run_tool.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kLog = "--log=" + kFlatfish;

// Bytes of UTF-8 that continue a character count for nothing.
std::size_t WidthOf(const std::string& line) {
  return std::ranges::count_if(
      line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

// The lines of tables: from the headings above a rule of dashes to the first line without a gap
// between columns.
std::vector<std::string> LinesOfTables(const std::string& out) {
  std::istringstream stream(out);
  std::vector<std::string> lines;
  bool is_in_table = false;
  std::string before;
  for (std::string line; std::getline(stream, line); before = line) {
    const std::string start = line.substr(std::min(line.find_first_not_of(' '), line.size()));
    const bool is_rule =
        start.starts_with("---") && line.find_first_not_of("- ") == std::string::npos;
    if (is_rule) lines.push_back(before);
    is_in_table = is_rule || (is_in_table && line.find("  ") != std::string::npos);
    if (is_in_table) lines.push_back(line);
  }
  return lines;
}

void ExpectTablesThatFit(const std::string& tool, const std::vector<std::string>& arguments) {
  const ToolRun run = RunToolBinary(tool, arguments);
  EXPECT_NE(run.exit_code, 1) << tool << run.err;
  const std::vector<std::string> lines = LinesOfTables(run.out);
  EXPECT_GE(lines.size(), 3U) << tool << run.out;
  for (const std::string& line : lines) EXPECT_LE(WidthOf(line), 100U) << tool << "\n" << line;
}

TEST(TableWidth, IsAtMost100OnTheBundledLogs) {
  const std::string pool = std::string("--from=") + FATHOM_DATA_DIR + "/recordings/pool.csv";
  ExpectTablesThatFit("fathom_identify", {kLog, "--dof=surge"});
  ExpectTablesThatFit("fathom_compare", {kLog});
  ExpectTablesThatFit("fathom_compare", {kLog, "--held_out=240:300"});
  ExpectTablesThatFit("fathom_diagnose", {kLog, "--dof=surge"});
  ExpectTablesThatFit("fathom_diagnose", {kLog, "--dof=yaw"});
  ExpectTablesThatFit("fathom_check", {kLog});
  ExpectTablesThatFit("fathom_import", {pool, "--list"});
}

TEST(TableWidth, IsAtMost100ForSeveralRuns) {
  const auto folder = EmptyTestFolder();
  std::vector<std::string> arguments = {"--dof=surge", kLog};
  arguments.push_back("--log=" +
                      WriteSmallLog(folder / "run_with_a_long_name_of_its_own").string());
  ExpectTablesThatFit("fathom_identify", arguments);
  arguments.emplace_back("--offset=per_log");
  ExpectTablesThatFit("fathom_identify", arguments);
}

TEST(TableWidth, LeavesOutColumnsOfSeveralCheckedLogs) {
  const std::string small =
      "--log=" + WriteSmallLog(EmptyTestFolder() / "run_with_a_long_name_of_its_own").string();
  const std::string out = RunToolBinary("fathom_check", {kLog, small, "--dof=surge"}).out;
  EXPECT_THAT(out, AllOf(HasSubstr("quadratic_damping [kg/m]\n"), HasSubstr("more with --wide")));
  const std::string all = RunToolBinary("fathom_check", {kLog, small, "--dof=surge", "--wide"}).out;
  EXPECT_THAT(all, AllOf(HasSubstr("buoyancy [N]\n"), Not(HasSubstr("more with --wide"))));
}

TEST(TableWidth, LeavesOutNoHeldOutScore) {
  const std::string out = RunToolBinary("fathom_compare", {kLog, "--dofs=yaw"}).out;
  EXPECT_THAT(out, HasSubstr("held-out NMAE\n"));
  EXPECT_THAT(out, HasSubstr("(5 columns more with --wide)"));
}

TEST(TableWidth, IsThatOfAllColumnsIfAskedFor) {
  const std::string out = RunToolBinary("fathom_compare", {kLog, "--dofs=yaw", "--wide"}).out;
  EXPECT_THAT(out, HasSubstr("buoyancy [N m]  training MAE [rad/s]"));
  EXPECT_THAT(out, Not(HasSubstr("more with --wide")));
}

TEST(TableWidth, HasRoomForEveryFieldOfARecordingIfAskedFor) {
  const std::string pool = std::string("--from=") + FATHOM_DATA_DIR + "/recordings/pool.csv";
  EXPECT_THAT(RunToolBinary("fathom_import", {pool, "--list", "--wide"}).out,
              AllOf(HasSubstr("Speed [cm/s]"), HasSubstr("type")));
}

class TableWidthOnRealRecordings : public OnRealData {};

TEST_F(TableWidthOnRealRecordings, IsAtMost100) {
  for (const char* name : {"bin/ardusub_4.5_sitl_visp.BIN", "ardusub_small.tlog"}) {
    ExpectTablesThatFit("fathom_import", {Flag("from", folder_ / "formats" / name), "--list"});
  }
}

}  // namespace
}  // namespace fathom
