// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The adaptive law on line: the numbers of the batch, and a stream that is interrupted.

#include "fathom/process/run_child.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "real_data.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using Path = std::filesystem::path;

// docs/adaptive.md (3) for the small log: about 20 N, 0.7 m/s, a period of some 10 s.
const std::vector<std::string> kSmallFlags = {"--dof=surge", "--gains=-0.2,1.6e-4,0.3,0.13,0.065"};

std::vector<std::string> And(std::vector<std::string> flags, const std::string& more) {
  flags.push_back(more);
  return flags;
}

std::vector<std::string> CellsOf(const std::string& line) {
  std::istringstream row(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
  return cells;
}

// t, inertia, quadratic damping, ... of the last line.
std::vector<double> LastNumbers(const ToolRun& run) {
  std::vector<double> numbers;
  for (const std::string& cell : CellsOf(LinesOf(run.out).back())) {
    numbers.push_back(cell.empty() ? NAN : std::stod(cell));
  }
  return numbers;
}

// The last line of the tool against the model file of fathom_identify on the same file.
void ExpectTheNumbersOfTheBatch(const Path& csv, const std::vector<std::string>& flags) {
  const Path model = TestFolder() / "model.json";
  auto of_batch = flags;
  of_batch.insert(of_batch.end(), {Flag("log", csv), "--family=adaptive", Flag("model", model)});
  const ToolRun batch = RunsWell("fathom_identify", of_batch);
  const ToolRun followed = RunsWell(RunToolBinaryOn(csv, "fathom_follow", And(flags, "--json")));
  const auto last = nlohmann::json::parse(LinesOf(followed.out).back());
  EXPECT_TRUE(last["usable"].get<bool>());
  const auto parameters = JsonOf(model)["parameters"];
  ASSERT_EQ(parameters.size(), 4u);
  for (const auto& [name, parameter] : parameters.items()) {
    const auto& own = last["parameters"][name];
    EXPECT_EQ(own["value"].get<double>(), parameter["value"].get<double>()) << name;
    EXPECT_EQ(own["unit"], parameter["unit"]);
    // Its third of the samples begins up to 1/512 of them beside the batch's.
    const double std = parameter["std"];
    EXPECT_NEAR(own["std"].get<double>(), std, 0.02 * std) << name;
  }
}

TEST(FollowTool, EndsAtTheNumbersOfTheBatch) {
  const Path csv = WriteTestFile(EmptyTestFolder() / "run.csv", SmallSingleCsv());
  ExpectTheNumbersOfTheBatch(csv, kSmallFlags);
  ExpectTheNumbersOfTheBatch(csv, And(kSmallFlags, "--integrator=euler"));
}

// The gains that the batch chose stand in its model file, and lead to the same model.
TEST(FollowTool, TakesTheGainsThatTheBatchChose) {
  const Path folder = EmptyTestFolder();
  const Path csv = WriteTestFile(folder / "run.csv", SmallSingleCsv());
  const Path model = folder / "model.json";
  RunsWell("fathom_identify",
           {Flag("log", csv), "--dof=surge", "--family=adaptive", Flag("model", model)});
  const auto chosen = JsonOf(model);
  const std::string gains = chosen["provenance"]["gains"];
  const ToolRun followed =
      RunsWell(RunToolBinaryOn(csv, "fathom_follow", {"--dof=surge", "--gains=" + gains}));
  EXPECT_EQ(LastNumbers(followed)[1], chosen["parameters"]["inertia"]["value"].get<double>());
}

class FollowToolOnRealData : public OnRealData {};

// The author's own law on his own data, as reference.json beside them has it.
TEST_F(FollowToolOnRealData, EndsAtTheNumbersOfTheBatchAndOfTheAuthor) {
  std::ifstream author(folder_ / "lbv_surge" / "author_velocity.csv");
  std::string csv = "t,tau,v\n", line;
  std::getline(author, line);
  ASSERT_THAT(line, HasSubstr("t,u,v,w,p,q,r,du,dv,dw,dp,dq,dr,tau_surge_shifted,"));
  std::getline(author, line);  // His record begins with the second sample.
  while (std::getline(author, line)) {
    const auto cells = CellsOf(line);
    csv += fmt::format("{},{},{}\n", cells[0], cells[13], cells[1]);
  }
  const Path file = WriteTestFile(EmptyTestFolder() / "run.csv", csv);
  const std::vector<std::string> flags = {
      "--dof=surge", "--gains=-0.005,0.5,0.5,0.5,0.05", "--integrator=euler"};
  ExpectTheNumbersOfTheBatch(file, flags);
  const auto own = LastNumbers(RunToolBinaryOn(file, "fathom_follow", flags));
  // His replay's numbers to nine digits, as AdaptiveIdentifierOnRealData has them.
  EXPECT_NEAR(own[1], 14.874438852929558, 1e-6);
  EXPECT_NEAR(own[2], 0.4795081841647953, 1e-7);
  EXPECT_NEAR(own[3], 4.346771816699996, 1e-7);
  EXPECT_NEAR(own[4], -0.023562092477141756, 1e-8);
}

TEST(FollowTool, PrintsALineForEachSample) {
  const Path folder = EmptyTestFolder();
  const Path csv = WriteTestFile(folder / "run.csv", SmallSingleCsv());
  const ToolRun run = RunsWell(RunToolBinaryOn(csv, "fathom_follow", kSmallFlags));
  EXPECT_EQ(run.err, "");
  const auto lines = LinesOf(run.out);
  ASSERT_EQ(lines.size(), 602u);
  EXPECT_EQ(lines[0],
            "t,inertia,quadratic_damping,linear_damping,buoyancy,inertia_std,"
            "quadratic_damping_std,linear_damping_std,buoyancy_std,usable");
  // Phi starts at 0, so that alpha is at its least, 1e-5, and nothing is known of the scatter.
  EXPECT_THAT(lines[1], ::testing::MatchesRegex("0,(100000|99999\\.9999+),0,0,0,,,,,0"));
  EXPECT_THAT(lines.back(), ::testing::StartsWith("60,"));
}

// The second line is sent only once the estimate behind the first one is there.
TEST(FollowTool, AnswersBeforeTheNextLineComes) {
  ChildCommand bash;
  bash.program = "bash";
  bash.arguments = {"-c",
                    "coproc \"$@\"; for i in 0 1; do echo $i,1,0 >&${COPROC[1]}; "
                    "[ $i = 1 ] || read -t 20 -u ${COPROC[0]} header; "
                    "read -t 20 -u ${COPROC[0]} line && echo \"${line%%,*}\"; done",
                    "bash",
                    std::string(FATHOM_TOOLS_DIR) + "/fathom_follow"};
  bash.arguments.insert(bash.arguments.end(), kSmallFlags.begin(), kSmallFlags.end());
  EXPECT_EQ(RunChild(bash).out, "0\n1\n");
}

TEST(FollowTool, TwoHalvesEndAsTheWhole) {
  const Path folder = EmptyTestFolder();
  const auto lines = LinesOf(SmallSingleCsv());
  std::string first, second;
  for (size_t i = 0; i < lines.size(); ++i) (i < 250 ? first : second) += lines[i] + "\n";
  const Path state = folder / "state.json";
  const auto flags = And(kSmallFlags, Flag("state", state));
  RunToolBinaryOn(WriteTestFile(folder / "first.csv", first), "fathom_follow", flags);
  ASSERT_TRUE(std::filesystem::exists(state));
  const ToolRun halves =
      RunToolBinaryOn(WriteTestFile(folder / "second.csv", second), "fathom_follow", flags);
  const ToolRun whole = RunToolBinaryOn(
      WriteTestFile(folder / "whole.csv", first + second), "fathom_follow", kSmallFlags);
  ASSERT_EQ(halves.exit_code, 0) << halves.err;
  EXPECT_EQ(LinesOf(halves.out).back(), LinesOf(whole.out).back());
  EXPECT_EQ(LinesOf(halves.out).size() + 249, LinesOf(whole.out).size());
}

TEST(FollowTool, KeepsWhatCameBeforeABadLine) {
  const Path folder = EmptyTestFolder();
  const Path state = folder / "state.json";
  const auto flags = And(kSmallFlags, Flag("state", state));
  const ToolRun bad =
      RunToolBinaryOn(WriteTestFile(folder / "bad.csv", "t,tau,v\n0,1,0\n0.1,1,0.02\n0.2,1,nan\n"),
                      "fathom_follow",
                      flags);
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_THAT(bad.err, HasSubstr("fathom_follow: stdin:4: column 'v' is 'nan', expected"));
  EXPECT_EQ(LinesOf(bad.out).size(), 3u);
  EXPECT_EQ(JsonOf(state)["num_samples"], 2);
  const Path back = WriteTestFile(folder / "back.csv", "0.1,1,0.02\n");
  const ToolRun again = RunToolBinaryOn(back, "fathom_follow", flags);
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.err,
              HasSubstr("stdin: holds no sample behind the last one of " + state.string()));
}

