// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Steering and throttle of ArduPilot's boats: the map that is suggested, and the log that it makes.

#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/suggest_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cstdint>
#include <optional>
#include <string>

#include "dataflash_writer.h"
#include "scratch_file.h"
#include "tlog_writer.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::DoubleEq;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr int kBoatParm = 64, kBoatRcou = 65;

std::string BoatParameter(const std::string& name, float value) {
  return dataflash::Message(
      kBoatParm,
      dataflash::Bytes<std::uint64_t>(0) + dataflash::Text(name, 16) + dataflash::Bytes(value));
}

// Output 1 steers, output 3 drives.
std::string BoatSettings(float steering_reversed = 0.0F, float throttle_reversed = 0.0F) {
  return BoatParameter("SERVO1_FUNCTION", 26.0F) + BoatParameter("SERVO1_MIN", 1100.0F) +
         BoatParameter("SERVO1_TRIM", 1450.0F) + BoatParameter("SERVO1_MAX", 1900.0F) +
         BoatParameter("SERVO1_REVERSED", steering_reversed) +
         BoatParameter("SERVO3_FUNCTION", 70.0F) + BoatParameter("SERVO3_MIN", 1100.0F) +
         BoatParameter("SERVO3_TRIM", 1520.0F) + BoatParameter("SERVO3_MAX", 1900.0F) +
         BoatParameter("SERVO3_REVERSED", throttle_reversed);
}

// Rudder: at rest, a half to the larger side, the least, beyond it, and off.
std::string BoatPulses() {
  const int rudder[] = {1450, 1675, 1100, 1000, 0}, throttle[] = {1520, 1620, 1620, 1620, 1620};
  std::string bytes;
  for (int i = 0; i < 5; ++i) {
    bytes += dataflash::Message(kBoatRcou,
                                dataflash::Bytes<std::uint64_t>(1000000 + 100000 * i) +
                                    dataflash::Bytes(static_cast<std::uint16_t>(rudder[i])) +
                                    dataflash::Bytes<std::uint16_t>(0) +
                                    dataflash::Bytes(static_cast<std::uint16_t>(throttle[i])));
  }
  return bytes;
}

std::filesystem::path BoatLog(const std::string& settings) {
  return ScratchFile("boat.BIN",
                     dataflash::Fmt(kBoatParm, 31, "PARM", "QNf", "TimeUS,Name,Value") +
                         dataflash::Fmt(kBoatRcou, 17, "RCOU", "QHHH", "TimeUS,C1,C2,C3") +
                         settings + BoatPulses());
}

// `axis`: of the rudder at the stern.
Vehicle Boat(const std::string& axis, const std::string& largest = ", largest_angle: 0.6") {
  return ParseVehicleFile(
      "boat.yaml",
      "name: boat\nmass: 20\nsize: [1, 1, 1]\n"
      "thrust_tables:\n  - {name: T, source: us, command: us, voltages: [16], "
      "thrust: [[1100, -40], [1500, 0], [1900, 40]]}\n"
      "thrusters:\n  - {name: screw, position: [-1, 0, 0], direction: [1, 0, 0], thrust_table: T}\n"
      "fins:\n  - {name: helm, position: [-1.2, 0, 0], axis: " +
          axis + largest + "}\n");
}

SuggestedMap MapOfBoat(const std::string& settings, const std::optional<Vehicle>& vehicle = {}) {
  return SuggestMap(*OpenRecording(BoatLog(settings)), vehicle);
}

ImportedLog ImportedBoat(const std::string& settings, const Vehicle& vehicle) {
  const auto file = BoatLog(settings);
  const auto recording = OpenRecording(file);
  const SuggestedMap map = SuggestMap(*recording, vehicle);
  return ImportLog(file, *recording, ParseImportMap("map.yaml", map.text), vehicle);
}

TEST(BoatMap, TakesSteeringForAFinAndThrottleForAThruster) {
  EXPECT_THAT(
      MapOfBoat(BoatSettings()).text,
      AllOf(StartsWith("dof: [surge, sway, yaw]\n"),
            HasSubstr("  thruster_1: C3  # SERVO3_FUNCTION is 70\n"),
            HasSubstr("  fin_rudder: {field: C1, pulses: [1100, 1450, 1900]}  # SERVO1_FUNCTION "
                      "is 26\n"),
            HasSubstr("axis up"),
            HasSubstr("does not tell the angle at full deflection"),
            Not(HasSubstr("Not ready"))));
}

// By hand: (1675 - 1450) / (1900 - 1450) is a half, 1100 is all of the other side.
TEST(BoatMap, TurnsPulsesIntoAnglesAboutTheirTrim) {
  const ImportedLog imported = ImportedBoat(BoatSettings(), Boat("[0, 0, -1]"));
  EXPECT_THAT(*imported.log.fins->Find("fin_helm"),
              ElementsAre(0.0, DoubleNear(0.3, 1e-15), -0.6, -0.6, 0.0));
  EXPECT_THAT(imported.remarks,
              AllOf(Contains(HasSubstr("at 1 row of 5 the output is off")),
                    Contains(HasSubstr("at 1 row of 5 the pulse is beyond 1100 to 1900 us"))));
  EXPECT_THAT(imported.log.dofs, ElementsAre(Dof::kSurge, Dof::kSway, Dof::kYaw));
  // 1520 us is 2 N by the table, 1620 us 12 N.
  EXPECT_THAT(*imported.log.thrusters->Find("thruster_1"),
              ElementsAre(DoubleEq(2), DoubleEq(12), DoubleEq(12), DoubleEq(12), DoubleEq(12)));
}

