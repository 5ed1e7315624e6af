// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/tlog/tlog_recording.h"

#include "fathom/base/random_stream.h"
#include "fathom/import/open_recording.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "scratch_file.h"
#include "tlog_writer.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using namespace tlog;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::uint64_t kStart = 1600000000000000;  // [us since 1970]

std::unique_ptr<Recording> Open(const std::string& bytes) {
  return OpenTlog(ScratchFile("log.tlog", bytes));
}

std::string Attitudes(int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += Attitude(kStart + 250000 * i, 0.125F * i);
  return bytes;
}

TEST(Tlog, ReadsStampsAndNumbers) {
  const auto recording = Open(Attitudes(3));
  const Contents& contents = recording->contents();
  const Channel channel = ChannelNamed(contents, "ATTITUDE");
  EXPECT_EQ(channel.count, 3U);
  EXPECT_EQ(*channel.first, 1.6e9);
  EXPECT_EQ(*channel.last, 1.6e9 + 0.5);
  EXPECT_EQ(*contents.utc_of_zero, 0.0);
  EXPECT_EQ(channel.fields[1].unit, "rad");
  EXPECT_TRUE(contents.IsComplete());
  EXPECT_THAT(contents.remarks, IsEmpty());
  const ReadSamples samples = ReadAll(*recording, {"ATTITUDE", {"yawspeed", "roll", "yaw"}});
  EXPECT_THAT(samples.time, ElementsAre(1.6e9, 1.6e9 + 0.25, 1.6e9 + 0.5));
  EXPECT_THAT(samples.rows[2], ElementsAre(0.5, 0.25, -1.5));
}

TEST(Tlog, IsKnownByItsFirstBytes) {
  EXPECT_EQ(OpenRecording(ScratchFile("log.any", Attitudes(2)))->contents().format, "tlog");
}

TEST(Tlog, FillsInTheZerosThatMavlink2LeavesOut) {
  const auto recording = Open(Attitude(kStart, 1.0F, 0.0F));
  const ReadSamples samples = ReadAll(*recording, {"ATTITUDE", {"roll", "yawspeed"}});
  EXPECT_THAT(samples.rows.at(0), ElementsAre(1.0, 0.0));
}

// Packets of MAVLink 1 have no extensions: their fields are empty.
TEST(Tlog, ReadsMavlink1AndSignedPackets) {
  std::string servos = Bytes<std::uint32_t>(5);
  for (int i = 1; i <= 8; ++i) servos += Bytes(static_cast<std::uint16_t>(1500 + i));
  servos += '\0';
  const auto recording = Open(Packet1(kStart, 36, servos, 222) +
                              Packet2(kStart + 1000,
                                      36,
                                      servos + Bytes<std::uint16_t>(1509),
                                      222,
                                      1,
                                      1,
                                      /*is_signed=*/true) +
                              Packet2(kStart + 2000, 36, servos, 222));
  EXPECT_TRUE(recording->contents().IsComplete());
  const ReadSamples samples =
      ReadAll(*recording, {"SERVO_OUTPUT_RAW", {"servo8_raw", "servo9_raw", "servo10_raw"}});
  ASSERT_EQ(samples.rows.size(), 3U);
  EXPECT_EQ(samples.rows[0][0], 1508.0);
  EXPECT_TRUE(std::isnan(samples.rows[0][1]));
  EXPECT_THAT(samples.rows[1], ElementsAre(1508, 1509, 0));
  EXPECT_THAT(samples.rows[2], ElementsAre(1508, 0, 0));
}

TEST(Tlog, NumbersTheElementsOfArrays) {
  std::string payload = Bytes<std::uint64_t>(1) + Bytes<std::uint64_t>(2);
  for (int i = 0; i < 7; ++i) payload += Bytes(0.5F * (i + 1));
  const auto recording = Open(Packet2(kStart, 11011, payload, 106));
  const ReadSamples samples = ReadAll(
      *recording,
      {"VISION_POSITION_DELTA", {"time_delta_usec", "angle_delta[2]", "position_delta[0]"}});
  EXPECT_THAT(samples.rows.at(0), ElementsAre(2, 1.5, 2));
}