TEST(FollowTool, GoesOnWhereAStreamBeginsAnew) {
  const Path folder = EmptyTestFolder();
  const auto lines = LinesOf(SmallSingleCsv());
  std::string first, all;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (i < 250) first += lines[i] + "\n";
    all += lines[i] + "\n";
  }
  const auto flags = And(kSmallFlags, Flag("state", folder / "state.json"));
  RunToolBinaryOn(WriteTestFile(folder / "first.csv", first), "fathom_follow", flags);
  const Path whole = WriteTestFile(folder / "all.csv", all);
  const ToolRun anew = RunToolBinaryOn(whole, "fathom_follow", flags);
  const ToolRun at_once = RunToolBinaryOn(whole, "fathom_follow", kSmallFlags);
  ASSERT_EQ(anew.exit_code, 0) << anew.err;
  EXPECT_EQ(LinesOf(anew.out).back(), LinesOf(at_once.out).back());
  EXPECT_THAT(anew.err, HasSubstr("stdin: 249 samples passed over, up to the last one of "));
}

TEST(FollowTool, RefusesAnotherStreamThanThatOfItsState) {
  const Path folder = EmptyTestFolder();
  const auto flags = And(kSmallFlags, Flag("state", folder / "state.json"));
  RunToolBinaryOn(WriteTestFile(folder / "a.csv", "0,1,0\n0.1,1,0.02\n"), "fathom_follow", flags);
  const Path other = WriteTestFile(folder / "b.csv", "0,1,0\n0.07,1,0.02\n0.14,1,0.03\n");
  const ToolRun run = RunToolBinaryOn(other, "fathom_follow", flags);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("stdin:3: t = 0.14 comes without a line 0.1,1,0.02 before it"));
}

