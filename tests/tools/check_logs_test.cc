// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What fathom_check says of several logs, and of an archive.

#include "checked_dive.h"
#include "expect_refusal.h"
#include "saved_files.h"
#include "synthesized_log.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using Json = nlohmann::json;
namespace fs = std::filesystem;
using Path = fs::path;

TEST_F(CheckTool, ListsAnArchive) {
  WriteDive(dive_, folder_ / "archive/sound");
  LoseLock(&dive_.numbers);
  WriteDive(dive_, folder_ / "archive/lost");
  WriteTestFile(folder_ / "archive/broken/log.yaml", "name: [\n");
  const ToolRun run = RunToolBinary("fathom_check", {Flag("archive", folder_ / "archive")});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_THAT(run.out, HasSubstr("lost_values"));
  EXPECT_THAT(run.out, ContainsRegex("\nbroken cannot be read as a log: .*log.yaml:2: "));
  EXPECT_THAT(run.out, ContainsRegex("sound +surge +- +-\n"));
}

TEST_F(CheckTool, RefusesAnArchiveWithoutLogs) {
  fs::create_directories(folder_ / "archive/dive");
  EXPECT_THAT(ExpectRefusal("fathom_check", {Flag("archive", folder_ / "archive")}, folder_),
              HasSubstr("archive: holds no log (it is empty), expected"));
}

// The rows of a log from one stamp up to another; the stamps stay.
Dive PartOf(const Dive& dive, double from, double to) {
  Dive part = dive;
  const auto keep = [&](std::vector<double>* time, std::vector<double>* values) {
    std::vector<double> kept_time, kept;
    for (std::size_t i = 0; i < time->size(); ++i) {
      if ((*time)[i] < from || (*time)[i] >= to) continue;
      kept_time.push_back((*time)[i]);
      kept.push_back((*values)[i]);
    }
    *time = kept_time;
    *values = kept;
  };
  keep(&part.numbers.command_time, &part.numbers.force);
  keep(&part.numbers.time, &part.numbers.speed);
  return part;
}

// What fathom_check writes of several logs, and prints.
Json CheckSeveral(const std::vector<Path>& logs, const Path& scratch, std::string* text = nullptr) {
  const Path file = scratch / "several.json";
  std::vector<std::string> arguments = {Flag("json", file),
                                        Flag("report", scratch / "several.html")};
  for (const Path& log : logs) arguments.push_back(Flag("log", log));
  const ToolRun run = RunsWell("fathom_check", arguments);
  if (text != nullptr) *text = run.out;
  return Json::parse(TextOf(file));
}

TEST_F(CheckTool, SaysOfSeveralLogsWhatIsFoundAndLeftOut) {
  const Path sound = WriteDive(dive_, folder_ / "sound");
  dive_.numbers.time.erase(dive_.numbers.time.begin() + 500, dive_.numbers.time.begin() + 600);
  dive_.numbers.speed.erase(dive_.numbers.speed.begin() + 500, dive_.numbers.speed.begin() + 600);
  const Path paused = WriteDive(dive_, folder_ / "paused");
  WriteTestFile(paused / "log.yaml", "name: dive\ndof: [surge, heave]\nmass: 22.5\n");
  std::string text;
  const Json json = CheckSeveral({sound, paused}, folder_, &text);
  EXPECT_THAT(text, HasSubstr("yellow  gap               surge: 1 gap of over 5 steps"));
  const std::string left_out =
      "heave is not compared: that takes two logs that give a model of it. " + sound.string() +
      ": log.yaml does not name it. " + paused.string() + ": no command.";
  EXPECT_THAT(text, HasSubstr(left_out + "\n"));
  EXPECT_EQ(json["left_out"], Json::array({left_out}));
  const std::string page = TextOf(folder_ / "several.html");
  EXPECT_THAT(page, AllOf(HasSubstr("1 gap of over 5 steps"), HasSubstr("heave is not compared")));
}

