// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What fathom_check says of logs with a typical mistake, and of sound ones.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "expect_refusal.h"
#include "mistakes.h"
#include "real_data.h"
#include "run_tool.h"
#include "saved_files.h"
#include "sound_log.h"
#include "synthesized_log.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;
namespace fs = std::filesystem;
using Path = fs::path;

// A log of one DOF with the poses that belong to it: the vehicle goes straight on along x.
struct Dive {
  LogNumbers numbers;
  bool has_pose = false;
  std::vector<double> x, y, yaw;  // of pose.csv, at numbers.time
};

Dive SoundDive(const Path& scratch, bool is_slow) {
  Dive dive;
  dive.numbers = is_slow ? SlowSoundLog(scratch) : SoundLog(scratch);
  double x = 0.0;
  for (std::size_t i = 0; i < dive.numbers.time.size(); ++i) {
    if (i > 0) {
      x += 0.5 * (dive.numbers.speed[i] + dive.numbers.speed[i - 1]) *
           (dive.numbers.time[i] - dive.numbers.time[i - 1]);
    }
    dive.x.push_back(x);
    dive.y.push_back(0.0);
    dive.yaw.push_back(0.0);
  }
  return dive;
}

Path WriteDive(const Dive& dive, const Path& folder) {
  Write(dive.numbers, folder);
  if (!dive.has_pose) return folder;
  std::string pose = "t,x,y,z,qx,qy,qz,qw\n";
  for (std::size_t i = 0; i < dive.x.size(); ++i) {
    pose += fmt::format("{},{:.7g},{:.7g},0,0,0,{:.9f},{:.9f}\n",
                        dive.numbers.time[i],
                        dive.x[i],
                        dive.y[i],
                        std::sin(0.5 * dive.yaw[i]),
                        std::cos(0.5 * dive.yaw[i]));
  }
  WriteTestFile(folder / "pose.csv", pose);
  return folder;
}

// What the tool says: {severity, code, sentence} of each finding, and why DOFs are left out.
struct Said {
  int exit_code = -1;
  std::vector<Json> findings;
  std::string why_not;
  std::string text;
};

Said Check(const Path& log, const Path& scratch) {
  const Path file = scratch / "check.json";
  const ToolRun run = RunToolBinary("fathom_check", {Flag("log", log), Flag("json", file)});
  Said said = {run.exit_code, {}, "", run.out + run.err};
  if (run.exit_code != 0 && run.exit_code != 2) return said;
  const Json json = Json::parse(TextOf(file));
  for (const Json& finding : json["findings"]) said.findings.push_back(finding);
  for (const Json& dof : json["dofs"]) {
    for (const Json& finding : dof["findings"]) said.findings.push_back(finding);
    said.why_not += dof["why_not"].get<std::string>();
  }
  return said;
}

struct Mistake {
  std::string name;
  std::function<void(Dive*)> make;
  // "red", "yellow"; "left out": the DOF cannot be identified; "refused": the log cannot be read
  std::string severity;
  std::string code;   // of the finding; of "left out" and "refused" a part of the reason
  std::string words;  // in its sentence
  bool is_slow = false;
};

void PrintTo(const Mistake& one, std::ostream* out) { *out << one.name; }

std::function<void(Dive*)> Force(double factor) {
  return [=](Dive* dive) { ScaleForce(factor, &dive->numbers); };
}

std::function<void(Dive*)> Speed(double factor) {
  return [=](Dive* dive) { ScaleSpeed(factor, &dive->numbers); };
}

std::function<void(Dive*)> Numbers(void (*make)(LogNumbers*)) {
  return [=](Dive* dive) { make(&dive->numbers); };
}

std::function<void(Dive*)> Later(double seconds) {
  return [=](Dive* dive) {
    for (double& t : dive->numbers.time) t += seconds;
  };
}

std::function<void(Dive*)> Pose(const std::function<void(Dive*, std::size_t)>& change) {
  return [=](Dive* dive) {
    dive->has_pose = true;
    for (std::size_t i = 0; i < dive->x.size(); ++i) change(dive, i);
  };
}