TEST(FollowTool, WritesItsStateOnTheWay) {
  const Path folder = EmptyTestFolder();
  // It diverges behind the third sample: the state of the second is the last one that is good.
  const Path csv = WriteTestFile(folder / "run.csv", "0,1e9,0\n1,1e9,1e9\n2,1e9,0\n3,1e9,0\n");
  const Path state = folder / "state.json";
  const ToolRun run = RunToolBinaryOn(csv,
                                      "fathom_follow",
                                      {"--dof=surge",
                                       "--gains=-1e150,1e150,1e150,1e150,1e150",
                                       "--integrator=euler",
                                       "--state_every=1",
                                       Flag("state", state)});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("no usable model: The adaptive law diverged at t = "));
  EXPECT_GE(JsonOf(state)["num_samples"].get<int>(), 1);
}

// While the stream goes on, the page loads itself again; behind its end it stands still.
TEST(FollowTool, WritesAPageThatGrows) {
  const Path folder = EmptyTestFolder();
  const Path csv = WriteTestFile(folder / "run.csv", SmallSingleCsv());
  const Path page = folder / "follow.html";
  ChildCommand bash;
  bash.program = "bash";
  bash.arguments = {"-c",
                    "csv=$1; page=$2; shift 2; (cat $csv; for i in $(seq 100); do [ -e $page ] && "
                    "break; sleep 0.1; done; cp $page $page.growing) | \"$@\"",
                    "bash",
                    csv.string(),
                    page.string(),
                    std::string(FATHOM_TOOLS_DIR) + "/fathom_follow",
                    "--page=" + page.string(),
                    "--page_every=0.5"};
  bash.arguments.insert(bash.arguments.end(), kSmallFlags.begin(), kSmallFlags.end());
  RunChild(bash);
  EXPECT_THAT(TextOf(page.string() + ".growing"), HasSubstr("<main data-reload=\"0.5\">"));
  const std::string text = TextOf(page);
  EXPECT_THAT(text, HasSubstr("<main>"));
  EXPECT_THAT(text, HasSubstr("601 samples, t = 0 s to 60 s"));
  EXPECT_THAT(text, HasSubstr("The last estimate is usable. Behind "));
  EXPECT_THAT(text, HasSubstr("\"low\":["));
}

