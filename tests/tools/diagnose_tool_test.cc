// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/log/log.h"
#include "fathom/log/read_log.h"

#include <cstdlib>
#include <filesystem>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "bundled_data.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include "synthesized_log.h"
#include "turn_without_command.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Path = std::filesystem::path;

ToolRun Diagnosed(const Path& log, std::vector<std::string> arguments = {}) {
  arguments.insert(arguments.begin(), Flag("log", log));
  return RunToolBinary("fathom_diagnose", arguments);
}

TEST(DiagnoseTool, HelpGivesFlagsAnExampleAndExitCodes) {
  const ToolRun run = RunsWell("fathom_diagnose", {"--help"});
  EXPECT_EQ(run.err, "");
  for (const char* flag :
       {"--log", "--dof", "--verdict", "--report", "--false_alarm_rate (default 0.05)", "--seed"}) {
    EXPECT_THAT(run.out, HasSubstr(flag));
  }
  EXPECT_THAT(
      run.out,
      AllOf(HasSubstr("fathom_diagnose --log=data/flatfish --dof=surge"),
            HasSubstr("--log=A,B"),
            HasSubstr("Exit code 0: a usable result; 1: input or flags cannot be used; 2")));
}

// What is found in it, and how well: known_causes_test.cc.
TEST(DiagnoseTool, NamesAnEightNewtonDeadZoneInFlatfishSurge) {
  const Path folder = EmptyTestFolder();
  const Path log = Synthesized(kData + "/vehicles/flatfish.yaml",
                               kData + "/experiments/surge_multisine.yaml",
                               "thrust_dead_zone:width=8",
                               1,
                               folder / "log");
  const Path verdict = folder / "verdict.json", report = folder / "page.html";
  const ToolRun run =
      RunsWell(Diagnosed(log, {"--dof=surge", Flag("verdict", verdict), Flag("report", report)}));
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, StartsWith("surge: explained\n"));
  EXPECT_THAT(run.out, HasSubstr("\nevidence (BIC): what the fit gains, "));

  const auto json = JsonOf(verdict);
  EXPECT_EQ(json["schema"], "fathom-verdict-1");
  EXPECT_EQ(json["log"], "surge_multisine");
  EXPECT_EQ(json["verdict"], "explained");
  ASSERT_EQ(json["causes"].size(), 1u);
  const auto& cause = json["causes"][0];
  EXPECT_EQ(cause["effect"], "thrust_dead_zone");
  EXPECT_EQ(cause["place"], "actuator");
  EXPECT_EQ(cause["alternatives"], nlohmann::json::array());
  EXPECT_EQ(cause["parameters"]["width"]["unit"], "N");

  // What the causes are the candidates say, too; those they cannot be told from are not kept.
  for (const auto& candidate : json["candidates"]) {
    EXPECT_EQ(candidate["kept"], candidate["label"] == "thrust_dead_zone") << candidate;
    EXPECT_NE(candidate["why"], "");
  }

  // The tool prints the sentence, and the page opens with it, the effect in words.
  const std::string sentence = json["sentence"];
  EXPECT_THAT(sentence, HasSubstr(" comes from a thruster dead zone (thrust_dead_zone), width "));
  EXPECT_THAT(run.out, HasSubstr("\n" + sentence + "\n"));
  std::string in_words = sentence.substr(0, sentence.find(". "));
  const std::string name = "thrust_dead_zone";
  in_words.replace(in_words.find(name), name.size(), "thrust dead zone");
  EXPECT_THAT(TextOf(report), HasSubstr(in_words));
}

