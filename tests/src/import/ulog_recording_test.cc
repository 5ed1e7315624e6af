// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ulog/ulog_recording.h"

#include "fathom/base/random_stream.h"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include "scratch_file.h"
#include "ulog_writer.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using namespace ulog;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::unique_ptr<Recording> Open(const std::string& bytes) {
  return OpenUlog(ScratchFile("log.ulg", bytes));
}

std::string Attitudes(int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += Attitude(1000000 + 20000 * i, 0.125F * i, i % 256);
  return bytes;
}

std::vector<std::string> NamesOf(const Channel& channel) {
  std::vector<std::string> names;
  for (const Field& field : channel.fields) names.push_back(field.name);
  return names;
}

TEST(Ulog, ReadsStampsAndNumbers) {
  const auto recording = Open(Header() + Attitude() + Attitudes(3));
  const Channel channel = ChannelNamed(recording->contents(), "vehicle_attitude");
  EXPECT_EQ(channel.type, "vehicle_attitude");
  EXPECT_EQ(channel.count, 3U);
  EXPECT_DOUBLE_EQ(*channel.first, 1.0);
  EXPECT_DOUBLE_EQ(*channel.last, 1.04);
  EXPECT_THAT(NamesOf(channel), ElementsAre("timestamp", "q[0]", "q[1]", "q[2]", "q[3]", "count"));
  EXPECT_EQ(channel.fields[0].unit, "us");
  EXPECT_TRUE(recording->contents().IsComplete());
  EXPECT_THAT(recording->contents().remarks, IsEmpty());
  const ReadSamples samples = ReadAll(*recording, {"vehicle_attitude", {"q[3]", "count", "q[0]"}});
  EXPECT_THAT(samples.time, ElementsAre(1.0, 1.02, 1.04));
  EXPECT_THAT(samples.rows[2], ElementsAre(0.75, 2.0, 0.25));
}

TEST(Ulog, ReadsEveryType) {
  const auto recording = Open(
      Header() +
      Format("all:uint64_t timestamp;int8_t a;uint8_t b;int16_t c;uint16_t d;int32_t e;uint32_t f;"
             "int64_t g;float h;double i;bool j;char k;char[5] l;uint8_t m;") +
      Subscribe(3, "all") +
      Data(3,
           Bytes<std::uint64_t>(2500000) + Bytes<std::int8_t>(-5) + Bytes<std::uint8_t>(250) +
               Bytes<std::int16_t>(-3000) + Bytes<std::uint16_t>(60000) +
               Bytes<std::int32_t>(-70000) + Bytes<std::uint32_t>(4000000000U) +
               Bytes<std::int64_t>(-5000000000) + Bytes(-0.5F) + Bytes(1e-300) +
               Bytes<std::uint8_t>(1) + "xhello" + Bytes<std::uint8_t>(77)));
  const ReadSamples samples =
      ReadAll(*recording, {"all", {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "m"}});
  EXPECT_THAT(samples.time, ElementsAre(2.5));
  EXPECT_THAT(samples.rows.at(0),
              ElementsAre(-5, 250, -3000, 60000, -70000, 4e9, -5e9, -0.5, 1e-300, 1, 77));
}

TEST(Ulog, TakesNestedTypesApart) {
  // The nested type is defined behind the one that holds it. Its padding counts within, and the
  // message's own at the end is not logged.
  const auto recording =
      Open(Header() +
           Format("esc_status:uint64_t timestamp;esc_report[2] esc;uint8_t last;uint8_t[7] "
                  "_padding0;") +
           Format("esc_report:float rpm;uint8_t state;uint8_t[3] _padding0;") +
           Subscribe(0, "esc_status") +
           Data(0,
                Bytes<std::uint64_t>(1000000) + Bytes(1200.0F) + Bytes<std::uint8_t>(3) + "???" +
                    Bytes(-900.0F) + Bytes<std::uint8_t>(4) + "???" + Bytes<std::uint8_t>(9)));
  const Channel channel = ChannelNamed(recording->contents(), "esc_status");
  EXPECT_THAT(
      NamesOf(channel),
      ElementsAre("timestamp", "esc[0].rpm", "esc[0].state", "esc[1].rpm", "esc[1].state", "last"));
  const ReadSamples samples =
      ReadAll(*recording, {"esc_status", {"esc[0].rpm", "esc[1].rpm", "esc[1].state", "last"}});
  EXPECT_THAT(samples.rows.at(0), ElementsAre(1200, -900, 4, 9));
  EXPECT_THAT(recording->contents().remarks, IsEmpty());
}