// Information adds up: two pieces know together what the whole log knows.
TEST_F(CheckTool, SaysOfTwoPiecesWhatTheWholeLogKnows) {
  const Dive& whole = dive_;
  const Path first = WriteDive(PartOf(whole, 0.0, 50.0), folder_ / "first");
  const Path second = WriteDive(PartOf(whole, 50.0, 1e9), folder_ / "second");
  const Json parameters = CheckSeveral({first, second}, folder_)["dofs"][0]["parameters"];
  Check(WriteDive(whole, folder_ / "whole"), folder_);
  const Json of_whole = Json::parse(TextOf(folder_ / "check.json"))["dofs"][0]["parameters"];
  ASSERT_EQ(parameters.size(), 4u);
  for (std::size_t p = 0; p < 4; ++p) {
    SCOPED_TRACE(parameters[p]["name"]);
    // Each piece estimates its noise and its start anew.
    const double ratio = parameters[p]["std"].get<double>() / of_whole[p]["std"].get<double>();
    EXPECT_GT(ratio, 0.7);
    EXPECT_LT(ratio, 1.4);
    const Json& logs = parameters[p]["logs"];
    EXPECT_NEAR(logs[0]["share"].get<double>() + logs[1]["share"].get<double>(), 1.0, 1e-6);
    EXPECT_LT(logs[0]["share"], logs[1]["share"]);  // a third of the time
  }
}

TEST_F(CheckTool, SaysThatLogsOfOneVehicleDisagree) {
  const Path first = SmallLogWith(folder_, "first", "", 1),
             second = SmallLogWith(folder_, "second", "", 2);
  EXPECT_TRUE(CheckSeveral({first, second}, folder_)["dofs"][0]["disagreements"].empty());
  std::string heavier = SmallVehicleYaml();
  heavier.replace(heavier.find("inertia: 40"), 11, "inertia: 48");
  const Path loaded = SmallLogWith(folder_, "loaded", "", 3, heavier);
  const Json json = CheckSeveral({first, loaded}, folder_);
  EXPECT_THAT(json["verdict"].get<std::string>(), HasSubstr("but they disagree"));
  EXPECT_THAT(json["dofs"][0]["disagreements"][0].get<std::string>(),
              HasSubstr("disagree on the inertia in surge"));
}

// A log that never moves gives no model; two others weigh a fifth of what they move with.
TEST_F(CheckTool, AcquitsNoLogWithoutAModelAndTellsOfUnusualInertias) {
  std::vector<Path> logs;
  for (int seed = 1; seed < 4; ++seed) {
    logs.push_back(SmallLogWith(folder_, fmt::format("run_{}", seed), "", seed));
    WriteTestFile(logs.back() / "log.yaml", "name: run\ndof: surge\nmass: 9\n");
  }
  WriteTestFile(logs[2] / "log.yaml", "name: run\ndof: heave\nmass: 9\n");
  const std::string verdict = CheckSeveral(logs, folder_)["verdict"];
  EXPECT_THAT(verdict, HasSubstr("Nothing red speaks against 2 of 3 logs, but"));
  EXPECT_THAT(verdict, HasSubstr(logs[2].string() + " gives no model"));
  EXPECT_THAT(verdict, HasSubstr("the inertia in surge is 4.4 times the dry mass in 2 of 3 logs"));
}

// What it proposes to hold out of several logs leaves enough to identify.
TEST_F(CheckTool, ProposesWholeLogsToHoldOut) {
  const Dive& whole = dive_;
  std::vector<Path> logs;
  for (int k = 0; k < 3; ++k) {
    logs.push_back(WriteDive(PartOf(whole, 50.0 * k, 50.0 * (k + 1)), folder_ / std::to_string(k)));
  }
  std::string text;
  const Json held_out = CheckSeveral(logs, folder_, &text)["dofs"][0]["held_out"];
  ASSERT_EQ(held_out.size(), 1u) << text;
  const Path held = held_out[0]["log"].get<std::string>();
  const auto line = text.find("held_out: [");
  ASSERT_NE(line, std::string::npos) << text;
  WriteTestFile(held / "log.yaml",
                TextOf(held / "log.yaml") + text.substr(line, text.find('\n', line) - line) + "\n");
  std::vector<std::string> arguments = {"--dof=surge"};
  for (const Path& log : logs) arguments.push_back(Flag("log", log));
  const ToolRun run = RunsWell("fathom_identify", arguments);
  EXPECT_THAT(run.out, HasSubstr("held out")) << run.out;
}

}  // namespace
}  // namespace fathom