// The speed forgets where it started from within m / d_L = 8 s: a minute in, the run that the
// diagnosis fitted and the one that fathom_simulate starts from the first measured speed differ by
// exp(-60 / 8) of some 0.01 m/s, 6e-6 m/s.
TEST(DiagnoseTool, ItsVerdictPredictsAnotherLogAsTheDiagnosisDoes) {
  const Path folder = EmptyTestFolder();
  const std::string lag = "thruster_lag:time_constant=0.8";
  const std::vector<Path> logs = {SmallLogWith(folder, "first", lag, 1),
                                  SmallLogWith(folder, "second", lag, 2)};
  const Path verdict = folder / "verdict.json", prediction = folder / "prediction.csv";
  RunsWell(Diagnosed(logs[0], {Flag("verdict", verdict)}));
  RunsWell("fathom_simulate",
           {Flag("model", verdict), Flag("log", logs[0]), Flag("out", prediction)});

  const Log log = ReadLog(logs[0]);
  const Diagnosis diagnosis = Diagnose(std::span<const Log>(&log, 1), Dof::kSurge);
  ASSERT_FALSE(diagnosis.traces.empty());
  const ResidualTrace& trace = diagnosis.traces.front();
  const CsvColumns predicted = ReadColumns(prediction);
  const std::vector<double> time = predicted.Values("t"), u = predicted.Values("u");
  std::size_t at = 0;
  int num_compared = 0;
  for (std::size_t i = 0; i < trace.time.size(); ++i) {
    if (trace.time[i] < 60.0) continue;
    while (at < time.size() && time[at] < trace.time[i] - 1e-9) ++at;
    ASSERT_LT(at, time.size());
    ASSERT_NEAR(time[at], trace.time[i], 1e-9);
    EXPECT_NEAR(u[at], trace.after[i], 2e-5) << time[at];
    ++num_compared;
  }
  EXPECT_GT(num_compared, 90);

  // A log that it has never seen: down to the noise of 0.005 m/s, 0.8 of which is the mean of its
  // size; the same without the cause misses by more.
  const auto miss = [&](const Path& model) {
    const ToolRun other = RunsWell("fathom_simulate", {Flag("model", model), Flag("log", logs[1])});
    return NumberBehind("MAE ", other.out);
  };
  const Path baseline = folder / "baseline.json";
  RunsWell("fathom_identify", {Flag("log", logs[0]), Flag("model", baseline)});
  EXPECT_LT(miss(verdict), 0.0055);
  EXPECT_GT(miss(baseline), 2.0 * miss(verdict));
}

TEST(DiagnoseTool, SaysThatNothingIsMissing) {
  const Path folder = EmptyTestFolder();
  const Path log = SmallLogWith(folder, "log", "", 3);
  const Path verdict = folder / "verdict.json";
  const ToolRun run = RunsWell(Diagnosed(log, {Flag("verdict", verdict)}));
  EXPECT_THAT(run.out,
              StartsWith("surge: consistent\nThis log shows no error of your surge model beyond "
                         "noise."));
  EXPECT_EQ(JsonOf(verdict)["causes"], nlohmann::json::array());
  // Noise of 5 mm/s is all that is left, so its NMAE is that of the model, to the chance in 200
  // samples.
  const double nmae = JsonOf(verdict)["baseline"]["heldout_nmae"];
  EXPECT_NEAR(JsonOf(verdict)["noise_nmae"].get<double>(), nmae, 0.2 * nmae);
  EXPECT_THAT(run.out, HasSubstr("\nnoise alone (the scatter from sample to sample) gives a "));
  // The candidates in a sentence, the limits in a table with one.
  EXPECT_THAT(run.out, HasSubstr("\n\nNo candidate passes, of "));
  EXPECT_THAT(run.out, Not(HasSubstr("\np-value: ")));
  EXPECT_THAT(run.out, HasSubstr("or a higher saturation. Effects of several parameters"));
  EXPECT_THAT(run.out, HasSubstr("\neffect not named "));
  RunsWell("fathom_simulate", {Flag("model", verdict), Flag("log", log)});
}

// Its simulation by Euler's method is 0.02 % of the motion off, which no noise covers here.
TEST(DiagnoseTool, LooksForNothingWhereTheModelLeavesLessThanAThousandthOfTheMotion) {
  const ToolRun run = RunsWell(Diagnosed(WriteSmallLog(EmptyTestFolder() / "log")));
  EXPECT_THAT(run.out, StartsWith("surge: consistent\n"));
  EXPECT_THAT(run.out, HasSubstr(" % of the motion. Below 0.1 % no cause is searched."));
}

TEST(DiagnoseTool, TakesSeveralLogsTogetherEitherWay) {
  const Path folder = EmptyTestFolder();
  const std::string first = SmallLogWith(folder, "first", "", 1).string();
  const std::string second = SmallLogWith(folder, "second", "", 2).string();
  const ToolRun with_commas = RunToolBinary("fathom_diagnose", {"--log=" + first + "," + second});
  const ToolRun repeated = RunToolBinary("fathom_diagnose", {"--log=" + first, "--log=" + second});
  ASSERT_EQ(with_commas.exit_code, 0) << with_commas.err;
  EXPECT_EQ(with_commas.out, repeated.out);
  EXPECT_THAT(with_commas.out, HasSubstr("\nThese 2 logs show"));
}

