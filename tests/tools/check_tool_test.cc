// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What fathom_check says of one log.

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "checked_dive.h"
#include "expect_refusal.h"
#include "saved_files.h"
#include "turn_without_command.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;
using Path = std::filesystem::path;

TEST_F(CheckTool, SaysOfALogWithoutACommandThatItIsAFreeDecay) {
  std::string text = "t,v\n";
  for (int i = 0; i < 300; ++i) {
    const double t = 0.05 * i;
    const double v = 0.7 * std::exp(-0.3 * t) + 0.002 * std::sin(40.0 * t);
    text += std::to_string(t) + "," + std::to_string(v) + "\n";
  }
  const std::string csv = WriteTestFile(EmptyTestFolder() / "decay.csv", text).string();
  const ToolRun run = RunsWell("fathom_check", {"--log=" + csv, "--dof=yaw"});
  EXPECT_THAT(run.out, HasSubstr("yellow  free_decay        There is no command, so that this is"));
  EXPECT_THAT(run.out, HasSubstr("next: fathom_identify --log=" + csv + " --dof=yaw"));
}

TEST_F(CheckTool, AsksForNoInertiaThatTheVehicleFileTells) {
  const Path log = EmptyTestFolder() / "turn";
  std::filesystem::create_directories(log);
  const Path csv = TurnWithoutCommand(log, /*decays=*/true);
  std::string text = TextOf(csv);
  text.replace(text.find("t,v"), 3, "t,r");
  WriteTestFile(log / "velocity.csv", text);
  WriteTestFile(log / "log.yaml", "name: turn\ndof: yaw\nvehicle: rov.yaml\n");
  const auto check = [&](const std::string& vehicle) {
    WriteTestFile(log / "rov.yaml", vehicle);
    return RunsWell("fathom_check", {Flag("log", log)}).out;
  };
  EXPECT_THAT(check("name: rov\n"),
              AllOf(HasSubstr("the damping of yaw by the inertia."), HasSubstr("Give `inertia`")));
  EXPECT_THAT(check("name: rov\ninertia: {yaw: 5.45}\n"),
              AllOf(HasSubstr("the damping of yaw.\n"), Not(HasSubstr("Give `inertia`"))));
}

TEST_F(CheckTool, IsGreenOnSoundLogs) {
  for (const bool is_slow : {false, true}) {
    const Path own = folder_ / (is_slow ? "slow" : "fast");
    std::filesystem::create_directories(own);
    Dive dive = SoundDive(own, is_slow);
    dive.has_pose = true;
    const Said said = Check(WriteDive(dive, own / "log"), own);
    EXPECT_EQ(said.exit_code, 0) << said.text;
    for (const Json& finding : said.findings) EXPECT_EQ(finding["severity"], "yellow") << finding;
  }
}

TEST_F(CheckTool, SaysWhatToDoAndWritesAPage) {
  ScaleSpeed(-1.0, &dive_.numbers);
  const Path page = folder_ / "check.html";
  const ToolRun run =
      RunToolBinary("fathom_check",
                    {"--log=" + WriteDive(dive_, folder_ / "log").string(), Flag("report", page)});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.out, HasSubstr("To do: Check sign and frame of command and motion"));
  EXPECT_THAT(TextOf(page), HasSubstr("Check sign and frame of command and motion"));
}

// A mass of a thousand times the true one: a log of forces is not told of thruster speeds, and the
// reverse.
TEST_F(CheckTool, NamesTheMassAndNoUnitThatALogLacks) {
  dive_.numbers.mass = 3e4;
  const Said of_forces = Check(WriteDive(dive_, folder_ / "forces"), folder_);
  EXPECT_THAT(of_forces.text, AllOf(HasSubstr("forces in kN"), HasSubstr("a wrong `mass`")));
  dive_.numbers.thruster_speed_unit = 1.0;
  const Said of_thrusters = Check(WriteDive(dive_, folder_ / "thrusters"), folder_);
  EXPECT_THAT(of_thrusters.text, AllOf(Not(HasSubstr("kN")), HasSubstr("a wrong `mass`")));
}

// A slow sine: a delay turns the response like damping against inertia.
TEST_F(CheckTool, DoesNotCallWellKnownWhatADelayMayChange) {
  Driven([](double t, double) { return std::sin(0.2 * t); })(&dive_);
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0.0, 0.01);
  for (double& speed : dive_.numbers.speed) speed += noise(generator);
  const Said said = Check(WriteDive(dive_, folder_ / "log"), folder_);
  EXPECT_THAT(
      said.text,
      AllOf(HasSubstr("note: This log cannot separate inertia, damping and a command delay"),
            HasSubstr("known: with an unknown delay of the command, the 95 % interval")));
  const Json dof = Json::parse(TextOf(folder_ / "check.json"))["dofs"][0];
  EXPECT_THAT(dof["caveats"].dump(), HasSubstr("With an unknown delay the inertia is known to"));
  EXPECT_EQ(dof["parameters"][0]["name"], "inertia");
  EXPECT_EQ(dof["parameters"][0]["known"], "roughly");
}