TEST(Tlog, SplitsSenders) {
  const auto recording = Open(Attitude(kStart, 1.0F) + Attitude(kStart + 10, 2.0F, 0.5F, 7) +
                              Attitude(kStart + 20, 3.0F));
  EXPECT_EQ(ChannelNamed(recording->contents(), "ATTITUDE (1/1)").count, 2U);
  EXPECT_EQ(ChannelNamed(recording->contents(), "ATTITUDE (7/1)").type, "ATTITUDE");
  EXPECT_THAT(ReadAll(*recording, {"ATTITUDE (1/1)", {"roll"}}).rows,
              ElementsAre(ElementsAre(1), ElementsAre(3)));
}

TEST(Tlog, CountsMessagesThatItDoesNotKnow) {
  const std::string unknown = Packet2(kStart, 42, "ab", 28);
  const auto recording =
      Open(Attitude(kStart, 1.0F) + unknown + unknown + Packet2(kStart, 300, "c", 9));
  EXPECT_TRUE(recording->contents().IsComplete());
  EXPECT_THAT(recording->contents().remarks,
              ElementsAre(HasSubstr("by the numbers of MAVLink: message 42: 2, message 300: 1.")));
}

TEST(Tlog, PassesOverPacketsWhoseChecksumDoesNotHold) {
  std::string broken = Attitude(kStart, 1.0F);
  broken[25] ^= 4;
  const auto recording = Open(Attitudes(2) + broken + Attitudes(3));
  const Contents& contents = recording->contents();
  EXPECT_EQ(ChannelNamed(contents, "ATTITUDE").count, 5U);
  EXPECT_EQ(contents.size_bytes - contents.read_bytes, broken.size());
  EXPECT_THAT(contents.remarks,
              ElementsAre(HasSubstr("the first at byte " + std::to_string(Attitudes(2).size()))));
}

TEST(Tlog, GoesOnBehindNoise) {
  const auto recording = Open(Attitudes(5) + "some noise" + Attitudes(7));
  EXPECT_EQ(ChannelNamed(recording->contents(), "ATTITUDE").count, 12U);
  EXPECT_EQ(recording->contents().size_bytes - recording->contents().read_bytes, 10U);
}

TEST(Tlog, TellsWhereACutFileEnds) {
  const std::string sound = Attitudes(5);
  const auto recording = Open(sound + Attitude(kStart, 1.0F).substr(0, 20));
  EXPECT_EQ(recording->contents().read_bytes, sound.size());
  EXPECT_THAT(recording->contents().remarks,
              ElementsAre(HasSubstr("the 20 bytes from byte " + std::to_string(sound.size()))));
}

TEST(Tlog, RefusesAFileWithoutAMessage) {
  EXPECT_THAT(ErrorFrom([] { Open(Attitudes(1).substr(0, 15)); }),
              HasSubstr("log.tlog: holds no whole MAVLink message"));
}

// Of a file that is cut anywhere, every packet before the cut is there.
TEST(Tlog, DeliversAllBeforeACut) {
  const std::string all = Attitudes(200);
  const std::size_t packet = Attitudes(1).size();
  RandomStream random(1, "tlog cuts");
  for (int trial = 0; trial < 100; ++trial) {
    const auto length = packet + static_cast<std::size_t>(random.Uniform() * (all.size() - packet));
    const auto recording = Open(all.substr(0, length));
    EXPECT_EQ(ChannelNamed(recording->contents(), "ATTITUDE").count, length / packet);
    EXPECT_EQ(recording->contents().IsComplete(), length % packet == 0);
  }
}

// Of a file with flipped bits no packet comes that was not written: the checksum sees to it.
TEST(Tlog, SurvivesFlippedBits) {
  const std::string all = Attitudes(300);
  RandomStream random(2, "tlog flips");
  for (int trial = 0; trial < 100; ++trial) {
    std::string flipped = all;
    for (int k = 0; k < 5; ++k) {
      const auto at = static_cast<std::size_t>(random.Uniform() * flipped.size());
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << static_cast<int>(8 * random.Uniform())));
    }
    const auto recording = Open(flipped);
    const ReadSamples samples = ReadAll(*recording, {"ATTITUDE", {"roll", "pitch", "yaw"}});
    EXPECT_GE(samples.rows.size() + 5, 300U);
    for (const std::vector<double>& row : samples.rows) {
      EXPECT_EQ(row[0], 0.125 * std::round(row[0] / 0.125));
      EXPECT_EQ(row[1], 0.25);
      EXPECT_EQ(row[2], -1.5);
    }
  }
}

}  // namespace
}  // namespace fathom