// A command above 0 is to starboard. With the axis down an angle above 0 turns to port.
TEST(BoatMap, GivesTheAngleTheSignOfTheVehiclesAxis) {
  const auto half = [](const std::string& settings, const char* axis) {
    return (*ImportedBoat(settings, Boat(axis)).log.fins->Find("fin_helm"))[1];
  };
  EXPECT_NEAR(half(BoatSettings(), "[0, 0, 1]"), -0.3, 1e-15);
  EXPECT_NEAR(half(BoatSettings(1.0F), "[0, 0, -1]"), -0.3, 1e-15);
  EXPECT_NEAR(half(BoatSettings(1.0F), "[0, 0, 1]"), 0.3, 1e-15);
}

// Turned round about its trim of 1520 us: 1620 us is then 1420 us, -8 N by the table.
TEST(BoatMap, TurnsAReversedThrottleRoundAboutItsTrim) {
  EXPECT_THAT(MapOfBoat(BoatSettings(0.0F, 1.0F)).text,
              HasSubstr("  thruster_1: {field: C3, offset: -40, reversed: true}  # "
                        "SERVO3_FUNCTION is 70, SERVO3_REVERSED is 1\n"));
  const ImportedLog imported = ImportedBoat(BoatSettings(0.0F, 1.0F), Boat("[0, 0, 1]"));
  EXPECT_THAT((*imported.log.thrusters->Find("thruster_1"))[0], DoubleNear(2, 1e-12));
  EXPECT_THAT((*imported.log.thrusters->Find("thruster_1"))[1], DoubleNear(-8, 1e-12));
}

TEST(BoatMap, AsksForTheAngleAtFullDeflection) {
  const Vehicle boat = Boat("[0, 0, -1]", "");
  EXPECT_THAT(ErrorFrom([&] { ImportedBoat(BoatSettings(), boat); }),
              HasSubstr("fin_helm is of pulses, and nothing tells the angle at full deflection, "
                        "expected `largest_angle` [rad] of the fin 'helm' in the vehicle file or "
                        "of this column in the map"));
  const auto file = BoatLog(BoatSettings());
  const ImportMap map = ParseImportMap(
      "map.yaml",
      "dof: yaw\ncommand: {channel: RCOU, fin_helm: {field: C1, pulses: [1100, 1450, 1900], "
      "largest_angle: 0.4}}\n");
  EXPECT_THAT(*ImportLog(file, *OpenRecording(file), map, boat).log.fins->Find("fin_helm"),
              ElementsAre(0.0, DoubleNear(0.2, 1e-15), -0.4, -0.4, 0.0));
}

TEST(BoatMap, SaysWhatTheSettingsLeaveOpen) {
  const std::string open =
      BoatParameter("SERVO1_FUNCTION", 26.0F) + BoatParameter("SERVO2_FUNCTION", 26.0F);
  const SuggestedMap map = MapOfBoat(open);
  EXPECT_FALSE(map.is_ready);
  EXPECT_THAT(map.text,
              AllOf(StartsWith("# Not ready: the pulses of output 1 are not known: the log does "
                               "not hold all of SERVO1_MIN, SERVO1_TRIM and SERVO1_MAX.\n"),
                    HasSubstr("# SERVO2_FUNCTION is 26 too: only output 1 is taken\n")));
  EXPECT_THAT(MapOfBoat(BoatParameter("SERVO9_FUNCTION", 26.0F)).text,
              StartsWith("# Not ready: SERVO9_FUNCTION is 26, and the log does not hold its "
                         "pulses"));
}

TEST(BoatMap, ReadsTheSettingsOfATelemetryLog) {
  using namespace tlog;
  const auto setting = [](const std::string& name, float value) {
    std::string payload = Bytes(value) + Bytes<std::uint16_t>(888) + Bytes<std::uint16_t>(1) + name;
    payload.resize(24, '\0');
    return Packet2(1600000000000000, 22, payload + '\x09', 220, 1, 1);
  };
  std::string bytes = setting("SERVO1_FUNCTION", 26.0F) + setting("SERVO1_MIN", 1100.0F) +
                      setting("SERVO1_TRIM", 1500.0F) + setting("SERVO1_MAX", 1900.0F) +
                      setting("SERVO2_FUNCTION", 70.0F);
  for (int i = 0; i < 4; ++i) {
    bytes +=
        Packet2(1600000000000000 + 250000 * i,
                36,
                Bytes<std::uint32_t>(250 * i) + Bytes(static_cast<std::uint16_t>(1500 + 100 * i)) +
                    Bytes<std::uint16_t>(1600) + std::string(13, '\0'),
                222);
  }
  const auto file = ScratchFile("boat.tlog", bytes);
  const auto recording = OpenRecording(file);
  const Vehicle boat = Boat("[0, 0, -1]");
  const SuggestedMap map = SuggestMap(*recording, boat);
  const ImportedLog imported =
      ImportLog(file, *recording, ParseImportMap("map.yaml", map.text), boat);
  EXPECT_THAT(
      *imported.log.fins->Find("fin_helm"),
      ElementsAre(0.0, DoubleNear(0.15, 1e-15), DoubleNear(0.3, 1e-15), DoubleNear(0.45, 1e-15)));
  EXPECT_THAT((*imported.log.thrusters->Find("thruster_1"))[0], DoubleNear(10, 1e-12));
}

}  // namespace
}  // namespace fathom