TEST(DiagnoseTool, SaysThatTheCommandEndsBeforeTheMotion) {
  const Path log = SmallLogWith(EmptyTestFolder(), "log", "", 1);
  const std::string command = TextOf(log / "command.csv");
  WriteTestFile(log / "command.csv", command.substr(0, command.find("\n55,") + 1));
  EXPECT_THAT(Diagnosed(log).out, HasSubstr(" s before the motion; its last value is held."));
}

TEST(DiagnoseTool, TellsLogsOfOneNameApart) {
  const Path folder = EmptyTestFolder();
  const std::string first = SmallLogWith(folder, "first", "", 1).string();
  const std::string second = SmallLogWith(folder, "second", "", 2).string();
  const std::string yaml = TextOf(Path(first) / "log.yaml");
  ASSERT_EQ(yaml, TextOf(Path(second) / "log.yaml"));
  const Path report = folder / "page.html";
  RunsWell("fathom_diagnose", {"--log=" + first, "--log=" + second, Flag("report", report)});
  const std::string page = TextOf(report);
  EXPECT_THAT(page,
              AllOf(HasSubstr("small_multisine (first)"), HasSubstr("small_multisine (second)")));
}

// A jump of one log is named of that log, and fathom_simulate has it there alone.
TEST(DiagnoseTool, NamesTheLogThatACauseBelongsTo) {
  const Path folder = EmptyTestFolder();
  const std::string jump = "buoyancy_step:jump=6:time=30";
  const Path jumped = SmallLogWith(folder, "jumped", jump, 1);
  const Path clean = SmallLogWith(folder, "clean", "", 2);
  WriteTestFile(jumped / "log.yaml", "name: jumped\ndof: surge\nheld_out: [70, 90]\n");
  WriteTestFile(clean / "log.yaml", "name: clean\ndof: surge\nheld_out: [70, 90]\n");
  const Path verdict = folder / "verdict.json";
  const ToolRun run = RunsWell(Diagnosed(clean, {Flag("log", jumped), Flag("verdict", verdict)}));
  EXPECT_THAT(run.out, StartsWith("surge: explained\n"));
  EXPECT_THAT(run.out, HasSubstr("(buoyancy_step(jumped)), jump "));
  EXPECT_THAT(run.out, HasSubstr("buoyancy_step(jumped) holds for jumped only"));
  const auto json = JsonOf(verdict);
  ASSERT_EQ(json["causes"].size(), 1u);
  EXPECT_EQ(json["causes"][0]["effect"], "buoyancy_step");
  EXPECT_NEAR(json["causes"][0]["parameters"]["jump"]["value"].get<double>(), 6.0, 0.05);
  EXPECT_EQ(json["causes"][0]["log"], "jumped");
  EXPECT_EQ(json["logs"], nlohmann::json({"clean", "jumped"}));

  const std::string note = "left out: buoyancy_step(jumped)";
  for (const Path& log : {clean, jumped, SmallLogWith(folder, "third", jump, 3)}) {
    const ToolRun simulated =
        RunsWell("fathom_simulate", {Flag("model", verdict), Flag("log", log)});
    const bool has_it = log == jumped;
    EXPECT_EQ(simulated.out.find(note) == std::string::npos, has_it) << simulated.out;
    // Noise of 0.005 m/s, 0.8 of which is the mean of its size; a jump that is missing shows.
    const double miss = NumberBehind("MAE ", simulated.out);
    if (log == jumped || log == clean) {
      EXPECT_LT(miss, 0.006) << log;
    } else {
      EXPECT_GT(miss, 0.012);
    }
  }
  const ToolRun kept =
      RunToolBinary("fathom_simulate",
                    {Flag("model", verdict), Flag("log", folder / "third"), "--keep_run_effects"});
  EXPECT_LT(NumberBehind("MAE ", kept.out), 0.006);
}