// A swell that no force explains.
TEST_F(CheckTool, SaysThatTheModelFitsPoorly) {
  Driven([](double t, double) { return Tones(t); })(&dive_);
  for (std::size_t i = 0; i < dive_.numbers.speed.size(); ++i) {
    dive_.numbers.speed[i] += 0.3 * std::sin(0.9 * dive_.numbers.time[i]);
  }
  const Said said = Check(WriteDive(dive_, folder_ / "log"), folder_);
  EXPECT_THAT(said.text,
              AllOf(HasSubstr("A model of surge from this log fits poorly"),
                    ContainsRegex("yellow  poor_fit +Simulated from the command alone, the model "
                                  "misses [0-9]+ % of the motion\\."),
                    HasSubstr("Then run fathom_diagnose"),
                    Not(HasSubstr("note: The fit is poor")),
                    Not(HasSubstr("note: Simulated"))));
}

TEST_F(CheckTool, SaysOnceThatNoMassIsKnown) {
  const Path log = WriteDive(dive_, folder_ / "log");
  const auto note = HasSubstr("note: No mass of the vehicle is known");
  const Said with_mass = Check(log, folder_);
  EXPECT_THAT(with_mass.text, Not(note));
  WriteTestFile(log / "log.yaml", "name: dive\ndof: surge\n");
  const Said said = Check(log, folder_);
  EXPECT_THAT(said.text, AllOf(note, HasSubstr("(dry, in kg) to log.yaml.")));
  EXPECT_EQ(said.findings, with_mass.findings);
  WriteTestFile(log / "log.yaml", "name: dive\ndof: surge\ncommand_unit: A\n");
  EXPECT_THAT(Check(log, folder_).text, Not(note));
}

TEST_F(CheckTool, SaysWhatToDoNextAndWhatTheColoursMean) {
  const auto run_on = [&](const Path& log) {
    const Path page = folder_ / "check.html";
    const std::string out =
        RunToolBinary("fathom_check", {Flag("log", log), Flag("report", page)}).out;
    EXPECT_THAT(TextOf(page), HasSubstr("Red: no model of this log should be believed before"));
    return std::pair{out, TextOf(page)};
  };
  const Path sound = WriteDive(dive_, folder_ / "sound");
  const std::string next =
      "fathom_identify --log=" + sound.string() + " --dof=surge --model=surge.json";
  const auto [out, page] = run_on(sound);
  EXPECT_THAT(out, HasSubstr("\nnext: " + next + "\n"));
  EXPECT_THAT(page, HasSubstr("Next: " + next));
  ScaleSpeed(-1.0, &dive_.numbers);
  const Path flipped = WriteDive(dive_, folder_ / "flipped");
  const auto [red_out, red_page] = run_on(flipped);
  const std::string mend = "mend what is red, then fathom_check --log=" + flipped.string();
  EXPECT_THAT(red_out, HasSubstr("\nnext: " + mend + "\n"));
  EXPECT_THAT(red_page, AllOf(HasSubstr("Next: " + mend), HasSubstr("Red: The mean power")));
}

// The place of the first finding with this code; null if it has none.
Json PlaceOf(const Said& said, const std::string& code) {
  const auto found = std::ranges::find_if(
      said.findings, [&](const Json& finding) { return finding["code"] == code; });
  return found == said.findings.end() ? Json() : found->value("where", Json());
}

// Of mistakes that were made in known rows: rows 300 to 599, 10 Hz, and rows 600 to 899 are copies.
TEST_F(CheckTool, SaysWhereAMistakeIs) {
  const Dive& sound = dive_;
  const std::vector<double>& time = sound.numbers.time;
  Dive stuck = sound;
  std::fill_n(stuck.numbers.speed.begin() + 300, 300, stuck.numbers.speed[300]);
  const Json where = PlaceOf(Check(WriteDive(stuck, folder_ / "stuck"), folder_), "stuck_values");
  EXPECT_EQ(where["file"], "velocity.csv");
  EXPECT_EQ(where["axis"], "u");
  EXPECT_NEAR(where["from"].get<double>(), time[300], 1e-3);
  EXPECT_NEAR(where["to"].get<double>(), time[599], 1e-3);

  Dive jumps = sound;
  Pose([](Dive* dive, std::size_t i) { dive->yaw[i] = i < 700 ? 0.0 : 0.4; })(&jumps);
  const Json jump = PlaceOf(Check(WriteDive(jumps, folder_ / "jumps"), folder_), "pose_jump");
  EXPECT_EQ(jump["axis"], "yaw");
  EXPECT_NEAR(jump["from"].get<double>(), time[699], 1e-3);
  EXPECT_NEAR(jump["to"].get<double>(), time[700], 1e-3);

  Dive clipped = sound;
  Driven([](double t, double) { return t > 40.0 && t < 70.0 ? 30.0 : Tones(t); })(&clipped);
  const Json limit =
      PlaceOf(Check(WriteDive(clipped, folder_ / "clipped"), folder_), "clipped_command");
  EXPECT_EQ(limit["file"], "command.csv");
  EXPECT_NEAR(limit["from"].get<double>(), 40.0, 0.21);  // two rows
  EXPECT_NEAR(limit["to"].get<double>(), 70.0, 0.21);

  Dive flipped = sound;
  ScaleForce(-1.0, &flipped.numbers);
  EXPECT_TRUE(
      PlaceOf(Check(WriteDive(flipped, folder_ / "flipped"), folder_), "passivity").is_null());
}

