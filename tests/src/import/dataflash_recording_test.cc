// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/dataflash/dataflash_recording.h"

#include "fathom/base/random_stream.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "dataflash_writer.h"
#include "scratch_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using namespace dataflash;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::unique_ptr<Recording> Open(const std::string& bytes) {
  return OpenDataflash(ScratchFile("log.BIN", bytes));
}

std::string Atts(int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += Att(1000000 + 20000 * i, 0.1 * i, i, 0.25F * i);
  return bytes;
}

std::string Header() { return Fmt(128, 89, "FMT", "BBnNZ", "Type,Length,Name,Format,Columns"); }

TEST(Dataflash, ReadsStampsAndScaledNumbers) {
  const auto recording = Open(Header() + FmtOfAtt() + Atts(3));
  const Channel att = ChannelNamed(recording->contents(), "ATT");
  EXPECT_EQ(att.count, 3U);
  EXPECT_DOUBLE_EQ(*att.first, 1.0);
  EXPECT_DOUBLE_EQ(*att.last, 1.04);
  EXPECT_TRUE(recording->contents().IsComplete());
  EXPECT_THAT(recording->contents().remarks, IsEmpty());
  const ReadSamples samples = ReadAll(*recording, {"ATT", {"Rate", "Roll", "Count"}});
  EXPECT_THAT(samples.time, ElementsAre(1.0, 1.02, 1.04));
  EXPECT_THAT(samples.rows[2], ElementsAre(0.5, 0.2, 2.0));
}

TEST(Dataflash, FindsTheFormatWhereverItStands) {
  const auto recording = Open(Atts(4) + FmtOfAtt() + Atts(1) + Header());
  EXPECT_EQ(ChannelNamed(recording->contents(), "ATT").count, 5U);
  EXPECT_TRUE(recording->contents().IsComplete());
}

TEST(Dataflash, StatesUnitsAndAppliesMultipliersToIntegersOnly) {
  const auto recording =
      Open(Header() + FmtOfUnits() + FmtOfAtt() + Unit('d', "deg") + Unit('s', "s") +
           Unit('v', "V") + Mult('B', 0.009999999776482582) + Mult('F', 9.999999974752427e-07) +
           Fmtu(kAtt, "sdvv", "FBBB") + Att(2000000, 1.5, 1234, 3.5F));
  const Channel att = ChannelNamed(recording->contents(), "ATT");
  std::vector<std::string> units;
  for (const Field& field : att.fields) units.push_back(field.unit);
  EXPECT_THAT(units, ElementsAre("s", "deg", "V", "V"));
  const ReadSamples samples = ReadAll(*recording, {"ATT", {"TimeUS", "Roll", "Count", "Rate"}});
  // Count is an integer: 1234 x 0.01. Roll is scaled by its letter already, Rate is a float.
  EXPECT_EQ(samples.rows[0][0], 2.0);
  EXPECT_EQ(samples.rows[0][1], 1.5);
  EXPECT_DOUBLE_EQ(samples.rows[0][2], 12.34);
  EXPECT_EQ(samples.rows[0][3], 3.5);
}

