// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// --correct, and `correct` of log.yaml, mend a column of velocity.csv in every tool.

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Path = std::filesystem::path;

// The small log with u turned round, and this line more in its log.yaml.
Path WriteTurnedLog(const Path& folder, const std::string& line = "") {
  WriteSmallLog(folder);
  WriteTestFile(folder / "log.yaml", "name: small\ndof: surge\n" + line);
  std::istringstream rows(SmallVelocityCsv());
  std::string turned = "t,u\n", row;
  std::getline(rows, row);
  while (std::getline(rows, row)) {
    const auto comma = row.find(',') + 1;
    const bool is_negative = row[comma] == '-';
    turned +=
        row.substr(0, comma) + (is_negative ? "" : "-") + row.substr(comma + is_negative) + "\n";
  }
  WriteTestFile(folder / "velocity.csv", turned);
  return folder;
}

TEST(Correct, MendsASignInEveryTool) {
  const Path folder = EmptyTestFolder();
  const Path sound = WriteSmallLog(folder / "sound");
  const Path turned = WriteTurnedLog(folder / "turned");
  const Path mended = WriteTurnedLog(folder / "mended", "correct: {u: -1}\n");
  const std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  const std::vector<std::vector<std::string>> tools = {{"fathom_identify", "--dof=surge"},
                                                       {"fathom_diagnose", "--dof=surge"},
                                                       {"fathom_simulate", "--model=" + model}};
  for (const auto& tool : tools) {
    const auto run = [&](const Path& log, const std::string& flag) {
      std::vector<std::string> arguments = {tool[1], Flag("log", log)};
      if (!flag.empty()) arguments.push_back(flag);
      ToolRun run = RunToolBinary(tool[0], arguments);
      for (auto at = run.out.find(log.string()); at != std::string::npos;
           at = run.out.find(log.string())) {
        run.out.replace(at, log.string().size(), "LOG");
      }
      return run;
    };
    const std::string expected = run(sound, "").out;
    EXPECT_NE(run(turned, "").out, expected) << tool[0];
    const ToolRun by_flag = run(turned, "--correct=u:-1");
    EXPECT_EQ(by_flag.out, expected) << tool[0];
    EXPECT_THAT(by_flag.err, HasSubstr("velocity.csv: u times -1, as --correct says.")) << tool[0];
    const ToolRun by_file = run(mended, "");
    EXPECT_EQ(by_file.out, expected) << tool[0];
    EXPECT_THAT(by_file.err, HasSubstr("velocity.csv: u times -1, as log.yaml says.")) << tool[0];
  }
}

TEST(Correct, IsWhatTheCheckOfAWrongSignAsksFor) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteTurnedLog(folder / "log");
  // Poses that move as the vehicle did: x is the integral of the sound u.
  std::istringstream rows(SmallVelocityCsv());
  std::string pose = "t,x,y,z,qx,qy,qz,qw\n", row;
  std::getline(rows, row);
  double x = 0.0;
  while (std::getline(rows, row)) {
    const auto comma = row.find(',');
    pose += row.substr(0, comma) + "," + std::to_string(x) + ",0,0,0,0,0,1\n";
    x += 0.1 * std::stod(row.substr(comma + 1));
  }
  WriteTestFile(log / "pose.csv", pose);
  const ToolRun wrong = RunToolBinary("fathom_check", {Flag("log", log)});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.out, HasSubstr("pose_twist_sign"));
  EXPECT_THAT(wrong.out, HasSubstr("`correct: {u: -1}` in log.yaml, or --correct=u:-1."));
  const ToolRun mended = RunToolBinary("fathom_check", {Flag("log", log), "--correct=u:-1"});
  EXPECT_THAT(mended.out, Not(HasSubstr("pose_twist_sign"))) << mended.err;
  EXPECT_THAT(mended.out + mended.err, HasSubstr("u times -1, as --correct says."));
}

TEST(Correct, RefusesWhatIsNoFactorOfAColumn) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  const auto refusal = [&](const std::string& correct) {
    return ExpectRefusal("fathom_check", {Flag("log", log), "--correct=" + correct}, folder);
  };
  for (const char* value : {"u", "u=-1", "u:0", "u:nan", "u:inf", ":-1"}) {
    EXPECT_THAT(
        refusal(value),
        HasSubstr("--correct: holds '" + std::string(value) +
                  "', expected column:factor, a factor that is finite and not 0, as p:-1, or "
                  "column:seconds, as u:0.25s."));
  }
  EXPECT_THAT(refusal("u:-1,u:2"), HasSubstr("--correct: names 'u' twice"));
  EXPECT_THAT(refusal("p:-1"), HasSubstr("--correct: corrects 'p', which is no column of"));
}

}  // namespace
}  // namespace fathom