// The first seconds of the log.
std::function<void(Dive*)> Cut(double seconds) {
  return [=](Dive* dive) {
    LogNumbers& log = dive->numbers;
    const auto keep = [&](std::vector<double>* time, std::vector<double>* values) {
      const auto end = std::upper_bound(time->begin(), time->end(), seconds);
      values->resize(static_cast<std::size_t>(end - time->begin()));
      time->erase(end, time->end());
    };
    keep(&log.command_time, &log.force);
    keep(&log.time, &log.speed);
  };
}

// What the vehicle does under another command, by the model that the sound log comes of.
void Drive(LogNumbers* log, const std::function<double(double, double)>& force) {
  double v = 0.0;
  std::size_t row = 0;
  const std::vector<double> noise = log->speed;  // its last digits are as good as noise
  log->force.clear();
  log->command_time.clear();
  for (double t = 0.0; t < 150.0; t += 0.1) {
    const double measured = v + 0.002 * std::sin(1e4 * noise[std::min(row, noise.size() - 1)]);
    const double f = force(t, measured);
    log->command_time.push_back(t);
    log->force.push_back(f);
    while (row < log->time.size() && log->time[row] < t + 0.1) {
      log->speed[row++] = measured;
    }
    v += 0.1 * (f - 40.0 * v * std::abs(v) - 8.0 * v + 0.3) / 38.0;
  }
}

std::function<void(Dive*)> Driven(const std::function<double(double, double)>& force) {
  return [=](Dive* dive) { Drive(&dive->numbers, force); };
}

double Tones(double t) {
  return 12.0 * std::sin(0.6 * t) + 9.0 * std::sin(1.7 * t + 1.0) + 7.0 * std::sin(4.1 * t);
}

