// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Bags of ROS 1 that are listed by their index.

#include "fathom/base/random_stream.h"
#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "bag_writer.h"
#include "dataflash_writer.h"
#include "scratch_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using dataflash::Bytes;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::uint32_t kStart = 1500000000;  // [s]
constexpr int kPerChunk = 50;

std::string Depth() { return bag::Connection(0, "/depth", "std_msgs/Float64", "float64 data\n"); }

std::string Messages(int chunk) {
  std::string records;
  for (int i = chunk * kPerChunk; i < (chunk + 1) * kPerChunk; ++i) {
    records += bag::Message(0, kStart + i, Bytes(0.5 * i));
  }
  return records;
}

// A closed bag: three chunks with an index each, and the connection once more. The index behind
// the second chunk is of `listed` messages.
struct ClosedBag {
  explicit ClosedBag(const std::string& compression, int listed = kPerChunk) {
    for (int k = 0; k < 3; ++k) {
      chunks[k] = bag::Chunk(compression, (k == 0 ? Depth() : "") + Messages(k));
      indices[k] = bag::Index(0, kStart + k * kPerChunk, k == 1 ? listed : kPerChunk);
    }
  }

  std::string Bytes() const {
    std::string body;
    for (int k = 0; k < 3; ++k) body += chunks[k] + indices[k];
    return bag::Head(bag::Head().size() + body.size()) + body + Depth();
  }

  std::string chunks[3], indices[3];
};

class ClosedBagsOf : public ::testing::TestWithParam<const char*> {};

TEST_P(ClosedBagsOf, ThisCompressionAreListedAsTheyAreRead) {
  const auto recording = OpenRecording(ScratchFile("a.bag", ClosedBag(GetParam()).Bytes()));
  EXPECT_TRUE(recording->contents().IsComplete());
  EXPECT_THAT(recording->contents().remarks, IsEmpty());
  const Channel depth = ChannelNamed(recording->contents(), "/depth");
  EXPECT_EQ(depth.count, 150U);
  EXPECT_EQ(*depth.first, 1500000000.5);
  EXPECT_EQ(*depth.last, 1500000149.5);
  const ReadSamples read = ReadAll(*recording, {"/depth", {"data"}});
  ASSERT_EQ(read.rows.size(), 150U);
  for (std::size_t k = 0; k < read.rows.size(); ++k) ASSERT_EQ(read.rows[k][0], 0.5 * k);
  EXPECT_THAT(read.remarks, IsEmpty());
}

// The list does not unpack the second chunk.
TEST_P(ClosedBagsOf, ThisCompressionTellDamageBehindTheIndexWhenTheyAreRead) {
  ClosedBag damaged(GetParam());
  std::string& chunk = damaged.chunks[1];
  chunk.replace(chunk.size() / 2, 40, std::string(40, '\xff'));
  const auto recording = OpenRecording(ScratchFile("a.bag", damaged.Bytes()));
  EXPECT_EQ(ChannelNamed(recording->contents(), "/depth").count, 150U);
  const ReadSamples read = ReadAll(*recording, {"/depth", {"data"}});
  EXPECT_GE(read.rows.size(), 50U);
  EXPECT_LT(read.rows.size(), 100U);
  EXPECT_THAT(read.remarks, Contains(HasSubstr("cut or damaged at byte")));
  EXPECT_THAT(read.remarks, Contains(HasSubstr("the index lists 150 messages")));
}

TEST_P(ClosedBagsOf, ThisCompressionTellAnIndexOfOtherMessages) {
  const auto recording = OpenRecording(ScratchFile("a.bag", ClosedBag(GetParam(), 49).Bytes()));
  EXPECT_THAT(ReadAll(*recording, {"/depth", {"data"}}).remarks,
              ElementsAre("the index lists 149 messages, 150 are read."));
}

// The messages themselves are counted where the index is in part, damaged, or of no use.
TEST_P(ClosedBagsOf, ThisCompressionAreListedWithoutAnUnsoundIndex) {
  ClosedBag of_size(GetParam()), of_connection(GetParam());
  of_size.indices[1].replace(of_size.indices[1].find("count=") + 6, 1, "\x31");
  of_connection.indices[1].replace(of_connection.indices[1].find("conn=") + 5, 1, "\x07");
  for (const ClosedBag& unsound : {of_size, of_connection}) {
    const auto recording = OpenRecording(ScratchFile("a.bag", unsound.Bytes()));
    EXPECT_EQ(ChannelNamed(recording->contents(), "/depth").count, 150U);
    EXPECT_THAT(ReadAll(*recording, {"/depth", {"data"}}).remarks, IsEmpty());
  }
}

// Of a file that is cut nothing is believed that is not there.
TEST_P(ClosedBagsOf, ThisCompressionAreListedAsTheyAreReadUpToACut) {
  const std::string all = ClosedBag(GetParam()).Bytes();
  RandomStream random(11, "cuts");
  for (int trial = 0; trial < 100; ++trial) {
    const auto length =
        200 + static_cast<std::size_t>(random.Uniform() * static_cast<double>(all.size() - 200));
    const auto recording = OpenRecording(ScratchFile("cut.bag", all.substr(0, length)));
    for (const Channel& channel : recording->contents().channels) {
      if (channel.fields.empty()) continue;
      const ReadSamples read = ReadAll(*recording, {channel.name, {"data"}});
      EXPECT_EQ(channel.count, read.rows.size()) << length;
      EXPECT_THAT(read.remarks, IsEmpty()) << length;
    }
  }
}

TEST_P(ClosedBagsOf, ThisCompressionTellWhatIsNotAsListed) {
  const std::string all = ClosedBag(GetParam()).Bytes();
  RandomStream random(12, "flips");
  for (int trial = 0; trial < 200; ++trial) {
    std::string flipped = all;
    const auto at = static_cast<std::size_t>(random.Uniform() * static_cast<double>(all.size()));
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << static_cast<int>(8 * random.Uniform())));
    ErrorFrom([&] {
      const auto recording = OpenRecording(ScratchFile("flipped.bag", flipped));
      for (const Channel& channel : recording->contents().channels) {
        if (channel.fields.empty()) continue;
        const ReadSamples read = ReadAll(*recording, {channel.name, {channel.fields[0].name}});
        EXPECT_EQ(read.remarks.empty(), read.rows.size() == channel.count) << at;
      }
    });
  }
}

TEST(ClosedBag, TellsItsDamageInTheLogThatIsMadeOfIt) {
  ClosedBag damaged("lz4");
  damaged.chunks[2].back() = '\x01';  // of the mark of the frame's end
  const auto path = ScratchFile("a.bag", damaged.Bytes());
  const ImportMap map =
      ParseImportMap("map",
                     "command: {channel: /depth, frame: FRD, tau_surge: {field: data, unit: N}}\n"
                     "velocity: {channel: /depth, frame: FRD, u: {field: data, unit: m/s}}\n");
  const ImportedLog imported = ImportLog(path, *OpenRecording(path), map, std::nullopt);
  EXPECT_THAT(imported.remarks, Contains(HasSubstr("cut or damaged at byte")));
}

INSTANTIATE_TEST_SUITE_P(Compressions, ClosedBagsOf, ::testing::Values("none", "bz2", "lz4"));

}  // namespace
}  // namespace fathom
