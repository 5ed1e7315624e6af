// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The map that is suggested for a telemetry log, and the log that it makes.

#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/suggest_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <numbers>
#include <optional>
#include <string>

#include "scratch_file.h"
#include "tlog_writer.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using namespace tlog;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const char kVehicle[] =
    "name: two\nmass: 20\nsize: [1, 1, 1]\n"
    "thrust_tables:\n  - {name: T, source: us, command: us, voltages: [12, 16], "
    "thrust: [[1100, -30, -40], [1500, 0, 0], [1900, 38, 50]]}\n"
    "thrusters:\n"
    "  - {name: port, position: [0, -0.5, 0], direction: [1, 0, 0], thrust_table: T}\n"
    "  - {name: starboard, position: [0, 0.5, 0], direction: [1, 0, 0], thrust_table: T}\n";

std::string Setting(const std::string& name, float value, int system = 1, int component = 1) {
  std::string payload = Bytes(value) + Bytes<std::uint16_t>(888) + Bytes<std::uint16_t>(1) + name;
  payload.resize(24, '\0');
  return Packet2(1600000000000000, 22, payload + '\x09', 220, system, component);
}

const std::string kSettings = Setting("SERVO1_FUNCTION", 33.0F) +
                              Setting("SERVO2_FUNCTION", 34.0F) + Setting("MOT_1_DIRECTION", 1.0F) +
                              Setting("MOT_2_DIRECTION", 1.0F);

// Heads east and moves east at 2 m/s: 2 m/s ahead. The port thruster drives every other time.
std::string Dive(int millivolts = 14000, const std::string& settings = kSettings) {
  std::string bytes = settings;
  for (int i = 0; i < 20; ++i) {
    const std::uint64_t time = 1600000000000000 + 250000 * i;
    const auto half_turn = static_cast<float>(std::numbers::pi / 2);
    const std::string boot = Bytes<std::uint32_t>(250 * i);
    std::string servos = boot + Bytes(static_cast<std::uint16_t>(1500 + i % 2 * 400)) +
                         Bytes<std::uint16_t>(1500) + std::string(13, '\0');
    bytes += Packet2(time, 36, servos, 222);
    bytes += Packet2(time,
                     1,
                     std::string(14, '\0') + Bytes(static_cast<std::uint16_t>(millivolts)) +
                         std::string(15, '\0'),
                     124);
    bytes += Packet2(time,
                     32,
                     boot + Bytes(3.0F) + Bytes(0.5F * i) + Bytes(5.0F) + Bytes(0.0F) +
                         Bytes(2.0F) + Bytes(0.0F),
                     185);
    bytes += Packet2(time,
                     30,
                     boot + Bytes(0.0F) + Bytes(0.0F) + Bytes(half_turn) + Bytes(0.01F) +
                         Bytes(0.02F) + Bytes(0.03F),
                     39);
  }
  return bytes;
}

TEST(TlogMap, TakesOutputsAndTheMotionOfTheEkf) {
  const auto file = ScratchFile("dive.tlog", Dive());
  const auto recording = OpenRecording(file);
  const SuggestedMap without = SuggestMap(*recording, {});
  EXPECT_TRUE(without.needs_vehicle);
  EXPECT_THAT(without.text,
              AllOf(HasSubstr("thruster_2: servo2_raw"), Not(HasSubstr("thruster_3"))));
  const Vehicle vehicle = ParseVehicleFile("v.yaml", kVehicle);
  const SuggestedMap map = SuggestMap(*recording, vehicle);
  ASSERT_TRUE(map.is_ready) << map.text;
  const ImportedLog imported =
      ImportLog(file, *recording, ParseImportMap("map.yaml", map.text), vehicle);
  // At 14 V full command is half way from 38 to 50 N.
  EXPECT_DOUBLE_EQ(imported.log.command->Find("tau_surge")->at(3), 44.0);
  EXPECT_DOUBLE_EQ(imported.log.command->Find("tau_yaw")->at(3), 22.0);
  EXPECT_NEAR(imported.log.velocity->Find("u")->at(3), 2.0, 1e-6);
  EXPECT_NEAR(imported.log.velocity->Find("v")->at(3), 0.0, 1e-6);
  EXPECT_NEAR(imported.log.velocity->Find("r")->at(3), 0.03, 1e-6);
  EXPECT_NEAR(imported.log.pose->Find("y")->at(3), 1.5, 1e-6);
}