std::vector<Mistake> Table() {
  const std::string below = "below the vehicle's dry mass of 22.5 kg";
  const std::string over = "times the vehicle's dry mass of 22.5 kg";
  return {
      {"ForceInKilonewton", Force(1e-3), "red", "inertia", "forces in kN"},
      {"ForceInKilogramForce", Force(1.0 / 9.80665), "red", "inertia", "kgf"},
      {"ForceInPounds", Force(1.0 / 4.44822), "red", "inertia", "lbf"},
      {"ThrusterSpeedInRpm",
       [](Dive* dive) { dive->numbers.thruster_speed_unit = 60.0; },
       "red",
       "inertia",
       "rpm"},
      {"ThrusterSpeedInRadians",
       [](Dive* dive) { dive->numbers.thruster_speed_unit = 6.28319; },
       "red",
       "inertia",
       "rad/s"},
      {"FastInCentimetres", Speed(100.0), "red", "speed_range", "The speed reaches "},
      {"SlowInCentimetres", Speed(100.0), "red", "inertia", "motion in cm", /*is_slow=*/true},
      {"SlowInMillimetres", Speed(1000.0), "red", "inertia", below, /*is_slow=*/true},
      {"SpeedInKnots", Speed(1.94384), "red", "inertia", "knots"},
      {"SpeedInKilometresPerHour", Speed(3.6), "red", "inertia", "km/h"},
      {"SpeedInFeet", Speed(3.28084), "red", "inertia", "feet"},
      {"PerCentOf20N", Force(5.0), "red", "inertia", over},
      {"PulseWidths", Numbers(WritePulseWidths), "red", "pulse_widths", "Are these pulse widths"},
      {"MassOfAnotherVehicle",
       [](Dive* dive) { dive->numbers.mass = 500.0; },
       "red",
       "inertia",
       "below the vehicle's dry mass of 500 kg"},
      {"FlippedForce", Force(-1.0), "red", "passivity", "The mean power"},
      {"FlippedSpeed", Speed(-1.0), "red", "passivity", "The mean power"},
      {"AccelerationAsSpeed", Numbers(WriteAccelerations), "red", "force_sign", "decelerates"},
      {"LostLock", Numbers(LoseLock), "red", "lost_values", "u is exactly 0 in "},
      {"StuckSensor", Numbers(GetStuck), "red", "stuck_values", "u stands still in "},
      {"Sentinel", Numbers(WriteSentinels), "red", "sentinel", "u is exactly -32.768 in "},
      {"SentinelOfNines",
       [](Dive* dive) {
         for (std::size_t i = 40; i < dive->numbers.speed.size(); i += 300) {
           dive->numbers.speed[i] = 999.0;
         }
       },
       "red",
       "sentinel",
       "u is exactly 999 in "},
      {"HeldSamples", Numbers(HoldSamples), "red", "held_samples", "only every 2 s"},
      {"RepeatedBlock", Numbers(RepeatABlock), "red", "repeated_block", "the same 300 rows twice"},
      {"ClockThreeSecondsLate", Later(3.0), "red", "command_delay", "s after the command"},
      {"ClockThreeSecondsEarly", Later(-3.0), "red", "command_delay", "s before the command"},
      {"ClockEightSecondsLate", Later(8.0), "red", "command_delay", "s after the command"},
      {"ClockSixTenthsLate", Later(0.6), "yellow", "command_delay", "s after the command"},
      {"StampsInMilliseconds",
       [](Dive* dive) {
         for (double& t : dive->numbers.time) t *= 1000.0;
         for (double& t : dive->numbers.command_time) t *= 1000.0;
       },
       "refused",
       "Is it in ms",
       ""},
      {"ConstantCommand",
       Driven([](double, double) { return 10.0; }),
       "left out",
       "the command never changes",
       ""},
      {"VehicleAtRest", Speed(0.0), "left out", "at rest", ""},
      {"CutAfterTwoSeconds", Cut(2.0), "left out", "too short", ""},
      {"CutAfterTwentySeconds", Cut(20.0), "yellow", "short_log", "s of motion"},
      {"OneStep",
       Driven([](double t, double) { return t < 60.0 ? 5.0 : 20.0; }),
       "yellow",
       "few_changes",
       "changes once"},
      {"Clipped",
       Driven([](double t, double) { return std::clamp(Tones(t), -14.0, 14.0); }),
       "yellow",
       "clipped_command",
       "stands at its limit of 14"},
      {"ClosedLoop",
       Driven([](double t, double v) { return 60.0 * (0.5 * std::sin(0.3 * t) - v); }),
       "yellow",
       "closed_loop",
       "A controller was on"},
      {"SensorPaused",
       [](Dive* dive) {
         LogNumbers& log = dive->numbers;
         log.time.erase(log.time.begin() + 500, log.time.begin() + 600);
         log.speed.erase(log.speed.begin() + 500, log.speed.begin() + 600);
       },
       "yellow",
       "gap",
       "gap"},
      {"StampsOfArrival",
       [](Dive* dive) {
         for (std::size_t i = 0; i < dive->numbers.time.size(); i += 7) {
           dive->numbers.time[i] += 0.045;
         }
       },
       "yellow",
       "jitter",
       "steps differ by over 30 %"},
      {"PoseOfTheOtherAxis",
       Pose([](Dive* dive, std::size_t i) { dive->x[i] *= -1.0; }),
       "red",
       "pose_twist_sign",
       "opposite signs"},
      {"MarkerOfTwiceTheSize",
       Pose([](Dive* dive, std::size_t i) { dive->x[i] *= 2.0; }),
       "red",
       "pose_twist_scale",
       "u"},
      {"PoseLate",
       [](Dive* dive) {
         dive->has_pose = true;
         std::rotate(dive->x.begin(), dive->x.end() - 5, dive->x.end());
         std::fill_n(dive->x.begin(), 5, dive->x[5]);
       },
       "yellow",
       "pose_twist_delay",
       "s later"},
      {"EstimatorRealigned",
       Pose([](Dive* dive, std::size_t i) { dive->x[i] += i < 700 ? 0.0 : 1.2; }),
       "red",
       "pose_jump",
       "x jumps once"},
      {"PoseFreezes",
       Pose([](Dive* dive, std::size_t i) {
         if (i > 700 && i < 760) dive->x[i] = dive->x[700];
       }),
       "red",
       "stuck_values",
       "pose.csv: x stands still"},
      {"YawRealigned",
       Pose([](Dive* dive, std::size_t i) { dive->yaw[i] = i < 700 ? 0.0 : 0.4; }),
       "red",
       "pose_jump",
       "yaw jumps once"},
      {"HeadingFlips",
       Pose([](Dive* dive, std::size_t i) { dive->yaw[i] = i == 700 || i == 701 ? 1.6 : 0.0; }),
       "yellow",
       "pose_flip",
       "turns away and back once, first by 92°"},
      {"VelocitiesOverGround",
       [](Dive* dive) {
         dive->has_pose = true;
         const std::vector<double>& time = dive->numbers.time;
         const std::vector<double>& speed = dive->numbers.speed;
         double x = 0.0, y = 0.0;
         for (std::size_t i = 0; i < time.size(); ++i) {
           const double step = i > 0 ? time[i] - time[i - 1] : 0.0;
           dive->yaw[i] = 0.1 * time[i];
           x += step * speed[i] * std::cos(dive->yaw[i]);
           y += step * speed[i] * std::sin(dive->yaw[i]);
           dive->x[i] = x;
           dive->y[i] = y;
         }
         for (std::size_t i = 0; i < time.size(); ++i) {
           dive->numbers.speed[i] *= std::cos(dive->yaw[i]);
         }
       },
       "red",
       "pose_twist_frame",
       "u is along the axes of the world"},
  };
}

class CheckedMistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(CheckedMistakes, AreSaidWithTheirWords) {
  const Mistake& mistake = GetParam();
  const Path folder = EmptyTestFolder();
  Dive dive = SoundDive(folder, mistake.is_slow);
  mistake.make(&dive);
  const Said said = Check(WriteDive(dive, folder / "log"), folder);
  if (mistake.severity == "left out") {
    EXPECT_THAT(said.why_not, HasSubstr(mistake.code)) << said.text;
    return;
  }
  if (mistake.severity == "refused") {
    EXPECT_EQ(said.exit_code, 1);
    EXPECT_THAT(said.text, HasSubstr(mistake.code));
    return;
  }
  const bool is_said = std::ranges::any_of(said.findings, [&](const Json& finding) {
    return finding["severity"] == mistake.severity && finding["code"] == mistake.code &&
           finding["sentence"].get<std::string>().find(mistake.words) != std::string::npos;
  });
  EXPECT_TRUE(is_said) << said.text;
  EXPECT_TRUE(mistake.severity != "red" || said.exit_code == 2);
}

INSTANTIATE_TEST_SUITE_P(Table,
                         CheckedMistakes,
                         ::testing::ValuesIn(Table()),
                         [](const auto& info) { return info.param.name; });

class CheckTool : public ::testing::Test {
 protected:
  const Path folder_ = EmptyTestFolder();
  Dive dive_ = SoundDive(folder_, false);
};

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

