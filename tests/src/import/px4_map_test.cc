// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The map that is suggested for a PX4 log, and the log that it makes.

#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/suggest_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cmath>
#include <string>

#include "scratch_file.h"
#include "ulog_writer.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using namespace ulog;
using ::testing::AllOf;
using ::testing::HasSubstr;

Vehicle TwoThrusters(const std::string& unit) {
  const std::string table =
      unit == "1" ? "[[-1, -40], [0, 0], [1, 50]]" : "[[1100, -40], [1500, 0], [1900, 50]]";
  return ParseVehicleFile(
      "v.yaml",
      "name: two\nmass: 20\nsize: [1, 1, 1]\n"
      "thrust_tables:\n  - {name: T, source: us, command: " +
          unit + ", voltages: [16], thrust: " + table +
          "}\n"
          "thrusters:\n"
          "  - {name: port, position: [0, -0.5, 0], direction: [1, 0, 0], thrust_table: T}\n"
          "  - {name: starboard, position: [0, 0.5, 0], direction: [1, 0, 0], thrust_table: T}\n");
}

// A vehicle that heads east, turned by pi/2 about z, and moves east at 2 m/s: 2 m/s ahead.
std::string Motion() {
  std::string bytes =
      Format(
          "vehicle_local_position:uint64_t timestamp;float x;float y;float z;float vx;float "
          "vy;float vz;") +
      Format("vehicle_attitude:uint64_t timestamp;float[4] q;") +
      Format("vehicle_angular_velocity:uint64_t timestamp;float[3] xyz;") +
      Subscribe(0, "vehicle_local_position") + Subscribe(1, "vehicle_attitude") +
      Subscribe(2, "vehicle_angular_velocity");
  const float half = std::sqrt(0.5F);
  for (int i = 0; i < 20; ++i) {
    const std::string time = Bytes<std::uint64_t>(1000000 + 100000 * i);
    bytes += Data(0,
                  time + Bytes(3.0F) + Bytes(0.2F * i) + Bytes(5.0F) + Bytes(0.0F) + Bytes(2.0F) +
                      Bytes(0.0F)) +
             Data(1, time + Bytes(half) + Bytes(0.0F) + Bytes(0.0F) + Bytes(half)) +
             Data(2, time + Bytes(0.01F) + Bytes(0.02F) + Bytes(0.03F));
  }
  return bytes;
}

std::string Motors() {
  std::string bytes = Format("actuator_motors:uint64_t timestamp;float[12] control;") +
                      Subscribe(5, "actuator_motors");
  for (int i = 0; i < 20; ++i) {
    std::string data =
        Bytes<std::uint64_t>(1000000 + 100000 * i) + Bytes(i % 2 * 0.5F) + Bytes(i % 2 * -0.5F);
    for (int k = 2; k < 12; ++k) data += Bytes(NAN);
    bytes += Data(5, data);
  }
  return bytes;
}

std::string Pulses() {
  std::string bytes =
      Format("actuator_outputs:uint64_t timestamp;uint32_t noutputs;float[16] output;") +
      Format("battery_status:uint64_t timestamp;float voltage_v;") +
      Subscribe(5, "actuator_outputs") + Subscribe(6, "battery_status");
  for (int i = 0; i < 20; ++i) {
    const std::string time = Bytes<std::uint64_t>(1000000 + 100000 * i);
    std::string data =
        time + Bytes<std::uint32_t>(2) + Bytes(1500.0F + i % 2 * 400.0F) + Bytes(1500.0F);
    for (int k = 2; k < 16; ++k) data += Bytes(0.0F);
    bytes += Data(5, data) + Data(6, time + Bytes(16.0F));
  }
  return bytes;
}

TEST(Px4Map, TakesMotorsAndTheMotionOfTheEkf) {
  const auto file = ScratchFile("log.ulg", Header() + Motion() + Motors());
  const auto recording = OpenRecording(file);
  const Vehicle vehicle = TwoThrusters("1");
  const SuggestedMap map = SuggestMap(*recording, vehicle);
  ASSERT_TRUE(map.is_ready) << map.text;
  EXPECT_THAT(map.text, HasSubstr("the log measures none"));
  const ImportedLog imported =
      ImportLog(file, *recording, ParseImportMap("map.yaml", map.text), vehicle);
  // Half of full command: 25 N ahead and 20 N astern, of which the turn is to starboard.
  EXPECT_DOUBLE_EQ(imported.log.command->Find("tau_surge")->at(3), 5.0);
  EXPECT_DOUBLE_EQ(imported.log.command->Find("tau_yaw")->at(3), 22.5);
  EXPECT_NEAR(imported.log.velocity->Find("u")->at(3), 2.0, 1e-6);
  EXPECT_NEAR(imported.log.velocity->Find("v")->at(3), 0.0, 1e-6);
  EXPECT_NEAR(imported.log.velocity->Find("r")->at(3), 0.03, 1e-6);
  EXPECT_NEAR(imported.log.pose->Find("x")->at(3), 3.0, 1e-6);
  EXPECT_NEAR(imported.log.pose->Find("y")->at(3), 0.6, 1e-6);
  EXPECT_NEAR(imported.log.pose->Find("qz")->at(3), std::sqrt(0.5), 1e-6);
}

TEST(Px4Map, TakesPulsesAtTheVoltageOfTheBattery) {
  const auto file = ScratchFile("log.ulg", Header() + Motion() + Pulses());
  const auto recording = OpenRecording(file);
  const SuggestedMap without = SuggestMap(*recording, {});
  EXPECT_TRUE(without.needs_vehicle);
  EXPECT_FALSE(without.is_ready);
  EXPECT_THAT(without.text,
              AllOf(HasSubstr("unit: us"),
                    HasSubstr("channel: \"battery_status\", field: voltage_v"),
                    HasSubstr("thruster_2: \"output[1]\""),
                    testing::Not(HasSubstr("thruster_3"))));
  const Vehicle vehicle = TwoThrusters("us");
  const SuggestedMap map = SuggestMap(*recording, vehicle);
  ASSERT_TRUE(map.is_ready) << map.text;
  const ImportedLog imported =
      ImportLog(file, *recording, ParseImportMap("map.yaml", map.text), vehicle);
  EXPECT_DOUBLE_EQ(imported.log.command->Find("tau_surge")->at(3), 50.0);
}

TEST(Px4Map, IsNotReadyWithoutMotionOrWithTooFewOutputs) {
  const SuggestedMap still =
      SuggestMap(*OpenRecording(ScratchFile("a.ulg", Header() + Motors())), TwoThrusters("1"));
  EXPECT_FALSE(still.is_ready);
  EXPECT_THAT(still.text, HasSubstr("the log has no motion"));
  const SuggestedMap adrift =
      SuggestMap(*OpenRecording(ScratchFile("b.ulg", Header() + Motion())), TwoThrusters("1"));
  EXPECT_FALSE(adrift.is_ready);
  EXPECT_THAT(adrift.text, HasSubstr("the log has no thruster outputs"));
}

}  // namespace
}  // namespace fathom