// The settings of another system, and of another component of this one, are not this autopilot's.
TEST(TlogMap, TakesOutputsAndDirectionsFromTheSettingsThatItHeard) {
  const std::string swapped =
      Setting("SERVO1_FUNCTION", 34.0F) + Setting("SERVO2_FUNCTION", 33.0F) +
      Setting("MOT_1_DIRECTION", 1.0F) + Setting("MOT_2_DIRECTION", -1.0F) +
      Setting("SERVO1_FUNCTION", 33.0F, 2) + Setting("SERVO1_FUNCTION", 33.0F, 1, 100);
  const auto file = ScratchFile("dive.tlog", Dive(14000, swapped));
  const auto recording = OpenRecording(file);
  const Vehicle vehicle = ParseVehicleFile("v.yaml", kVehicle);
  const SuggestedMap map = SuggestMap(*recording, vehicle);
  ASSERT_TRUE(map.is_ready) << map.text;
  EXPECT_THAT(map.text,
              AllOf(HasSubstr("  thruster_1: servo2_raw  # SERVO2_FUNCTION is 33\n"),
                    HasSubstr("  thruster_2: {field: servo1_raw, reversed: true}")));
  // Full pulse to the reversed starboard thruster: full astern, half way from -30 to -40 N.
  const ImportedLog imported =
      ImportLog(file, *recording, ParseImportMap("map.yaml", map.text), vehicle);
  EXPECT_DOUBLE_EQ(imported.log.command->Find("tau_surge")->at(3), -35.0);
  EXPECT_DOUBLE_EQ(imported.log.command->Find("tau_yaw")->at(3), 17.5);
}

TEST(TlogMap, SaysFirstThatItIsNotReadyWhereItHeardNoSettings) {
  const SuggestedMap map = SuggestMap(*OpenRecording(ScratchFile("dive.tlog", Dive(14000, ""))),
                                      ParseVehicleFile("v.yaml", kVehicle));
  EXPECT_FALSE(map.is_ready);
  EXPECT_THAT(map.text, StartsWith("# Not ready: which output drives which motor is not known"));
}

// Seconds since the autopilot was switched on are no date.
TEST(TlogMap, SaysWhenALogBeganOnlyByItsOwnStamps) {
  const auto file = ScratchFile("dive.tlog", Dive());
  const auto recording = OpenRecording(file);
  const auto start = [&](const char* time) {
    const std::string map = fmt::format(
        "dof: surge\nvelocity: {{channel: LOCAL_POSITION_NED, {}u: vx, v: vy, w: vz}}\n", time);
    return ImportLog(file, *recording, ParseImportMap("map.yaml", map), std::nullopt).log.start;
  };
  EXPECT_EQ(start(""), 1600000000.0);
  EXPECT_EQ(start("time: time_boot_ms, "), std::nullopt);
}

TEST(TlogMap, TakesNoVoltageThatIsNotMeasured) {
  for (const int millivolts : {0, 65535}) {
    const auto recording = OpenRecording(ScratchFile("dive.tlog", Dive(millivolts)));
    EXPECT_THAT(SuggestMap(*recording, {}).text, HasSubstr("voltage: 16  # the log measures none"));
  }
}

TEST(TlogMap, IsNotReadyWithoutOutputs) {
  std::string bytes;
  for (int i = 0; i < 3; ++i) bytes += Attitude(1600000000000000 + i, 0.0F);
  const SuggestedMap map = SuggestMap(*OpenRecording(ScratchFile("dive.tlog", bytes)),
                                      ParseVehicleFile("v.yaml", kVehicle));
  EXPECT_FALSE(map.is_ready);
  EXPECT_THAT(map.text,
              AllOf(HasSubstr("no thruster outputs"), HasSubstr("the log has no motion")));
}

}  // namespace
}  // namespace fathom