TEST(Dataflash, ReadsEveryLetter) {
  const std::string format =
      Fmt(20, 3 + 59, "ALL", "bBhHiIfdcCeELMqQ", "a,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p");
  const std::string message = Message(
      20,
      Bytes<std::int8_t>(-5) + Bytes<std::uint8_t>(250) + Bytes<std::int16_t>(-3000) +
          Bytes<std::uint16_t>(60000) + Bytes<std::int32_t>(-70000) +
          Bytes<std::uint32_t>(4000000000U) + Bytes<float>(-0.5F) + Bytes<double>(1e-300) +
          Bytes<std::int16_t>(-12345) + Bytes<std::uint16_t>(54321) + Bytes<std::int32_t>(-7) +
          Bytes<std::uint32_t>(9) + Bytes<std::int32_t>(-425000001) + Bytes<std::uint8_t>(19) +
          Bytes<std::int64_t>(-5000000000) + Bytes<std::uint64_t>(6000000000U));
  ASSERT_EQ(message.size(), 62U);
  const auto recording = Open(Header() + format + message);
  const ReadSamples samples = ReadAll(
      *recording,
      {"ALL", {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n", "o", "p"}});
  EXPECT_THAT(samples.rows.at(0),
              ElementsAre(-5,
                          250,
                          -3000,
                          60000,
                          -70000,
                          4e9,
                          -0.5,
                          1e-300,
                          -123.45,
                          543.21,
                          -0.07,
                          0.09,
                          -42.5000001,
                          19,
                          -5e9,
                          6e9));
}

TEST(Dataflash, ReadsArraysAndHalves) {
  std::string array;
  for (int i = 0; i < 32; ++i) array += Bytes<std::int16_t>(i - 16);
  // 1, -2, the smallest above 0, 65504.
  const auto recording =
      Open(Header() + Fmt(21, 3 + 64 + 8, "ARR", "agggg", "D,a,b,c,d") +
           Message(21,
                   array + Bytes<std::uint16_t>(0x3c00) + Bytes<std::uint16_t>(0xc000) +
                       Bytes<std::uint16_t>(0x0001) + Bytes<std::uint16_t>(0x7bff)));
  const ReadSamples samples = ReadAll(*recording, {"ARR", {"D[0]", "D[31]", "a", "b", "c", "d"}});
  EXPECT_THAT(samples.rows.at(0), ElementsAre(-16, 15, 1, -2, 5.9604644775390625e-8, 65504));
}

TEST(Dataflash, SplitsInstances) {
  std::string bytes = Header() + FmtOfUnits() + Unit('#', "instance") +
                      Fmt(30, 16, "BARO", "QBf", "TimeUS,I,Alt") + Fmtu(30, "-#-", "---");
  for (int i = 0; i < 6; ++i) {
    bytes += Message(
        30, Bytes<std::uint64_t>(1000 * i) + Bytes<std::uint8_t>(i % 2) + Bytes<float>(10.0F * i));
  }
  const auto recording = Open(bytes);
  EXPECT_EQ(ChannelNamed(recording->contents(), "BARO[0]").count, 3U);
  EXPECT_EQ(ChannelNamed(recording->contents(), "BARO[1]").type, "BARO");
  const ReadSamples samples = ReadAll(*recording, {"BARO[1]", {"Alt"}});
  EXPECT_THAT(samples.rows, ElementsAre(ElementsAre(10), ElementsAre(30), ElementsAre(50)));
}

TEST(Dataflash, IsNotMisledByHeadersInPayloads) {
  // A count of 0x95a3 has the bytes a3 95, and the float behind begins with the type of ATT.
  std::string bytes = Header() + FmtOfAtt();
  for (int i = 0; i < 50; ++i) {
    std::string message = Att(1000 * i, 1.0, 0x95a3, 0.0F);
    message[15] = static_cast<char>(kAtt);
    bytes += message;
  }
  const auto recording = Open(bytes);
  EXPECT_EQ(ChannelNamed(recording->contents(), "ATT").count, 50U);
  EXPECT_TRUE(recording->contents().IsComplete());
}

TEST(Dataflash, TakesZerosAtTheEndAsPadding) {
  const auto recording = Open(Header() + FmtOfAtt() + Atts(5) + std::string(528, '\0'));
  EXPECT_EQ(ChannelNamed(recording->contents(), "ATT").count, 5U);
  EXPECT_TRUE(recording->contents().IsComplete());
}

TEST(Dataflash, TellsWhereACutFileEnds) {
  const std::string sound = Header() + FmtOfAtt() + Atts(5);
  const auto recording = Open(sound + Att(5, 1, 1, 1).substr(0, 7));
  const Contents& contents = recording->contents();
  EXPECT_EQ(ChannelNamed(contents, "ATT").count, 5U);
  EXPECT_EQ(contents.read_bytes, sound.size());
  EXPECT_THAT(contents.remarks,
              ElementsAre(HasSubstr("within a message ATT: the 7 bytes from byte " +
                                    std::to_string(sound.size()))));
}

TEST(Dataflash, GoesOnBehindDamageAndTellsHowMuchItSkipped) {
  const std::string before = Header() + FmtOfAtt() + Atts(5);
  const auto recording = Open(before + "some noise" + Atts(7));
  const Contents& contents = recording->contents();
  EXPECT_EQ(ChannelNamed(contents, "ATT").count, 12U);
  EXPECT_EQ(contents.size_bytes - contents.read_bytes, 10U);
  EXPECT_THAT(contents.remarks,
              ElementsAre(HasSubstr("the first at byte " + std::to_string(before.size()))));
}

TEST(Dataflash, GoesOnBehindARecordThatIsShorterThanItsFormat) {
  const auto recording =
      Open(Header() + FmtOfAtt() + Atts(5) + Att(9, 9, 9, 9).substr(0, 11) + Atts(7));
  EXPECT_EQ(ChannelNamed(recording->contents(), "ATT").count, 12U);
  EXPECT_EQ(recording->contents().size_bytes - recording->contents().read_bytes, 11U);
}

TEST(Dataflash, PassesOverATypeWithoutAFormat) {
  const std::string unknown = Message(77, std::string(9, 'x'));
  const auto recording =
      Open(Header() + FmtOfAtt() + Atts(2) + unknown + Atts(2) + unknown + Atts(1));
  EXPECT_EQ(ChannelNamed(recording->contents(), "ATT").count, 5U);
  EXPECT_EQ(recording->contents().size_bytes - recording->contents().read_bytes,
            2 * unknown.size());
}

TEST(Dataflash, KnowsTheTimeFromItsGps) {
  // Week 2418, 100 s into it: 2026-05-10T00:01:40 GPS, 18 s less in UTC; 2 s after the start.
  const std::string gps = Fmt(40, 18, "GPS", "QBIH", "TimeUS,Status,GMS,GWk") +
                          Message(40,
                                  Bytes<std::uint64_t>(1000000) + Bytes<std::uint8_t>(1) +
                                      Bytes<std::uint32_t>(0) + Bytes<std::uint16_t>(0)) +
                          Message(40,
                                  Bytes<std::uint64_t>(2000000) + Bytes<std::uint8_t>(3) +
                                      Bytes<std::uint32_t>(100000) + Bytes<std::uint16_t>(2418));
  const auto recording = Open(Header() + gps);
  EXPECT_EQ(*recording->contents().utc_of_zero, 1778371200.0 + 100.0 - 18.0 - 2.0);
}

TEST(Dataflash, RefusesAFileWithoutAMessage) {
  EXPECT_THAT(ErrorFrom([] { Open(std::string("\xa3\x95", 2)); }),
              HasSubstr("holds no whole message"));
}

TEST(Dataflash, NamesTheChannelsAndFieldsThereAre) {
  const auto recording = Open(Header() + FmtOfAtt() + Atts(2));
  EXPECT_THAT(ErrorFrom([&] {
                ReadAll(*recording, {"RCOU", {"C1"}});
              }),
              HasSubstr("holds no channel 'RCOU', expected one of 'ATT', 'FMT'."));
  EXPECT_THAT(
      ErrorFrom([&] {
        ReadAll(*recording, {"ATT", {"Yaw"}});
      }),
      HasSubstr("ATT has no field 'Yaw', expected one of 'TimeUS', 'Roll', 'Count', 'Rate'"));
}

// Of a file that is cut anywhere, every message before the cut is there.
TEST(Dataflash, DeliversAllBeforeACut) {
  const std::string header = Header() + FmtOfAtt();
  const std::string all = header + Atts(200);
  constexpr std::size_t kMessage = 19;
  RandomStream random(1, "cuts");
  for (int trial = 0; trial < 100; ++trial) {
    const auto length =
        header.size() + kMessage +
        static_cast<std::size_t>(random.Uniform() * (all.size() - header.size() - kMessage));
    const auto recording = Open(all.substr(0, length));
    EXPECT_EQ(ChannelNamed(recording->contents(), "ATT").count,
              (length - header.size()) / kMessage);
    EXPECT_EQ(recording->contents().IsComplete(), (length - header.size()) % kMessage == 0);
  }
}

// Of a file with flipped bits, what comes is finite in number, and most of it is there.
TEST(Dataflash, SurvivesFlippedBits) {
  const std::string all = Header() + FmtOfUnits() + FmtOfAtt() + Unit('d', "deg") + Atts(300);
  RandomStream random(2, "flips");
  for (int trial = 0; trial < 100; ++trial) {
    std::string flipped = all;
    for (int k = 0; k < 5; ++k) {
      const auto at = static_cast<std::size_t>(random.Uniform() * flipped.size());
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << static_cast<int>(8 * random.Uniform())));
    }
    // A flipped FMT may take all of a type with it; the reader then still says so.
    const std::string error = ErrorFrom([&] {
      const auto recording = Open(flipped);
      for (const Channel& channel : recording->contents().channels) {
        if (channel.name != "ATT") continue;
        EXPECT_GE(channel.count + 12, 300U);
        ReadAll(*recording, {"ATT", {channel.fields.front().name}});
      }
    });
    EXPECT_EQ(error, "no error");
  }
}

}  // namespace
}  // namespace fathom
