// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What fathom_check says of logs with a typical mistake.

#include <algorithm>
#include <cmath>
#include <ostream>

#include "checked_dive.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;
using Path = std::filesystem::path;

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
       "stands at its limit of 14 N for"},
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

}  // namespace
}  // namespace fathom
