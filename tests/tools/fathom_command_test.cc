// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// `fathom identify` is fathom_identify: the same output, errors and exit code.

#include <chrono>
#include <csignal>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>

#include "expect_refusal.h"
#include "run_tool.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

void ExpectTheSame(const ToolRun& a, const ToolRun& b) {
  EXPECT_EQ(a.exit_code, b.exit_code);
  EXPECT_EQ(a.out, b.out);
  EXPECT_EQ(a.err, b.err);
}

TEST(FathomCommand, RunsTheProgramOfTheSubCommand) {
  const std::string log = "--log=" + WriteSmallLog(EmptyTestFolder() / "log").string();
  const ToolRun run = RunsWell("fathom", {"identify", log, "--dof=surge"});
  ExpectTheSame(run, RunToolBinary("fathom_identify", {log, "--dof=surge"}));
}

TEST(FathomCommand, KeepsTheNameAndExitCodeOfTheProgram) {
  EXPECT_EQ(ExpectRefusal("fathom", {"identify", "--log=a b", "--dof=surge"}, EmptyTestFolder()),
            "fathom_identify: a b: there is no such log folder or CSV file. Check the path.\n");
}

// Its process is the program's own: a signal to it ends that.
TEST(FathomCommand, BecomesTheProgramSoThatSignalsReachIt) {
  const std::string log = "--log=" + WriteSmallLog(EmptyTestFolder() / "log").string();
  std::string running;
  const ToolRun run = RunToolBinary("fathom", {"diagnose", log, "--dof=surge"}, [&](int process) {
    const std::filesystem::path link = "/proc/" + std::to_string(process) + "/exe";
    std::error_code error;
    for (int i = 0; i < 10000 && running != "fathom_diagnose"; ++i) {
      running = std::filesystem::read_symlink(link, error).filename().string();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(process, SIGKILL);
  });
  EXPECT_EQ(running, "fathom_diagnose");
  EXPECT_EQ(run.exit_code, 128 + SIGKILL);
}

TEST(FathomCommand, ListsEverySubCommandWithWhatItSaysOfItself) {
  const ToolRun list = RunsWell("fathom", {});
  EXPECT_EQ(list.err, "");
  for (const std::string command : {"batch",
                                    "check",
                                    "compare",
                                    "diagnose",
                                    "follow",
                                    "identify",
                                    "import",
                                    "init",
                                    "refine",
                                    "simulate",
                                    "synthesize",
                                    "track"}) {
    const std::string help = RunToolBinary("fathom_" + command, {"--help"}).out;
    const std::string summary = help.substr(0, help.find('\n'));
    ASSERT_GT(summary.size(), 20u) << command;
    EXPECT_THAT(list.out,
                HasSubstr("  " + command + std::string(12 - command.size(), ' ') + summary));
  }
  ExpectTheSame(list, RunToolBinary("fathom", {"--help"}));
  ExpectTheSame(list, RunToolBinary("fathom", {"help"}));
}

TEST(FathomCommand, ShowsTheHelpOfASubCommand) {
  const ToolRun help = RunsWell("fathom", {"help", "identify"});
  EXPECT_THAT(help.out, HasSubstr("Usage: fathom_identify "));
  ExpectTheSame(help, RunToolBinary("fathom_identify", {"--help"}));
}

// Whoever types the example as it stands finds all inputs: they are bundled, or an earlier line of
// it makes them.
TEST(FathomCommand, TellsExamplesThatRunFromTheRoot) {
  for (const std::string tool : {"batch",
                                 "check",
                                 "compare",
                                 "diagnose",
                                 "export",
                                 "identify",
                                 "import",
                                 "plan",
                                 "refine",
                                 "simulate",
                                 "synthesize",
                                 "track"}) {
    const std::string help = RunToolBinary("fathom_" + tool, {"--help"}).out;
    const auto begin = help.find("Example:\n\n");
    ASSERT_NE(begin, std::string::npos) << tool;
    std::istringstream words(help.substr(begin + 10, help.find("\n\n", begin + 10) - begin - 10));
    std::set<std::string> made;
    for (std::string word; words >> word;) {
      const auto equal = word.find('=');
      const std::string flag = word.substr(0, equal);
      const std::string value = equal == std::string::npos ? word : word.substr(equal + 1);
      const bool is_input = flag == "--log" || flag == "--archive" || flag == "--from" ||
                            flag == "--vehicle" || flag == "--experiment" || flag == "--film" ||
                            flag == "--limits" || value.starts_with("scripts/");
      if (is_input) {
        EXPECT_TRUE(made.contains(value) ||
                    std::filesystem::exists(std::filesystem::path(FATHOM_SOURCE_DIR) / value))
            << tool << ": " << word;
      }
      if (flag == "--out" || equal == std::string::npos) made.insert(value);
    }
  }
}

TEST(FathomCommand, SuggestsTheNearestSubCommand) {
  const auto folder = EmptyTestFolder();
  EXPECT_EQ(ExpectRefusal("fathom", {"idnetify"}, folder),
            "fathom: 'idnetify': there is no such sub-command, did you mean 'identify'? See fathom "
            "--help.\n");
  EXPECT_EQ(ExpectRefusal("fathom", {"help", "sim"}, folder),
            "fathom: 'sim': there is no such sub-command, did you mean 'simulate'? See fathom "
            "--help.\n");
  EXPECT_EQ(ExpectRefusal("fathom", {"swim"}, folder),
            "fathom: 'swim': there is no such sub-command. See fathom --help.\n");
  EXPECT_EQ(ExpectRefusal("fathom", {""}, folder),
            "fathom: '': there is no such sub-command. See fathom --help.\n");
}

// No file that is named like a program is run for it.
TEST(FathomCommand, RunsOnlyProgramsOfItsOwn) {
  EXPECT_THAT(ExpectRefusal("fathom", {"../tools/fathom_identify"}, EmptyTestFolder()),
              HasSubstr("there is no such sub-command"));
}

TEST(FathomCommand, AsksForTheSubCommandBeforeFlags) {
  EXPECT_THAT(ExpectRefusal("fathom", {"--log=data", "identify"}, EmptyTestFolder()),
              AllOf(HasSubstr("fathom: '--log=data': a sub-command comes first"),
                    HasSubstr("fathom --help")));
  EXPECT_THAT(ExpectRefusal("fathom", {"help", "identify", "simulate"}, EmptyTestFolder()),
              HasSubstr("'simulate': is one too many"));
}

TEST(FathomCommand, SaysVersionAndCommitAsEveryProgramDoes) {
  const ToolRun version = RunsWell("fathom", {"--version"});
  EXPECT_THAT(version.out,
              MatchesRegex("fathom [0-9]+\\.[0-9]+\\.[0-9]+ "
                           "\\(([0-9a-f]+( with changes)?|unknown)\\)\n"));
  ExpectTheSame(version, RunToolBinary("fathom_identify", {"--version"}));
}

}  // namespace
}  // namespace fathom