TEST_F(CheckTool, DrawsAFindingAtItsPlace) {
  std::fill_n(dive_.numbers.speed.begin() + 300, 300, dive_.numbers.speed[300]);
  Later(3.0)(&dive_);
  const Path page = folder_ / "check.html";
  RunToolBinary("fathom_check",
                {"--log=" + WriteDive(dive_, folder_ / "log").string(), Flag("report", page)});
  const std::string html = TextOf(page);
  EXPECT_THAT(html, HasSubstr("<h2>surge: stuck values</h2>"));
  EXPECT_THAT(html, HasSubstr("\"name\":\"the finding\""));
  EXPECT_THAT(html, HasSubstr("<h2>surge: command delay</h2>"));
  EXPECT_THAT(html, HasSubstr("correlation with the command"));
}

TEST_F(CheckTool, DrawsTwoMotionsThatAreNotOne) {
  Pose([](Dive* dive, std::size_t i) { dive->x[i] *= 2.0; })(&dive_);
  const Path page = folder_ / "check.html";
  RunToolBinary("fathom_check",
                {"--log=" + WriteDive(dive_, folder_ / "log").string(), Flag("report", page)});
  const std::string html = TextOf(page);
  EXPECT_THAT(html, HasSubstr("<h2>log: pose twist scale</h2>"));
  EXPECT_THAT(html, HasSubstr("from pose.csv, along the vehicle"));
}

TEST_F(CheckTool, TellsHowToNameALog) {
  EXPECT_EQ(ExpectRefusal("fathom_check", {folder_.string()}),
            "fathom_check: a log needs its flag, expected --log=" + folder_.string() +
                ". See fathom_check --help.\n");
}

TEST_F(CheckTool, SaysFirstWhatStaysUnknown) {
  Driven([](double t, double) { return 0.01 * Tones(t); })(&dive_);
  const Said said = Check(WriteDive(dive_, folder_ / "log"), folder_);
  EXPECT_THAT(said.text,
              ContainsRegex("Nothing speaks against a model of surge from this log, but it leaves "
                            "quadratic_damping( and linear_damping)? unknown\\."));
}

// Two lines of its help gave two meanings of 2.
TEST_F(CheckTool, SaysOneThingOfItsExitCodes) {
  const std::string help = RunToolBinary("fathom_check", {"--help"}).out;
  EXPECT_THAT(help, HasSubstr("2: a finding is red."));
  EXPECT_THAT(help, Not(HasSubstr("no usable fit")));
}

// Every step that is named can be taken.
TEST_F(CheckTool, SaysHowASingleCsvGetsAMass) {
  std::string text = "t,tau,v\n";
  double v = 0.0;
  for (int i = 0; i < 1500; ++i) {
    const double force = Tones(0.1 * i);
    text += fmt::format("{:.1f},{:.4f},{:.5f}\n", 0.1 * i, force, v);
    v += 0.1 * (force - 40.0 * v * std::abs(v) - 8.0 * v) / 38.0;
  }
  const Path csv = folder_ / "run.csv", map = folder_ / "map.yaml", log = folder_ / "run";
  WriteTestFile(csv, text);
  const std::string from = Flag("from", csv);
  const ToolRun run = RunToolBinary("fathom_check", {Flag("log", csv), "--dof=surge"});
  EXPECT_THAT(run.out,
              AllOf(ContainsRegex("that it has not seen, add --held_out=[0-9.]+:[0-9.]+\n"),
                    HasSubstr("fathom_import " + from + " --suggest > map.yaml, add `mass:`"),
                    HasSubstr("fathom_import " + from + " --map=map.yaml --out=run.")));
  WriteTestFile(map, RunToolBinary("fathom_import", {from, "--suggest"}).out + "mass: 22.5\n");
  RunsWell("fathom_import", {from, Flag("map", map), Flag("out", log)});
  const ToolRun with_mass = RunsWell("fathom_check", {Flag("log", log)});
  EXPECT_THAT(with_mass.out, Not(HasSubstr("No mass of the vehicle is known")));
}

}  // namespace
}  // namespace fathom
