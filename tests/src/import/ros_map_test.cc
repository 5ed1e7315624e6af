// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/map/import_map.h"
#include "fathom/import/suggest/suggest_map.h"

#include <optional>
#include <string>
#include <vector>

#include "constant_recording.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

Channel Outputs(const char* type) {
  Channel channel = {"/mavros/rc/out", type, {}, 500, 0.0, 50.0};
  for (int i = 0; i < 6; ++i) channel.fields.push_back({fmt::format("channels[{}]", i), ""});
  return channel;
}

class MavrosBags : public ::testing::TestWithParam<const char*> {};

TEST_P(MavrosBags, AreMappedByTheirPulsesAndBattery) {
  Contents contents;
  contents.format = "ros1_bag";
  contents.channels = {
      Outputs(GetParam()),
      {"/mavros/battery", "sensor_msgs/BatteryState", {{"voltage", ""}}, 50, 0.0, 50.0}};
  const SuggestedMap without = SuggestMap(ConstantRecording(contents, 1500.0), std::nullopt);
  EXPECT_TRUE(without.needs_vehicle);
  EXPECT_FALSE(without.is_ready);
  EXPECT_THAT(without.text, HasSubstr("  thruster_6: \"channels[5]\"\n"));
  EXPECT_THAT(without.text, HasSubstr("voltage: {channel: \"/mavros/battery\""));
  Vehicle vehicle;
  vehicle.thrusters.resize(4);
  const ImportMap map =
      ParseImportMap("map", SuggestMap(ConstantRecording(contents, 1500.0), vehicle).text);
  // Motors that never ran are thrusters too.
  EXPECT_THAT(SuggestMap(ConstantRecording(contents, 0.0), vehicle).text,
              HasSubstr("  thruster_4: \"channels[3]\"\n"));
  ASSERT_TRUE(map.command);
  EXPECT_EQ(map.command->channel, "/mavros/rc/out");
  EXPECT_EQ(map.command->columns.size(), 4U);
}

INSTANTIATE_TEST_SUITE_P(Types,
                         MavrosBags,
                         ::testing::Values("mavros_msgs/RCOut", "mavros_msgs/msg/RCOut"));

}  // namespace
}  // namespace fathom