TEST(Ulog, SplitsInstances) {
  std::string bytes = Header() + Format("battery_status:uint64_t timestamp;float voltage_v;") +
                      Subscribe(5, "battery_status") + Subscribe(6, "battery_status", 1);
  for (int i = 0; i < 6; ++i) {
    bytes += Data(5 + i % 2, Bytes<std::uint64_t>(1000 * i) + Bytes(10.0F * i));
  }
  const auto recording = Open(bytes);
  EXPECT_EQ(ChannelNamed(recording->contents(), "battery_status").count, 3U);
  EXPECT_EQ(ChannelNamed(recording->contents(), "battery_status[1]").type, "battery_status");
  const ReadSamples samples = ReadAll(*recording, {"battery_status[1]", {"voltage_v"}});
  EXPECT_THAT(samples.rows, ElementsAre(ElementsAre(10), ElementsAre(30), ElementsAre(50)));
}

TEST(Ulog, CarriesStampsOfFewBitsOn) {
  std::string bytes = Header() + Format("a:uint16_t timestamp;float x;") +
                      Format("b:uint8_t timestamp;float x;") + Subscribe(0, "a") +
                      Subscribe(1, "b");
  for (int i = 0; i < 4; ++i) {
    bytes += Data(0, Bytes(static_cast<std::uint16_t>(50000 * i)) + Bytes(1.0F)) +
             Data(1, Bytes(static_cast<std::uint8_t>(200 * i)) + Bytes(1.0F));
  }
  const auto recording = Open(bytes);
  const auto a = ReadAll(*recording, {"a", {"x"}}).time;
  const auto b = ReadAll(*recording, {"b", {"x"}}).time;
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(a.at(i), 0.05 * i, 1e-12);  // microseconds
    EXPECT_NEAR(b.at(i), 0.2 * i, 1e-12);   // milliseconds
  }
  EXPECT_NEAR(*ChannelNamed(recording->contents(), "a").last, 0.15, 1e-12);
  EXPECT_EQ(ChannelNamed(recording->contents(), "a").fields[0].unit, "us");
  EXPECT_EQ(ChannelNamed(recording->contents(), "b").fields[0].unit, "ms");
}

TEST(Ulog, ReadsAppendedData) {
  // The log ends within a message; two parts were appended.
  const std::string log =
      Header({0, 0}) + Attitude() + Attitudes(5) + Attitude(9, 9.0F, 9).substr(0, 11);
  const std::string second = Attitudes(2);
  const auto recording = Open(Header({log.size(), log.size() + second.size()}) +
                              log.substr(Header().size()) + second + Attitudes(1));
  const Contents& contents = recording->contents();
  EXPECT_EQ(ChannelNamed(contents, "vehicle_attitude").count, 8U);
  EXPECT_EQ(contents.size_bytes - contents.read_bytes, 11U);
  EXPECT_THAT(contents.remarks,
              ElementsAre(HasSubstr("the 11 bytes from byte " + std::to_string(log.size() - 11))));
}

TEST(Ulog, PassesOverOffsetsOfNoAppendedData) {
  const auto recording = Open(Header({1000000000}) + Attitude() + Attitudes(5));
  EXPECT_EQ(ChannelNamed(recording->contents(), "vehicle_attitude").count, 5U);
  EXPECT_THAT(recording->contents().remarks, ElementsAre(HasSubstr("tells of appended data")));
}

TEST(Ulog, CountsWhatItDoesNotRead) {
  const auto recording =
      Open(Header() + Parameter("MPC_XY_P", 0.95F) + Parameter("MPC_Z_P", 1.0F) + Attitude() +
           Attitudes(2) + Dropout(250) + Dropout(1500) +
           Message('L', "6" + Bytes<std::uint64_t>(5) + "armed") + Sync() +
           Message('Z', "of a later version") + Data(7, std::string(12, 'x')) + Attitudes(1));
  const Contents& contents = recording->contents();
  EXPECT_TRUE(contents.IsComplete());
  EXPECT_EQ(ChannelNamed(contents, "vehicle_attitude").count, 3U);
  EXPECT_THAT(
      contents.remarks,
      ElementsAre(HasSubstr("no subscription, or one too many, says of which topic they are: 1 "),
                  HasSubstr("ULog has no messages of their type: 1 message."),
                  HasSubstr("2 dropouts, 1.750 s in all"),
                  HasSubstr("2 parameters, 0 messages of information, 1 text.")));
}

