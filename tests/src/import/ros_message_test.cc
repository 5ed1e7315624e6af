// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Messages of ROS are taken apart by the definition that their file carries.

#include "fathom/import/message/message_decoder.h"
#include "fathom/import/message/message_definition.h"
#include "fathom/import/ros/ros_definition.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "dataflash_writer.h"
#include "scratch_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using dataflash::Bytes;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsNan;

constexpr char kOdometry[] = R"(# A comment, and a constant
uint8 KIND=3
string NAME="x # y"
Header header
string child   # behind a member
Pose pose
float64[] effort
uint8[3] rgb
Marker[] markers
================================================================================
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
================================================================================
MSG: test_msgs/Pose
Point position
================================================================================
MSG: test_msgs/Point
float64 x
float32 y
int16 z
================================================================================
MSG: test_msgs/Marker
bool is_seen
Point[2] corners
)";

MessageDefinition Odometry() { return ParseRosDefinition("test_msgs/Odometry", kOdometry); }

std::string Ros1Text(const std::string& text) {
  return Bytes(static_cast<std::uint32_t>(text.size())) + text;
}

std::string Point(double x, float y, std::int16_t z) { return Bytes(x) + Bytes(y) + Bytes(z); }

// Packed, as ROS 1 has it.
std::string Ros1Message() {
  return Bytes<std::uint32_t>(7) + Bytes<std::uint32_t>(1500000000) +
         Bytes<std::uint32_t>(250000000) + Ros1Text("map") + Ros1Text("body") +
         Point(1.5, -2.5F, -7) + Bytes<std::uint32_t>(2) + Bytes(10.0) + Bytes(20.0) +
         std::string("\x01\x02\xff") + Bytes<std::uint32_t>(1) + std::string("\x01") +
         Point(3.0, 4.0F, 5) + Point(6.0, 7.0F, 8);
}

std::vector<double> Decode(const MessageDefinition& definition,
                           MessageEncoding encoding,
                           const std::vector<std::string>& paths,
                           const std::string& message) {
  std::vector<double> values;
  EXPECT_TRUE(MessageDecoder(definition, encoding, paths).Decode(message, &values));
  return values;
}

TEST(MessageType, OfRos1IsTakenApart) {
  EXPECT_THAT(Decode(Odometry(),
                     MessageEncoding::kRos1,
                     {"markers[0].corners[1].z",
                      "header.stamp",
                      "pose.position.y",
                      "effort[1]",
                      "rgb[2]",
                      "effort[2]",
                      "markers[0].is_seen",
                      "header.seq"},
                     Ros1Message()),
              ElementsAre(8, 1500000000.25, -2.5, 20, 255, IsNan(), 1, 7));
}

// The same in CDR: numbers at multiples of their size behind the four bytes of the head.
TEST(MessageType, OfRos2IsTakenApart) {
  const MessageDefinition definition = ParseRosDefinition(
      "test_msgs/msg/Small",
      "uint8 first\nfloat64 second\nuint16 third\nstring<=10 name\nfloat32[<=4] list\n"
      "float64 with_default 3.5\nint32 CONSTANT=4\nbuiltin_interfaces/Time stamp\n"
      "===\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n");
  const std::string zero(1, '\0');
  const auto pad = [](std::string* text, std::size_t size) {
    while ((text->size() - 4) % size != 0) *text += '\0';
  };
  std::string message("\0\1\0\0", 4);
  message += Bytes<std::uint8_t>(200);
  pad(&message, 8);
  message += Bytes(-0.125) + Bytes<std::uint16_t>(65000);
  pad(&message, 4);
  message += Bytes<std::uint32_t>(3) + "ab" + zero;
  pad(&message, 4);
  message += Bytes<std::uint32_t>(2) + Bytes(1.5F) + Bytes(2.5F);
  pad(&message, 8);
  message += Bytes(9.75) + Bytes<std::int32_t>(100) + Bytes<std::uint32_t>(500000000);
  EXPECT_THAT(Decode(definition,
                     MessageEncoding::kCdr,
                     {"first", "second", "third", "list[1]", "with_default", "stamp"},
                     message),
              ElementsAre(200, -0.125, 65000, 2.5, 9.75, 100.5));
}

TEST(MessageType, MayHaveItsBytesInTheOtherOrder) {
  const MessageDefinition definition = ParseRosDefinition("a/B", "uint16 x\nfloat32 y\n");
  const std::string message("\0\0\0\0\x01\x02\0\0\x3f\xc0\0\0", 12);
  EXPECT_THAT(Decode(definition, MessageEncoding::kCdr, {"x", "y"}, message),
              ElementsAre(258, 1.5));
}

