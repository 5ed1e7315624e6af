// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Logs of Rock, written here from the format's description.

#include "fathom/base/input_error.h"
#include "fathom/base/random_stream.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/suggest_map.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "constant_recording.h"
#include "dataflash_writer.h"
#include "scratch_file.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

namespace fathom {
namespace {

using dataflash::Bytes;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string Counted(const std::string& text) {
  return Bytes(static_cast<std::uint32_t>(text.size())) + text;
}

std::string Prologue(std::uint32_t version = 2, std::uint32_t big_endian = 0) {
  return std::string("POCOSIM\0", 8) + Bytes(version) + Bytes(big_endian);
}

std::string Block(char kind, std::uint16_t stream, const std::string& payload) {
  return std::string{kind, '\xff'} + Bytes(stream) + Counted(payload);
}

std::string StreamBlock(std::uint16_t stream,
                        const std::string& name,
                        const std::string& type,
                        const std::string& types) {
  return Block(1,
               stream,
               '\1' + Counted(name) + Counted(type) +
                   Counted("<?xml version=\"1.0\"?>\n<typelib>\n" + types + "</typelib>\n") +
                   Counted("--- {}\n"));
}

std::string SampleBlock(std::uint16_t stream,
                        std::uint32_t seconds,
                        std::uint32_t microseconds,
                        const std::string& data,
                        bool is_packed = false) {
  // The real time is a second later than the logical one.
  return Block(2,
               stream,
               Bytes(seconds + 1) + Bytes(microseconds) + Bytes(seconds) + Bytes(microseconds) +
                   Bytes(static_cast<std::uint32_t>(data.size())) + (is_packed ? '\1' : '\0') +
                   data);
}

constexpr const char* kDouble = "<numeric name=\"/double\" category=\"float\" size=\"8\"/>\n";
constexpr const char* kInt32 = "<numeric name=\"/int32_t\" category=\"sint\" size=\"4\"/>\n";
constexpr const char* kInt8 = "<numeric name=\"/int8_t\" category=\"sint\" size=\"1\"/>\n";
constexpr const char* kString =
    "<container name=\"/std/string\" of=\"/int8_t\" size=\"8\" kind=\"/std/string\"/>\n";
constexpr const char* kTime =
    "<numeric name=\"/int64_t\" category=\"sint\" size=\"8\"/>\n"
    "<compound name=\"/base/Time\" size=\"8\"><field name=\"microseconds\" type=\"/int64_t\" "
    "offset=\"0\"/></compound>\n";

// `count` samples of one number, half a second apart.
std::string Ramp(int count) {
  std::string bytes = Prologue() + StreamBlock(3, "/task.depth", "/double", kDouble);
  for (int i = 0; i < count; ++i) {
    bytes += SampleBlock(3, 1500000000 + i / 2, i % 2 * 500000, Bytes(0.25 * i));
  }
  return bytes;
}

TEST(Pocolog, NumbersAreReadAtTheirLogicalTime) {
  const auto recording = OpenRecording(ScratchFile("a.0.log", Ramp(5)));
  const Contents& contents = recording->contents();
  EXPECT_EQ(contents.format, "pocolog");
  EXPECT_TRUE(contents.IsComplete());
  EXPECT_THAT(contents.remarks, IsEmpty());
  const Channel depth = ChannelNamed(contents, "/task.depth");
  EXPECT_EQ(depth.type, "/double");
  EXPECT_EQ(depth.count, 5U);
  EXPECT_EQ(*depth.first, 1500000000.0);
  EXPECT_EQ(*depth.last, 1500000002.0);
  const ReadSamples read = ReadAll(*recording, {"/task.depth", {"value"}});
  EXPECT_EQ(read.time[1], 1500000000.5);
  EXPECT_EQ(read.rows[4][0], 1.0);
}

// The bytes are those of a struct of this compiler, with the padding that it makes.
TEST(Pocolog, PaddingIsWhereTheProgramHadIt) {
  struct Inner {
    double value;
    std::int8_t flag;  // and 7 bytes of padding, also at the end of an array's element
  };
  struct Outer {
    std::int8_t first;  // and 7 bytes
    Inner inner[2];
    std::int32_t last;  // and 4 bytes, which are not written
  };
  Outer outer = {};
  outer.first = 5;
  outer.inner[0] = {1.5, -1};
  outer.inner[1] = {2.5, -2};
  outer.last = 77;
  const std::string all(reinterpret_cast<const char*>(&outer), sizeof(outer));
  const std::string types = fmt::format(
      "{}{}{}"
      "<compound name=\"/Inner\" size=\"{}\"><field name=\"value\" type=\"/double\" offset=\"0\"/>"
      "<field name=\"flag\" type=\"/int8_t\" offset=\"8\"/></compound>\n"
      "<compound name=\"/Outer\" size=\"{}\"><field name=\"first\" type=\"/int8_t\" offset=\"0\"/>"
      "<field name=\"inner\" type=\"/Inner[2]\" offset=\"8\"/>"
      "<field name=\"last\" type=\"/int32_t\" offset=\"{}\"/></compound>\n",
      kDouble,
      kInt8,
      kInt32,
      sizeof(Inner),
      sizeof(Outer),
      offsetof(Outer, last));
  const auto recording =
      OpenRecording(ScratchFile("a.0.log",
                                Prologue() + StreamBlock(0, "s", "/Outer", types) +
                                    SampleBlock(0, 10, 0, all.substr(0, all.size() - 4))));
  EXPECT_THAT(recording->contents().remarks, IsEmpty());
  const ReadSamples read = ReadAll(
      *recording, {"s", {"first", "inner[0].value", "inner[0].flag", "inner[1].value", "last"}});
  EXPECT_THAT(read.rows[0], ElementsAre(5.0, 1.5, -1.0, 2.5, 77.0));
}

// Texts and sequences of another length in each sample move what stands behind them.
TEST(Pocolog, TextsAndSequencesBeforeANumberArePassedOver) {
  const std::string types =
      std::string(kDouble) + kInt8 + kString + kTime +
      "<container name=\"/std/vector&lt;/std/string&gt;\" of=\"/std/string\" size=\"24\" "
      "kind=\"/std/vector\"/>\n"
      "<container name=\"/std/vector&lt;/double&gt;\" of=\"/double\" size=\"24\" "
      "kind=\"/std/vector\"/>\n"
      "<compound name=\"/Joints\" size=\"56\">"
      "<field name=\"names\" type=\"/std/vector&lt;/std/string&gt;\" offset=\"0\"/>"
      "<field name=\"efforts\" type=\"/std/vector&lt;/double&gt;\" offset=\"24\"/>"
      "<field name=\"time\" type=\"/base/Time\" offset=\"48\"/></compound>\n";
  const auto length = [](std::uint64_t count) { return Bytes(count); };
  const std::string two = length(2) + length(5) + "Surge" + length(3) + "Yaw" + length(2) +
                          Bytes(1.0) + Bytes(2.0) + Bytes<std::int64_t>(1433350623677131);
  const std::string none = length(0) + length(0) + Bytes<std::int64_t>(1433350623777131);
  const auto recording =
      OpenRecording(ScratchFile("a.0.log",
                                Prologue() + StreamBlock(0, "/forces", "/Joints", types) +
                                    SampleBlock(0, 10, 0, two) + SampleBlock(0, 11, 0, none)));
  const ReadSamples read = ReadAll(*recording, {"/forces", {"efforts[1]", "time"}});
  EXPECT_EQ(read.rows[0][0], 2.0);
  EXPECT_EQ(read.rows[0][1], 1433350623.677131);
  EXPECT_TRUE(std::isnan(read.rows[1][0]));
  EXPECT_EQ(read.rows[1][1], 1433350623.777131);
  EXPECT_THAT(recording->contents().remarks, Contains(HasSubstr("time is of another clock")));
}

TEST(Pocolog, PackedSamplesAreUnpacked) {
  const std::string plain = Bytes(3.25);
  std::string packed(compressBound(plain.size()), '\0');
  uLongf size = packed.size();
  ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()),
                     &size,
                     reinterpret_cast<const Bytef*>(plain.data()),
                     plain.size()),
            Z_OK);
  packed.resize(size);
  const auto recording = OpenRecording(ScratchFile(
      "a.0.log",
      Prologue() + StreamBlock(0, "s", "/double", kDouble) + SampleBlock(0, 10, 0, packed, true)));
  EXPECT_EQ(ReadAll(*recording, {"s", {"value"}}).rows[0][0], 3.25);
}