TEST(Ulog, SaysWhatCannotBeRead) {
  std::string bytes = Header() + Format("a:b x;") + Format("b:a x;") + Format("c:nothing x;") +
                      Format("d:d[60000] x;") + Format("e:float[20000] x;") + Format("no_colon") +
                      Attitude() + Attitudes(1);
  const char* topics[] = {"a", "c", "d", "e", "f"};
  for (int i = 0; i < 5; ++i) {
    bytes += Subscribe(10 + i, topics[i]) + Data(10 + i, std::string(8, '\0'));
  }
  const auto recording = Open(bytes);
  EXPECT_EQ(recording->contents().channels.size(), 6U);
  EXPECT_THAT(recording->contents().remarks,
              ElementsAre(HasSubstr("1 messages F are no formats"),
                          HasSubstr("a cannot be read: 'b' is nested over"),
                          HasSubstr("c cannot be read: no message F defines 'nothing'"),
                          HasSubstr("d cannot be read: 'd' is nested over"),
                          HasSubstr("e cannot be read: 'e' has over 65533 bytes"),
                          HasSubstr("f cannot be read: no message F defines 'f'")));
}

TEST(Ulog, GivesWhatAShortMessageHas) {
  const auto recording = Open(Header() + Attitude() + Attitudes(1) + Format("x:float a;float b;") +
                              Subscribe(1, "x") + Data(1, Bytes(2.0F) + "yy"));
  EXPECT_THAT(recording->contents().remarks,
              ElementsAre(HasSubstr("x: 1 of its messages end before their format does")));
  const ReadSamples samples = ReadAll(*recording, {"x", {"a", "b"}});
  EXPECT_EQ(samples.rows.at(0)[0], 2.0);
  EXPECT_TRUE(std::isnan(samples.rows.at(0)[1]));
  EXPECT_TRUE(std::isnan(samples.time.at(0)));  // no `timestamp`
}

TEST(Ulog, KnowsTheTimeFromItsGps) {
  const std::string gps =
      Format(
          "vehicle_gps_position:uint64_t timestamp;uint64_t time_utc_usec;int32_t "
          "timestamp_time_relative;uint8_t fix_type;") +
      Subscribe(2, "vehicle_gps_position");
  const auto message = [](std::uint64_t time, std::uint64_t utc, int relative, int fix) {
    return Data(2, Bytes(time) + Bytes(utc) + Bytes(relative) + Bytes<std::uint8_t>(fix));
  };
  const auto recording =
      Open(Header() + gps + message(1000000, 1500000000000000, 0, 1) + message(2000000, 0, 0, 3) +
           message(3000000, 1600000000250000, -250000, 3));
  EXPECT_EQ(*recording->contents().utc_of_zero, 1600000000.25 - 2.75);
  EXPECT_FALSE(Open(Header() + gps + message(1, 0, 0, 0))->contents().utc_of_zero);
}

TEST(Ulog, TakesZerosAtTheEndAsPadding) {
  const auto recording = Open(Header() + Attitude() + Attitudes(5) + std::string(528, '\0'));
  EXPECT_EQ(ChannelNamed(recording->contents(), "vehicle_attitude").count, 5U);
  EXPECT_TRUE(recording->contents().IsComplete());
}

TEST(Ulog, TellsWhereACutFileEnds) {
  const std::string sound = Header() + Attitude() + Attitudes(5);
  const auto recording = Open(sound + Attitude(5, 1, 1).substr(0, 7));
  const Contents& contents = recording->contents();
  EXPECT_EQ(ChannelNamed(contents, "vehicle_attitude").count, 5U);
  EXPECT_EQ(contents.read_bytes, sound.size());
  EXPECT_THAT(contents.remarks,
              ElementsAre(HasSubstr("the 7 bytes from byte " + std::to_string(sound.size()))));
}

TEST(Ulog, GoesOnBehindDamageAndTellsHowMuchItSkipped) {
  const std::string before = Header() + Attitude() + Attitudes(5);
  const auto recording = Open(before + "\xff\xff\xff noise" + Attitudes(7));
  const Contents& contents = recording->contents();
  EXPECT_EQ(ChannelNamed(contents, "vehicle_attitude").count, 12U);
  EXPECT_EQ(contents.size_bytes - contents.read_bytes, 9U);
  EXPECT_THAT(contents.remarks,
              ElementsAre(HasSubstr("the first at byte " + std::to_string(before.size()))));
}

// A message of sync is enough to go on, where too few messages follow each other.
TEST(Ulog, GoesOnAtASyncMessage) {
  const auto recording = Open(Header() + Attitude() + Attitudes(5) + "\xff\xff\xff" + Sync() +
                              Subscribe(1, "vehicle_attitude", 1) + "\xff\xff" + Sync());
  EXPECT_EQ(recording->contents().size_bytes - recording->contents().read_bytes, 5U);
}

TEST(Ulog, GoesOnBehindAMessageThatIsShorterThanItSays) {
  const auto recording =
      Open(Header() + Attitude() + Attitudes(5) + Attitude(9, 9, 9).substr(0, 11) + Attitudes(7));
  EXPECT_EQ(ChannelNamed(recording->contents(), "vehicle_attitude").count, 12U);
  EXPECT_EQ(recording->contents().size_bytes - recording->contents().read_bytes, 11U);
}