TEST_F(CheckTool, IsGreenOnSoundLogs) {
  for (const bool is_slow : {false, true}) {
    const Path own = folder_ / (is_slow ? "slow" : "fast");
    fs::create_directories(own);
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
  Drive(&dive_.numbers, [](double t, double) { return std::sin(0.2 * t); });
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
  Drive(&dive_.numbers, [](double t, double) { return Tones(t); });
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

TEST_F(CheckTool, ListsAnArchive) {
  WriteDive(dive_, folder_ / "archive/sound");
  LoseLock(&dive_.numbers);
  WriteDive(dive_, folder_ / "archive/lost");
  WriteTestFile(folder_ / "archive/broken/log.yaml", "name: [\n");
  const ToolRun run = RunToolBinary("fathom_check", {Flag("archive", folder_ / "archive")});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_THAT(run.out, HasSubstr("lost_values"));
  EXPECT_THAT(run.out, ContainsRegex("\nbroken is not readable: .*log.yaml:2: "));
  EXPECT_THAT(run.out, ContainsRegex("sound +surge +- +-\n"));
}

TEST_F(CheckTool, RefusesAnArchiveWithoutLogs) {
  fs::create_directories(folder_ / "archive/dive");
  EXPECT_THAT(ExpectRefusal("fathom_check", {Flag("archive", folder_ / "archive")}, folder_),
              HasSubstr("archive: holds no log (it is empty), expected"));
}

TEST_F(CheckTool, TellsHowToNameALog) {
  const ToolRun run = RunToolBinary("fathom_check", {folder_.string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err,
            "fathom_check: a log needs its flag, expected --log=" + folder_.string() +
                ". See fathom_check --help.\n");
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

TEST_F(CheckTool, SaysFirstWhatStaysUnknown) {
  Drive(&dive_.numbers, [](double t, double) { return 0.01 * Tones(t); });
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

using CheckedRealLogs = OnRealData;

TEST_F(CheckedRealLogs, AreKnownAsWellAsFathomIdentifyKnowsThem) {
  const Path folder = EmptyTestFolder();
  const std::string log = Flag("log", Path(folder_) / "kingfisher_runs/run_20");
  const Path json = folder / "check.json", model = folder / "model.json";
  RunToolBinary("fathom_check", {log, "--dof=surge", Flag("json", json)});
  RunToolBinary("fathom_identify", {log, "--dof=surge", Flag("model", model)});
  const Json identified = JsonOf(model);
  const Json checked = JsonOf(json)["dofs"][0]["parameters"];
  ASSERT_EQ(checked.size(), 4u);
  for (const Json& parameter : checked) {
    const Json& same = identified["parameters"][parameter["name"].get<std::string>()];
    EXPECT_EQ(parameter["value"], same["value"]) << parameter;
    EXPECT_EQ(parameter["std"], same["std"]) << parameter;
  }
}

// A camera whose stamps are wrong is told once, and no axis for it.
TEST_F(CheckedRealLogs, TellACameraThatIsLate) {
  const Path folder = EmptyTestFolder();
  const Path log = folder / "log";
  fs::copy(Path(folder_) / "camera_by_others/heave_a", log);
  std::string shifted;
  std::istringstream rows(TextOf(log / "detections.csv"));
  for (std::string row; std::getline(rows, row);) {
    const auto comma = row.find(',');
    if (shifted.empty()) {
      shifted = row + "\n";
    } else {
      shifted +=
          fmt::format("{:.6f}{}\n", std::stod(row.substr(0, comma)) + 2.3, row.substr(comma));
    }
  }
  fs::permissions(log / "detections.csv", fs::perms::owner_write, fs::perm_options::add);
  WriteTestFile(log / "detections.csv", shifted);
  const Said said = Check(log, folder);
  ASSERT_EQ(said.findings.size(), 1u) << said.text;
  EXPECT_EQ(said.findings[0]["code"], "camera_delay");
  EXPECT_THAT(said.findings[0]["sentence"].get<std::string>(), HasSubstr("2.30 s after"));
  const Path page = folder / "check.html";
  RunToolBinary("fathom_check", {Flag("log", log), Flag("report", page)});
  EXPECT_THAT(TextOf(page),
              AllOf(HasSubstr("<b>correlation with w of velocity.csv</b>"),
                    HasSubstr("the most, at 2.30 s")));
}

// Logs that others recorded and that are sound: none gets a red finding.
TEST_F(CheckedRealLogs, GetNoRedFinding) {
  const Path folder = EmptyTestFolder();
  std::vector<std::string> logs = {"lbv_surge",
                                   "lbv_surge_short",
                                   "pool_rov_surge",
                                   "emps_pulses_pose",
                                   "emps_pulses_velocity",
                                   "dc_motor_stairs",
                                   "camera_by_others/heave_a",
                                   "camera_by_others/heave_b",
                                   "camera_by_others/surge_sine",
                                   "kingfisher_runs/run_01",
                                   "kingfisher_runs/run_02",
                                   "kingfisher_runs/run_12",
                                   "kingfisher_runs/run_13",
                                   "kingfisher_runs/run_16",
                                   "kingfisher_runs/run_20",
                                   "kingfisher_runs/run_28",
                                   "kingfisher_runs/run_30"};
  for (const char* run : {"neg_0.04_1", "neg_0.045_2", "pos_0.06_3", "pos_0.065_1"}) {
    logs.push_back(std::string("hsm150_runs/") + run);
  }
  for (const std::string& log : logs) {
    SCOPED_TRACE(log);
    const Said said = Check(folder_ / log, folder);
    EXPECT_EQ(said.exit_code, 0) << said.text;
  }
}

}  // namespace
}  // namespace fathom