struct BadType {
  const char* types;
  const char* message;
};

class PocologTypes : public ::testing::TestWithParam<BadType> {};

TEST_P(PocologTypes, ThatCannotBeReadAreTold) {
  const auto recording =
      OpenRecording(ScratchFile("a.0.log",
                                Prologue() + StreamBlock(0, "s", "/T", GetParam().types) +
                                    SampleBlock(0, 10, 0, Bytes(1.0))));
  EXPECT_EQ(ChannelNamed(recording->contents(), "s").count, 1U);
  EXPECT_THAT(recording->contents().remarks, Contains(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    Types,
    PocologTypes,
    ::testing::Values(
        BadType{"", "its description holds no type '/T'"},
        BadType{"<alias name=\"/T\" source=\"/T\"/>", "one that holds itself"},
        BadType{"<compound name=\"/T\" size=\"8\"><field name=\"a\" type=\"/T\" offset=\"0\"/>"
                "<field name=\"b\" type=\"/T\" offset=\"0\"/></compound>",
                "type '/T' holds itself"},
        BadType{"<opaque name=\"/T\" size=\"8\" marshal_as=\"/U\"/>",
                "holds '/T', which is 'opaque' and cannot be read"},
        BadType{"<numeric name=\"/T\" category=\"float\" size=\"3\"/>",
                "no number of a known kind"},
        BadType{"<compound name=\"/T\" size=\"-8\"></compound>", "size of '/T' is '-8'"},
        BadType{"<compound name=\"/T\" size=\"8\">", "is no XML at byte"}));

TEST(Pocolog, OtherVersionsAndMachinesAreRefused) {
  EXPECT_THAT(ErrorFrom([] { OpenRecording(ScratchFile("a.log", Prologue(1))); }),
              HasSubstr("has version 1 of pocolog, expected 2"));
  EXPECT_THAT(ErrorFrom([] { OpenRecording(ScratchFile("a.log", Prologue(2, 1))); }),
              HasSubstr("the most significant byte first"));
  EXPECT_THAT(ErrorFrom([] { OpenRecording(ScratchFile("a.log", Prologue().substr(0, 12))); }),
              HasSubstr("ends within its first 16 bytes"));
}

TEST(Pocolog, CutAtAnyPlaceIsReadUpToThere) {
  const std::string all = Ramp(50);
  const std::size_t head = Ramp(0).size(), sample = (all.size() - head) / 50;
  RandomStream random(7, "cuts");
  for (int i = 0; i < 100; ++i) {
    const std::size_t length =
        head + static_cast<std::size_t>(random.Uniform() * static_cast<double>(all.size() - head));
    const auto recording = OpenRecording(ScratchFile("cut.0.log", all.substr(0, length)));
    const Contents& contents = recording->contents();
    const std::size_t whole = (length - head) / sample;
    EXPECT_EQ(ChannelNamed(contents, "/task.depth").count, whole);
    EXPECT_EQ(contents.read_bytes, head + whole * sample);
    if (contents.IsComplete()) continue;
    EXPECT_THAT(
        contents.remarks,
        Contains(HasSubstr(fmt::format("cut or damaged at byte {}", head + whole * sample))));
  }
}

TEST(Pocolog, FlippedBitsNeitherCrashNorHang) {
  const std::string all = Ramp(50);
  RandomStream random(8, "flips");
  for (int i = 0; i < 100; ++i) {
    std::string flipped = all;
    for (int k = 0; k < 10; ++k) {
      const auto at = static_cast<std::size_t>(random.Uniform() * static_cast<double>(all.size()));
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << static_cast<int>(8 * random.Uniform())));
    }
    try {
      const auto recording = OpenRecording(ScratchFile("flipped.0.log", flipped));
      for (const Channel& channel : recording->contents().channels) {
        EXPECT_LE(channel.count, 50U);
        for (const Field& field : channel.fields) ReadAll(*recording, {channel.name, {field.name}});
      }
    } catch (const InputError&) {
      // Of a prologue that is none.
    }
  }
}

TEST(RockMap, TakesSixEffortsAndTheState) {
  const auto vector = [](int number) {
    std::vector<Field> fields;
    for (int i = 0; i < number; ++i) fields.push_back({fmt::format("elements[{}].effort", i), ""});
    fields.push_back({"time", "s"});
    return fields;
  };
  Contents contents;
  contents.format = "pocolog";
  contents.channels = {{"/pwm.out", "/base/samples/Joints", vector(4), 900, 0.0, 90.0},
                       {"/control.forces", "/base/samples/Joints", vector(6), 300, 0.0, 90.0},
                       {"/pose.samples",
                        "/base/samples/RigidBodyState_m",
                        {{"position.data[0]", ""}},
                        90,
                        0.0,
                        90.0}};
  const SuggestedMap suggested = SuggestMap(ConstantRecording(contents), std::nullopt);
  EXPECT_FALSE(suggested.is_ready);
  const ImportMap map = ParseImportMap("suggested", suggested.text);
  ASSERT_TRUE(map.command && map.pose);
  EXPECT_FALSE(map.velocity);
  EXPECT_EQ(map.command->channel, "/control.forces");
  EXPECT_EQ(map.pose->channel, "/pose.samples");
}

}  // namespace
}  // namespace fathom
