// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/map/import_map.h"
#include "fathom/import/suggest/suggest_map.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// Every channel holds one number over and over.
class ConstantRecording final : public Recording {
 public:
  ConstantRecording(Contents contents, double value)
      : contents_(std::move(contents)), value_(value) {}
  const Contents& contents() const override { return contents_; }
  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override {
    for (std::size_t i = 0; i < selections.size(); ++i) {
      sink(i, 0.0, std::vector<double>(selections[i].fields.size(), value_));
    }
    return {};
  }

 private:
  Contents contents_;
  double value_;
};

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
  ASSERT_TRUE(map.command);
  EXPECT_EQ(map.command->channel, "/mavros/rc/out");
  EXPECT_EQ(map.command->columns.size(), 4U);
}

INSTANTIATE_TEST_SUITE_P(Types,
                         MavrosBags,
                         ::testing::Values("mavros_msgs/RCOut", "mavros_msgs/msg/RCOut"));

}  // namespace
}  // namespace fathom
