// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What `fathom completion` prints is sourced in a shell and asked for candidates.

#include "fathom/process/run_child.h"

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

const std::string kFathom = std::string(FATHOM_TOOLS_DIR) + "/fathom";

// The candidates for the last of the words, as bash splits a command line.
std::vector<std::string> Candidates(const std::vector<std::string>& words) {
  const std::string script = RunToolBinary("fathom", {"completion", "bash"}).out;
  ChildCommand bash;
  bash.program = "bash";
  bash.arguments = {"-c",
                    "source /dev/stdin <<< \"$1\"; shift; COMP_WORDS=(\"$@\"); "
                    "COMP_CWORD=$(($# - 1)); _fathom; printf '%s\\n' \"${COMPREPLY[@]}\"",
                    "bash",
                    script};
  bash.arguments.insert(bash.arguments.end(), words.begin(), words.end());
  const ChildResult result = RunChild(bash);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  std::istringstream lines(result.out);
  std::vector<std::string> candidates;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) candidates.push_back(line);
  }
  return candidates;
}

TEST(Completion, OffersSubCommands) {
  EXPECT_THAT(Candidates({kFathom, "s"}), UnorderedElementsAre("simulate", "synthesize"));
  EXPECT_THAT(Candidates({kFathom, "c"}), UnorderedElementsAre("check", "compare", "completion"));
  EXPECT_THAT(Candidates({kFathom, "help", "id"}), ElementsAre("identify"));
  EXPECT_THAT(Candidates({kFathom, "completion", ""}), UnorderedElementsAre("bash", "zsh"));
}

TEST(Completion, OffersTheFlagsOfTheProgram) {
  EXPECT_THAT(Candidates({kFathom, "compare", "--do"}), ElementsAre("--dofs="));
  EXPECT_THAT(Candidates({kFathom, "diagnose", "--do"}), ElementsAre("--dof=", "--dofs="));
  EXPECT_THAT(Candidates({kFathom + "_diagnose", "--log", "=", "data", "--do"}),
              ElementsAre("--dof=", "--dofs="));
  EXPECT_THAT(Candidates({kFathom, "identify", "--do"}), UnorderedElementsAre("--dof=", "--dofs="));
  // That of a bool takes no value.
  EXPECT_THAT(Candidates({kFathom, "import", "--li"}), ElementsAre("--list"));
  EXPECT_THAT(Candidates({kFathom, "identify", "--"}), Not(Contains(HasSubstr("minloglevel"))));
}

TEST(Completion, OffersFileNamesAsValues) {
  const std::filesystem::path folder = EmptyTestFolder();
  WriteTestFile(folder / "a dive.csv", "");
  WriteTestFile(folder / "pool" / "log.yaml", "");
  const std::string below = folder.string() + "/";
  const auto both = UnorderedElementsAre(below + "a dive.csv", below + "pool");
  EXPECT_THAT(Candidates({kFathom, "identify", "--log", "=", below}), both);
  EXPECT_THAT(Candidates({kFathom, "identify", "--log", below}), both);
  EXPECT_THAT(Candidates({kFathom + "_identify", "--log", "=", below}), both);
  EXPECT_THAT(Candidates({kFathom, "identify", "--log=" + below + "p"}),
              ElementsAre("--log=" + below + "pool"));
}

TEST(Completion, OffersNothingForASubCommandThatThereIsNot) {
  EXPECT_THAT(Candidates({kFathom, "swim", "--"}), IsEmpty());
}

// zsh's own completion needs a terminal: its parser judges the script.
TEST(Completion, IsAScriptOfZsh) {
  const ToolRun script = RunsWell("fathom", {"completion", "zsh"});
  EXPECT_THAT(script.out, testing::StartsWith("#compdef fathom fathom_batch "));
  const std::string file = WriteTestFile(EmptyTestFolder() / "_fathom", script.out).string();
  const ChildResult zsh = RunChild({.program = "zsh", .arguments = {"-n", file}});
  if (zsh.end == ChildEnd::kNotStarted) GTEST_SKIP() << "zsh is not installed";
  EXPECT_EQ(zsh.exit_code, 0) << zsh.err;
}

TEST(Completion, RefusesAnotherShell) {
  const auto folder = EmptyTestFolder();
  EXPECT_EQ(ExpectRefusal("fathom", {"completion", "fish"}, folder),
            "fathom: completion: is 'fish', expected bash or zsh.\n");
  EXPECT_EQ(ExpectRefusal("fathom", {"completion"}, folder),
            "fathom: completion: names no shell, expected bash or zsh.\n");
}

}  // namespace
}  // namespace fathom