// A line that is refused ends the stream as well.
TEST(FollowTool, ShowsOnItsPageWhatCameBeforeABadLine) {
  const Path folder = EmptyTestFolder();
  const Path page = folder / "follow.html";
  const ToolRun bad =
      RunToolBinaryOn(WriteTestFile(folder / "bad.csv", "t,tau,v\n0,1,0\n0.1,1,0.02\n0.2,1,nan\n"),
                      "fathom_follow",
                      And(kSmallFlags, Flag("page", page)));
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_THAT(TextOf(page), HasSubstr("2 samples, t = 0 s to 0.1 s"));
  EXPECT_THAT(TextOf(page), HasSubstr("there are fewer than ten samples"));
  EXPECT_THAT(TextOf(page), HasSubstr("<main>"));
  const ToolRun never =
      RunToolBinaryOn(folder / "bad.csv", "fathom_follow", And(kSmallFlags, "--page_every=0"));
  EXPECT_EQ(never.exit_code, 1);
  EXPECT_THAT(never.err, HasSubstr("--page_every: is 0, expected more than 0 s"));
}

TEST(FollowTool, RefusesWhatItCannotUse) {
  const Path folder = EmptyTestFolder();
  const Path csv = WriteTestFile(folder / "run.csv", "0,1,0\n");
  const auto refusal = [&](const std::vector<std::string>& flags) {
    const ToolRun run = RunToolBinaryOn(csv, "fathom_follow", flags);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "");
    return run.err;
  };
  EXPECT_THAT(refusal({"--dof=surge"}), HasSubstr("fathom_follow: --gains: is missing, expected"));
  EXPECT_THAT(refusal({kSmallFlags[1]}), HasSubstr("fathom_follow: --dof: is missing, expected"));
  EXPECT_THAT(refusal({"--dof=surge", "--gains=0.2,1,1,1,1"}),
              HasSubstr("--gains: a_m is 0.2, expected a number below 0."));
  EXPECT_THAT(refusal(And(kSmallFlags, "--state_every=0")),
              HasSubstr("--state_every: is 0, expected at least 1 sample."));
  const Path state = WriteTestFile(folder / "state.json", "{");
  EXPECT_THAT(refusal(And(kSmallFlags, Flag("state", state))),
              HasSubstr("state.json: is not JSON"));
}

TEST(FollowTool, SaysThatAStreamIsEmptyOrTooShort) {
  const Path folder = EmptyTestFolder();
  const ToolRun empty = RunToolBinaryOn(
      WriteTestFile(folder / "empty.csv", "t,tau,v\n"), "fathom_follow", kSmallFlags);
  EXPECT_EQ(empty.exit_code, 1);
  EXPECT_EQ(empty.err, "fathom_follow: stdin: holds no sample, expected lines t,tau,v.\n");
  const ToolRun brief =
      RunToolBinaryOn(WriteTestFile(folder / "brief.csv", "0,1,0\n"), "fathom_follow", kSmallFlags);
  EXPECT_EQ(brief.exit_code, 2);
  EXPECT_EQ(brief.err, "fathom_follow: no usable model: There are fewer than ten samples.\n");
}

}  // namespace
}  // namespace fathom
