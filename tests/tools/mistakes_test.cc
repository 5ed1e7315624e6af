// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The table of mistakes of docs/findings.md: what every tool says first.

#include "mistakes.h"

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "filmed_minute.h"
#include "run_tool.h"
#include "saved_files.h"
#include "sound_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Path = std::filesystem::path;

// What a mistake leaves nothing of in the data of one log.
const std::string kUnseen;

struct Case {
  std::string name;
  std::function<void(LogNumbers*)> make;
  std::string found;          // in the first line of identify, compare and diagnose
  std::string on_simulation;  // the same of simulate, by a model of the sound log
  bool is_slow = false;       // of SlowSoundLog()
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

const std::string kBelow = "below the vehicle's dry mass of 22.5 kg. Would explain it: ";
const std::string kOver = "times the vehicle's dry mass of 22.5 kg. Would explain it: ";
const std::string kDiffers = "The prediction does not follow the speed of this log: ";

const std::string kDiverges = "The prediction of this log diverges or is too stiff.";

Case SeenByAll(const std::string& name,
               const std::function<void(LogNumbers*)>& make,
               const std::string& found) {
  return {name, make, found, found};
}

std::vector<Case> Cases() {
  const auto force = [](double factor) {
    return [=](LogNumbers* log) { ScaleForce(factor, log); };
  };
  const auto speed = [](double factor) {
    return [=](LogNumbers* log) { ScaleSpeed(factor, log); };
  };
  const auto thrusters = [](double unit) {
    return [=](LogNumbers* log) { log->thruster_speed_unit = unit; };
  };
  const double to_knots = 1.94384;
  return {
      {"ForceInKilonewton", force(1e-3), kBelow + "forces in kN", kDiffers},
      {"ThrusterSpeedInRpm", thrusters(60.0), kOver + "thruster speeds in rpm", kDiverges},
      {"ThrusterSpeedInRadians", thrusters(6.28319), kOver + "thruster speeds in rad/s", kDiffers},
      SeenByAll("FastInCentimetres", speed(100.0), "The speed reaches "),
      {"SlowInCentimetres", speed(100.0), kBelow + "motion in cm", kDiffers, /*is_slow=*/true},
      {"SpeedInKnots", speed(to_knots), kBelow + "speeds in knots", kDiffers},
      // 38 kg / 1.94 are more than the mass: water that is taken along would explain it as well.
      {"KnotsOfALightVehicle",
       [=](LogNumbers* log) {
         ScaleSpeed(to_knots, log);
         log->mass = 15.0;
       },
       kUnseen,
       kDiffers},
      // 2.5 * 38 kg are 4.2 masses: a factor of the force is one of all parameters.
      {"PerCentOf40N", force(100.0 / 40.0), kUnseen, kDiffers},
      {"PerCentOf20N", force(100.0 / 20.0), "times the vehicle's dry mass of 22.5 kg.", kDiffers},
      SeenByAll("PulseWidths", WritePulseWidths, "The command lies between "),
      SeenByAll("LostLock", LoseLock, "velocity.csv: u is exactly 0 in "),
      SeenByAll("StuckSensor", GetStuck, "velocity.csv: u stands still in "),
      SeenByAll("Sentinel", WriteSentinels, "velocity.csv: u is exactly -32.768 in "),
      SeenByAll("HeldSamples", HoldSamples, "velocity.csv: u has a new value only every 2 s"),
      SeenByAll("RepeatedBlock", RepeatABlock, "velocity.csv: u holds the same 300 rows twice"),
      SeenByAll("AccelerationAsSpeed",
                WriteAccelerations,
                "At equal velocity a positive force decelerates the vehicle"),
      SeenByAll("FlippedSign", speed(-1.0), "The mean power of force times velocity"),
  };
}

class Mistakes : public ::testing::TestWithParam<Case> {};

LogNumbers SoundLogOf(const Path& folder, bool is_slow) {
  return is_slow ? SlowSoundLog(folder) : SoundLog(folder);
}

std::string ModelOf(const Path& sound, const Path& file) {
  RunsWell("fathom_identify", {Flag("log", sound), Flag("model", file)});
  return file.string();
}

std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

void ExpectFirst(const std::string& tool,
                 const std::vector<std::string>& flags,
                 const std::string& found) {
  const ToolRun run = RunToolBinary(tool, flags);
  if (found == kUnseen) {
    EXPECT_THAT(run.err, Not(HasSubstr("WARNING: "))) << tool;
  } else {
    EXPECT_THAT(FirstLine(run.err), AllOf(StartsWith("WARNING: "), HasSubstr(found))) << tool;
  }
}

TEST_P(Mistakes, AreSaidFirst) {
  const Path folder = EmptyTestFolder();
  LogNumbers numbers = SoundLogOf(folder, GetParam().is_slow);
  const std::string model = ModelOf(Write(numbers, folder / "sound"), folder / "model.json");
  GetParam().make(&numbers);
  const std::string log = "--log=" + Write(numbers, folder / "mistaken").string();
  for (const char* tool : {"fathom_identify", "fathom_compare", "fathom_diagnose"}) {
    ExpectFirst(tool, {log}, GetParam().found);
  }
  ExpectFirst("fathom_simulate", {"--model=" + model, log}, GetParam().on_simulation);
}

INSTANTIATE_TEST_SUITE_P(Cases, Mistakes, ::testing::ValuesIn(Cases()), [](const auto& info) {
  return info.param.name;
});

class SoundLogs : public ::testing::TestWithParam<bool> {};

// A model of a sound log, and the log by its thrusters.
TEST_P(SoundLogs, AreNotWarnedOf) {
  const Path folder = EmptyTestFolder();
  LogNumbers numbers = SoundLogOf(folder, GetParam());
  const std::string model = ModelOf(Write(numbers, folder / "forces"), folder / "model.json");
  numbers.thruster_speed_unit = 1.0;
  Write(numbers, folder / "thrusters");
  for (const char* name : {"forces", "thrusters"}) {
    const std::string log = Flag("log", folder / name);
    for (const char* tool : {"fathom_identify", "fathom_compare", "fathom_diagnose"}) {
      ExpectFirst(tool, {log}, kUnseen);
    }
    ExpectFirst("fathom_simulate", {"--model=" + model, log}, kUnseen);
  }
}

INSTANTIATE_TEST_SUITE_P(FastAndSlow, SoundLogs, ::testing::Bool());

// Corners need no velocity.csv, but a score does, and a model its force.
TEST(MistakesOnFilm, AreSaidFirstByRefine) {
  const Path folder = EmptyTestFolder();
  const Path log = SynthesizeMinute(folder / "log", "wall.yaml", 40.0, 1);
  WriteTestFile(log / "log.yaml", TextOf(log / "log.yaml") + "mass: 274\n");
  const std::vector<std::string> flags = {Flag("log", log), "--dof=surge"};
  ExpectFirst("fathom_refine", flags, kUnseen);

  const CsvColumns command = ReadColumns(log / "command.csv");
  const std::vector<double> time = command.Values("t"), force = command.Values("tau_surge");
  std::string in_kilonewton = "t,tau_surge\n";
  for (std::size_t i = 0; i < time.size(); ++i) {
    in_kilonewton += std::to_string(time[i]) + "," + std::to_string(force[i] / 1000.0) + "\n";
  }
  WriteTestFile(log / "command.csv", in_kilonewton);
  ExpectFirst("fathom_refine", flags, "below the vehicle's dry mass of 274 kg.");
}

}  // namespace
}  // namespace fathom