TEST(Ulog, RefusesWhatItCannotRead) {
  EXPECT_THAT(ErrorFrom([] { Open(Header().substr(0, 9)); }),
              HasSubstr("log.ulg: ends after 9 bytes, expected the 16 of a ULog header"));
  EXPECT_THAT(ErrorFrom([] { Open(Header() + Attitude()); }), HasSubstr("holds no data"));
  std::string flagged = Header() + Attitude() + Attitudes(2);
  flagged[16 + 3 + 8] = 2;
  EXPECT_THAT(ErrorFrom([&] { Open(flagged); }),
              HasSubstr("byte 27: the flags of what an older reader cannot read are 0x2, expected "
                        "0, or 1"));
}

TEST(Ulog, SaysThatItReadsALaterVersion) {
  std::string bytes = Header() + Attitude() + Attitudes(2);
  bytes[7] = 3;
  EXPECT_THAT(Open(bytes)->contents().remarks, ElementsAre(HasSubstr("ULog version 3")));
}

// Bytes of any kind between messages are none.
TEST(Ulog, TakesNoNoiseForMessages) {
  RandomStream random(3, "ulog noise");
  std::string noise(300000, '\xff');
  for (std::size_t i = 1; i < noise.size(); ++i)
    noise[i] = static_cast<char>(random.Uniform() * 256.0);
  noise[2] = '\xff';  // begins no message
  const auto recording = Open(Header() + Attitude() + Attitudes(50) + noise + Attitudes(50));
  const Contents& contents = recording->contents();
  EXPECT_EQ(ChannelNamed(contents, "vehicle_attitude").count, 100U);
  EXPECT_EQ(contents.channels.size(), 1U);
  EXPECT_EQ(contents.size_bytes - contents.read_bytes, noise.size());
}

// Of a file that is cut anywhere, every message before the cut is there.
TEST(Ulog, DeliversAllBeforeACut) {
  const std::string header = Header() + Attitude();
  const std::string all = header + Attitudes(200);
  const std::size_t message = Attitude(0, 0, 0).size();
  RandomStream random(1, "ulog cuts");
  for (int trial = 0; trial < 100; ++trial) {
    const auto length =
        header.size() + message +
        static_cast<std::size_t>(random.Uniform() * (all.size() - header.size() - message));
    const auto recording = Open(all.substr(0, length));
    EXPECT_EQ(ChannelNamed(recording->contents(), "vehicle_attitude").count,
              (length - header.size()) / message);
    EXPECT_EQ(recording->contents().IsComplete(), (length - header.size()) % message == 0);
  }
}

// Of a file with flipped bits, what comes is finite in number, and most of it is there.
TEST(Ulog, SurvivesFlippedBits) {
  const std::string header = Header();
  const std::string definitions = Attitude();
  const std::string all = header + definitions + Attitudes(300);
  RandomStream random(2, "ulog flips");
  for (int trial = 0; trial < 100; ++trial) {
    std::string flipped = all;
    bool is_topic_lost = false;
    for (int k = 0; k < 5; ++k) {
      const auto at =
          header.size() + static_cast<std::size_t>(random.Uniform() * (all.size() - header.size()));
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << static_cast<int>(8 * random.Uniform())));
      is_topic_lost = is_topic_lost || at < header.size() + definitions.size();
    }
    const std::string error = ErrorFrom([&] {
      const auto recording = Open(flipped);
      for (const Channel& channel : recording->contents().channels) {
        if (!is_topic_lost) {
          EXPECT_GE(channel.count + 12, 300U);
        }
        std::vector<std::string> names = NamesOf(channel);
        ReadAll(*recording, {channel.name, names});
      }
    });
    if (!is_topic_lost) {
      EXPECT_EQ(error, "no error");
    }
  }
}

// Peak of the whole program [kB].
std::size_t PeakResident() {
  std::size_t peak = 0;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) peak = std::stoul(line.substr(6));
  }
  return peak;
}

// Formats that ask for more than a message can have take no memory.
TEST(Ulog, TakesLittleMemoryForManyFormats) {
  const std::size_t peak_before = PeakResident();
  std::string bytes = Header();
  for (int i = 0; i < 5000; ++i) {
    const std::string name = "t" + std::to_string(i);
    bytes += Format(name + ":uint8_t[65000] field_of_a_name_that_is_not_short;") +
             Subscribe(i, name) + Data(i, "abc");
  }
  const auto recording = Open(bytes);
  EXPECT_EQ(recording->contents().channels.size(), 4096U);
  std::size_t num_fields = 0;
  for (const Channel& channel : recording->contents().channels) num_fields += channel.fields.size();
  EXPECT_LE(num_fields, 100000U);
  EXPECT_LT(PeakResident() - peak_before, 300000U);
}

}  // namespace
}  // namespace fathom
