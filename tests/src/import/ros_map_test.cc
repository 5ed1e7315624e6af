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

Channel Of(const char* name, const char* type, const std::vector<std::string>& fields) {
  Channel channel = {name, type, {}, 500, 0.0, 50.0};
  for (const std::string& field : fields) channel.fields.push_back({field, ""});
  return channel;
}

// A pose on the plane, and two thrusters by their names.
TEST(RosMap, KnowsABoatByItsThrustersAndPose2D) {
  Contents contents;
  contents.format = "ros1_bag";
  contents.channels = {Of("/NED_pose", "geometry_msgs/Pose2D", {"x", "y", "theta"}),
                       Of("/left_thruster", "std_msgs/Float64", {"data"}),
                       Of("/local_vel", "geometry_msgs/Vector3", {"x", "y", "z"}),
                       Of("/ref", "geometry_msgs/Pose2D", {"x", "y", "theta"}),
                       Of("/right_thruster", "std_msgs/Float64", {"data"})};
  const SuggestedMap suggested = SuggestMap(ConstantRecording(contents, 0.0), std::nullopt);
  EXPECT_FALSE(suggested.is_ready);
  EXPECT_THAT(suggested.text, HasSubstr("\nvehicle: vehicle.yaml"));
  const ImportMap map = ParseImportMap("map", suggested.text);
  ASSERT_TRUE(map.command && map.velocity && map.pose);
  EXPECT_EQ(map.command->channel, "/left_thruster");
  EXPECT_EQ(map.command->columns.size(), 2U);
  EXPECT_EQ(map.velocity->channel, "/local_vel");
  EXPECT_EQ(map.velocity->columns.size(), 3U);
  EXPECT_EQ(map.pose->channel, "/NED_pose");
  EXPECT_EQ(map.pose->columns.size(), 3U);
}

// Of another maker's, by REP 103: theta turns to port.
TEST(RosMap, TakesAnyOtherPose2DAsEastNorthUp) {
  Contents contents;
  contents.format = "mcap";
  contents.channels = {Of("/robot/pose", "geometry_msgs/msg/Pose2D", {"x", "y", "theta"})};
  const SuggestedMap suggested = SuggestMap(ConstantRecording(contents, 0.0), std::nullopt);
  EXPECT_THAT(suggested.text, HasSubstr("channel: \"/robot/pose\""));
  EXPECT_THAT(suggested.text, HasSubstr("frame: ENU"));
}

}  // namespace
}  // namespace fathom
