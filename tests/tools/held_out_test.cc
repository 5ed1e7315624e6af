// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// --held_out says what log.yaml says with held_out, and says it of a single CSV too.

#include <filesystem>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using Path = std::filesystem::path;

// The small log with this line more in its log.yaml.
Path WriteLogWith(const Path& folder, const std::string& line) {
  WriteSmallLog(folder);
  WriteTestFile(folder / "log.yaml", "name: small\ndof: surge\n" + line);
  return folder;
}

struct FitOrScore {
  std::string tool;
  std::vector<std::string> flags;  // beside --log
};

std::vector<FitOrScore> ToolsThatFitOrScore(const Path& folder) {
  const std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  return {{"fathom_identify", {"--dof=surge"}},
          {"fathom_compare", {"--dofs=surge"}},
          {"fathom_diagnose", {"--dof=surge"}},
          {"fathom_simulate", {"--model=" + model}},
          {"fathom_check", {"--dof=surge"}}};
}

ToolRun RunOn(const FitOrScore& asked, const Path& log, const std::string& held_out = "") {
  std::vector<std::string> arguments = asked.flags;
  arguments.push_back(Flag("log", log));
  if (!held_out.empty()) arguments.push_back("--held_out=" + held_out);
  return RunToolBinary(asked.tool, arguments);
}

// What was printed, with every path of the log called LOG, and without --held_out in the command
// that is proposed.
std::string OutOf(const ToolRun& run, const Path& log) {
  std::string out = run.out;
  const auto replace = [&](const std::string& text, const std::string& by) {
    for (auto at = out.find(text); at != std::string::npos; at = out.find(text)) {
      out.replace(at, text.size(), by);
    }
  };
  replace(log.string(), "LOG");
  replace(" --held_out=10:20,45:60", "");
  return out;
}

TEST(HeldOut, TakesThePlaceOfLogYamls) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteLogWith(folder / "log", "held_out: [[10, 20], [45, 60]]\n");
  const Path other = WriteLogWith(folder / "other" / "log", "held_out: [0, 30]\n");
  for (const FitOrScore& asked : ToolsThatFitOrScore(folder)) {
    const ToolRun expected = RunOn(asked, log);
    const ToolRun run = RunOn(asked, other, "10:20,45:60");
    EXPECT_EQ(run.exit_code, expected.exit_code) << asked.tool << run.err;
    EXPECT_EQ(OutOf(run, other), OutOf(expected, log)) << asked.tool;
    if (asked.tool != "fathom_check") {
      EXPECT_NE(OutOf(RunOn(asked, other), other), OutOf(expected, log)) << asked.tool;
    }
  }
}

// A fit of all data would be judged by what it was trained on.
TEST(HeldOut, IsPartOfTheCommandThatACheckProposes) {
  const Path csv = WriteTestFile(EmptyTestFolder() / "small.csv", SmallSingleCsv());
  const ToolRun run = RunOn({"fathom_check", {"--dof=surge", "--correct=v:1.5"}}, csv, "45:60");
  EXPECT_THAT(run.out,
              HasSubstr("--log=" + csv.string() + " --held_out=45:60 --correct=v:1.5 --dof=surge"));
}

TEST(HeldOut, HoldsDataOutOfASingleCsv) {
  const Path folder = EmptyTestFolder();
  const Path csv = WriteTestFile(folder / "small.csv", SmallSingleCsv());
  const Path log = WriteLogWith(folder / "log", "held_out: [45, 60]\n");
  const FitOrScore identify = {"fathom_identify", {"--dof=surge"}};
  const ToolRun run = RunsWell(RunOn(identify, csv, "45:60"));
  EXPECT_THAT(run.out, HasSubstr("held out"));
  const std::string fit = RunOn(identify, log).out;
  EXPECT_EQ(run.out.substr(run.out.find("inertia")), fit.substr(fit.find("inertia")));
}

TEST(HeldOut, RefusesWhatLiesOutsideTheLog) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteLogWith(folder / "log", "held_out: [45, 60]\n");
  for (const FitOrScore& asked : ToolsThatFitOrScore(folder)) {
    const ToolRun run = RunOn(asked, log, "70:80");
    EXPECT_EQ(run.exit_code, 1) << asked.tool;
    EXPECT_THAT(run.err, HasSubstr("--held_out: 70:80 lies outside the data")) << asked.tool;
    EXPECT_EQ(run.out, "") << asked.tool;
  }
}

TEST(HeldOut, IsNamedWhereItLeavesNothingToTrainOn) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteLogWith(folder / "log", "");
  for (const FitOrScore& asked : ToolsThatFitOrScore(folder)) {
    if (asked.tool == "fathom_simulate" || asked.tool == "fathom_check") continue;
    const ToolRun run = RunOn(asked, log, "0:400");
    EXPECT_EQ(run.exit_code, 1) << asked.tool;
    EXPECT_EQ(run.err,
              asked.tool + ": --held_out: takes all of the data, expected some to train on.\n");
  }
}

TEST(HeldOut, RefusesWhatIsNoInterval) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteLogWith(folder / "log", "");
  std::vector<FitOrScore> tools = ToolsThatFitOrScore(folder);
  tools.push_back({"fathom_refine", {"--dof=surge"}});
  for (const FitOrScore& asked : tools) {
    for (const std::string text : {"240", "300:240", "10:20,", "10-20"}) {
      std::vector<std::string> arguments = asked.flags;
      arguments.push_back(Flag("log", log));
      arguments.push_back("--held_out=" + text);
      EXPECT_THAT(ExpectRefusal(asked.tool, arguments, folder),
                  HasSubstr(": --held_out: holds '" + text.substr(text.find(',') + 1) +
                            "', expected from:to in seconds, from before to, as 240:300.\n"));
    }
  }
}

}  // namespace
}  // namespace fathom