TEST(MessageType, ListsItsNumbers) {
  std::vector<std::string> names;
  for (const Field& field : NumbersOf(Odometry(), MessageEncoding::kRos1, Ros1Message())) {
    names.push_back(field.name);
  }
  EXPECT_THAT(names,
              ElementsAre("header.seq",
                          "header.stamp",
                          "pose.position.x",
                          "pose.position.y",
                          "pose.position.z",
                          "effort[0]",
                          "effort[1]",
                          "rgb[0]",
                          "rgb[1]",
                          "rgb[2]",
                          "markers[0].is_seen",
                          "markers[0].corners[0].x",
                          "markers[0].corners[0].y",
                          "markers[0].corners[0].z",
                          "markers[0].corners[1].x",
                          "markers[0].corners[1].y",
                          "markers[0].corners[1].z"));
}

TEST(MessageType, ThatEndsTooEarlyIsToldAtAnyPlace) {
  const std::string whole = Ros1Message();
  const MessageDefinition definition = Odometry();
  const MessageDecoder decoder(definition, MessageEncoding::kRos1, {"markers[0].corners[1].z"});
  std::vector<double> values;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_FALSE(decoder.Decode(whole.substr(0, length), &values)) << length;
  }
  EXPECT_TRUE(decoder.Decode(whole, &values));
}

TEST(MessageType, WithAFalseLengthTakesNoMemoryAndNoTime) {
  const MessageDefinition definition = ParseRosDefinition(
      "a/B", "Empty[] nothing\nstring[] names\nfloat64[] x\n===\nMSG: a/Empty\n");
  std::vector<double> values;
  const MessageDecoder decoder(definition, MessageEncoding::kRos1, {"x[4000000000]"});
  EXPECT_FALSE(decoder.Decode(std::string(12, '\xff'), &values));
}

TEST(MessageDefinition, SaysWhatIsWrong) {
  const auto error = [](const char* text) {
    return ErrorFrom([&] { ParseRosDefinition("a/B", text); });
  };
  EXPECT_THAT(error("Unknown x\n"),
              HasSubstr("message type a/B: its definition holds no type 'Unknown'"));
  EXPECT_THAT(error("C c\n===\nMSG: a/C\nB b\n===\nMSG: a/B\nC c\n"), HasSubstr("holds itself"));
  EXPECT_THAT(error("float64[-1] x\n"), HasSubstr("'-1' is no length"));
}

// genpy (ROS 1) packs a byte as int8; in ROS 2 it is an octet.
TEST(MessageType, TakesAByteWithItsSignInRos1Only) {
  std::vector<double> values;
  const auto ros1 = ParseRosDefinition("test_msgs/B", "byte b\n");
  MessageDecoder(ros1, MessageEncoding::kRos1, {"b"}).Decode("\xff", &values);
  EXPECT_THAT(values, ElementsAre(-1.0));
  const auto ros2 = ParseRosDefinition("test_msgs/msg/B", "byte b\n");
  const std::string message("\0\1\0\0\xff", 5);
  MessageDecoder(ros2, MessageEncoding::kCdr, {"b"}).Decode(message, &values);
  EXPECT_THAT(values, ElementsAre(255.0));
}

TEST(MessageType, GivesAnArrayInAnyOrderAndAsFarAsItGoes) {
  const auto definition = ParseRosDefinition("test_msgs/A", "float64[3] a\nfloat64 b\n");
  const std::string message = Bytes(1.0) + Bytes(2.0) + Bytes(3.0) + Bytes(4.0);
  const MessageDecoder all(definition, MessageEncoding::kRos1, {"a[2]", "b", "a[0]", "a[1]"});
  std::vector<double> values;
  EXPECT_TRUE(all.Decode(message, &values));
  EXPECT_THAT(values, ElementsAre(3.0, 4.0, 1.0, 2.0));
  EXPECT_FALSE(all.Decode(message.substr(0, 17), &values));
  EXPECT_THAT(values, ElementsAre(IsNan(), IsNan(), 1.0, 2.0));
  const MessageDecoder twice(definition, MessageEncoding::kRos1, {"a[1]", "a[2]", "a[1]", "b"});
  EXPECT_TRUE(twice.Decode(message, &values));
  EXPECT_THAT(values, ElementsAre(2.0, 3.0, 2.0, 4.0));
}

}  // namespace
}  // namespace fathom