TEST(DiagnoseTool, TheSameLogGivesTheSameBytes) {
  const Path folder = EmptyTestFolder();
  const Path log = SmallLogWith(folder, "log", "steady_current:speed=0.05", 4);
  std::vector<std::string> outputs, verdicts, pages;
  // A page says when it was made, and by which command.
  setenv("SOURCE_DATE_EPOCH", "1500000000", 1);
  for (int i = 0; i < 2; ++i) {
    const Path out = folder / "out";
    outputs.push_back(
        Diagnosed(log, {Flag("verdict", out / "verdict.json"), Flag("report", out / "page.html")})
            .out);
    verdicts.push_back(TextOf(out / "verdict.json"));
    pages.push_back(TextOf(out / "page.html"));
  }
  unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_FALSE(verdicts[0].empty());
  EXPECT_FALSE(pages[0].empty());
  EXPECT_EQ(outputs[0], outputs[1]);
  EXPECT_EQ(verdicts[0], verdicts[1]);
  EXPECT_EQ(pages[0], pages[1]);
}

// Down to the fewest samples that can be trained on: no noise can be learned from them.
TEST(DiagnoseTool, AFewSecondsEndWithExitCodeTwo) {
  for (const int count : {20, 30, 59}) {
    SCOPED_TRACE(count);
    const Path folder = EmptyTestFolder();
    const Path log = WriteSmallLog(folder / "log");
    std::istringstream all(SmallVelocityCsv());
    std::string line, few;
    for (int i = 0; i <= count && std::getline(all, line); ++i) few += line + "\n";
    WriteTestFile(log / "velocity.csv", few);
    WriteTestFile(log / "command.csv", "t,tau_surge\n0,20\n0.5,-20\n1,20\n");
    const ToolRun run = Diagnosed(log, {});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr("samples (at 10 Hz at most), expected at least 60"));
  }
}

// Nothing was commanded and nothing moved: no model, no verdict, and a page that says so.
TEST(DiagnoseTool, AVehicleAtRestEndsWithExitCodeTwoAndAPageThatSaysWhy) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteStillLog(folder / "log");
  const Path page = folder / "page.html";
  const ToolRun run =
      Diagnosed(log, {Flag("verdict", folder / "verdict.json"), Flag("report", page)});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err,
            "WARNING: The force is constant at 0 N. The log cannot determine a model.\n"
            "WARNING: The velocity is constant at 0 m/s. The log cannot determine a model.\n"
            "fathom_diagnose: no diagnosis: The force is constant at 0 N. The log cannot determine "
            "a model.\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "verdict.json"));
  EXPECT_THAT(TextOf(page), HasSubstr("There is no diagnosis: The force is constant at 0 N."));
}

// The thrusters never answer: nothing that moves depends on the inertia.
TEST(DiagnoseTool, ACommandThatMovesNothingEndsWithExitCodeTwo) {
  const Path folder = EmptyTestFolder();
  const Path log = Synthesized(kData + "/vehicles/flatfish.yaml",
                               kData + "/experiments/surge_multisine.yaml",
                               "thrust_dead_zone:width=1000",
                               1,
                               folder / "log");
  const Path verdict = folder / "verdict.json";
  const ToolRun run = Diagnosed(log, {Flag("verdict", verdict)});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("these logs do not determine the inertia"));
  EXPECT_FALSE(std::filesystem::exists(verdict));
}

TEST(DiagnoseTool, TellsTheRatiosOfAFreeDecay) {
  const Path turn = TurnWithoutCommand(EmptyTestFolder(), true);
  const Path verdict = turn.parent_path() / "decay.json", page = turn.parent_path() / "decay.html";
  const ToolRun run =
      RunsWell(Diagnosed(turn, {"--dof=yaw", Flag("verdict", verdict), Flag("report", page)}));
  EXPECT_THAT(run.out, StartsWith("Nothing drives yaw"));
  const auto decay = JsonOf(verdict);
  EXPECT_NEAR(decay["parameters"]["linear_damping / inertia"]["value"], 0.2, 0.01);
  EXPECT_NEAR(decay["parameters"]["quadratic_damping / inertia"]["value"], 0.48, 0.02);
  EXPECT_TRUE(std::filesystem::exists(page));
}

TEST(DiagnoseTool, EndsWithExitCodeTwoWhereNothingDrivesAndNothingDecays) {
  const ToolRun run = Diagnosed(TurnWithoutCommand(EmptyTestFolder(), false), {"--dof=yaw"});
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_THAT(run.err, HasSubstr("no diagnosis"));
}

}  // namespace
}  // namespace fathom
