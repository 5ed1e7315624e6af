// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Bags of ROS 1 and MCAP files, written here from the formats' descriptions.

#include "fathom/base/files/input_file.h"
#include "fathom/base/random_stream.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/recording/decompress.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bag_writer.h"
#include "dataflash_writer.h"
#include "scratch_file.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lz4frame.h>

namespace fathom {
namespace {

using dataflash::Bytes;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// --- ROS 1

// One topic of one number, `count` seconds long.
std::string BagRecords(int first, int count) {
  std::string records = bag::Connection(0, "/depth", "std_msgs/Float64", "float64 data\n");
  for (int i = first; i < first + count; ++i)
    records += bag::Message(0, 1500000000 + i, Bytes(0.5 * i));
  return records;
}

class BagsOf : public ::testing::TestWithParam<const char*> {};

TEST_P(BagsOf, ThisCompressionAreRead) {
  const auto recording = OpenRecording(
      ScratchFile("a.bag",
                  bag::Head() + bag::Chunk(GetParam(), BagRecords(0, 40)) +
                      bag::Chunk(GetParam(), BagRecords(40, 10)) +
                      bag::Connection(0, "/depth", "std_msgs/Float64", "float64 data\n")));
  const Contents& contents = recording->contents();
  EXPECT_EQ(contents.format, "ros1_bag");
  EXPECT_TRUE(contents.IsComplete());
  EXPECT_THAT(contents.remarks, IsEmpty());
  const Channel depth = ChannelNamed(contents, "/depth");
  EXPECT_EQ(depth.type, "std_msgs/Float64");
  EXPECT_EQ(depth.count, 50U);
  EXPECT_EQ(*depth.first, 1500000000.5);
  EXPECT_EQ(*depth.last, 1500000049.5);
  EXPECT_EQ(ReadAll(*recording, {"/depth", {"data"}}).rows[49][0], 24.5);
}

// One buffer takes the chunks one after the other: 3 MB, little, 6 MB.
TEST_P(BagsOf, ThisCompressionMayHaveChunksOfAnySize) {
  const auto recording =
      OpenRecording(ScratchFile("a.bag",
                                bag::Head() + bag::Chunk(GetParam(), BagRecords(0, 40000)) +
                                    bag::Chunk(GetParam(), BagRecords(40000, 10)) +
                                    bag::Chunk(GetParam(), BagRecords(40010, 80000))));
  EXPECT_TRUE(recording->contents().IsComplete());
  const ReadSamples samples = ReadAll(*recording, {"/depth", {"data"}});
  ASSERT_EQ(samples.rows.size(), 120010U);
  for (std::size_t k = 0; k < samples.rows.size(); ++k) ASSERT_EQ(samples.rows[k][0], 0.5 * k);
}

INSTANTIATE_TEST_SUITE_P(Compressions, BagsOf, ::testing::Values("none", "bz2", "lz4"));

// LZ4 writes the sums: of each block, of all, of both. The last byte of a frame with one of all is
// its own.
TEST(Bag, KnowsAnLz4ChunkByItsCheckSums) {
  const std::string records = BagRecords(0, 40000);
  for (const bool has_block_sums : {false, true}) {
    LZ4F_preferences_t preferences = {};
    preferences.frameInfo.contentChecksumFlag = LZ4F_contentChecksumEnabled;
    if (has_block_sums) preferences.frameInfo.blockChecksumFlag = LZ4F_blockChecksumEnabled;
    std::string stored(LZ4F_compressFrameBound(records.size(), &preferences), '\0');
    stored.resize(LZ4F_compressFrame(
        stored.data(), stored.size(), records.data(), records.size(), &preferences));
    const auto open = [&] {
      return OpenRecording(ScratchFile(
          "a.bag",
          bag::Head() + bag::Record({{"compression", "lz4"},
                                     {"op", "\x05"},
                                     {"size", Bytes(static_cast<std::uint32_t>(records.size()))}},
                                    stored)));
    };
    const auto sound = open();
    EXPECT_TRUE(sound->contents().IsComplete());
    EXPECT_EQ(ChannelNamed(sound->contents(), "/depth").count, 40000U);
    stored.back() = static_cast<char>(stored.back() ^ 1);
    EXPECT_FALSE(open()->contents().IsComplete());
  }
}

TEST(Bag, WithoutAnIndexIsReadAndTold) {
  const auto recording =
      OpenRecording(ScratchFile("a.bag", bag::Head(0) + bag::Chunk("none", BagRecords(0, 5))));
  EXPECT_EQ(recording->contents().channels[0].count, 5U);
  EXPECT_THAT(recording->contents().remarks, ElementsAre(HasSubstr("has no index")));
}

// The card of a recorder that lost power holds zeros behind what was written.
TEST(Bag, TakesNoMessageWhoseEndLiesInAZeroedTail) {
  const std::string whole = bag::Head(0) + bag::Chunk("none", BagRecords(1, 5));
  std::string zeroed = whole;
  zeroed.replace(zeroed.size() - 5, 5, 5, '\0');
  const auto recording = OpenRecording(ScratchFile("a.bag", zeroed + std::string(4096, '\0')));
  EXPECT_THAT(ReadAll(*recording, {"/depth", {"data"}}).rows,
              ElementsAre(ElementsAre(0.5), ElementsAre(1), ElementsAre(1.5), ElementsAre(2)));
  EXPECT_FALSE(recording->contents().IsComplete());
}

// Some bytes that promise gigabytes.
TEST(Bag, IsNotUnpackedWhereAChunkIsABomb) {
  for (const char* compression : {"bz2", "lz4"}) {
    const std::string bomb = bag::Record(
        {{"op", "\x05"}, {"compression", compression}, {"size", Bytes<std::uint32_t>(3000000000)}},
        bag::Compressed(compression, std::string(1000000, '\0')));
    const auto path = ScratchFile(std::string(compression) + "_bomb.bag",
                                  bag::Head(0) + bag::Chunk("none", BagRecords(0, 2)) + bomb);
    const auto recording = OpenRecording(path);
    EXPECT_EQ(recording->contents().channels[0].count, 2U);
    EXPECT_THAT(recording->contents().remarks, Contains(HasSubstr("it is not unpacked")));
  }
}

// What it unpacks to is bounded, whatever is promised. LZ4 never gives over 255 times its bytes.
TEST(Decompressed, EndsAtTheBoundOfABomb) {
  const std::string zeros(std::size_t{80} << 20, '\0');
  for (const auto& [name, compression] :
       {std::pair("bz2", Compression::kBzip2), {"zstd", Compression::kZstd}}) {
    const std::string packed = bag::Compressed(name, zeros);
    std::string buffer;
    EXPECT_EQ(Decompressed(compression, packed, zeros.size(), &buffer).size(),
              std::size_t{64} << 20);
  }
}

TEST(Bag, HasOneChannelForSeveralConnectionsOfATopic) {
  const std::string records = bag::Connection(0, "/x", "std_msgs/Float64", "float64 data\n") +
                              bag::Connection(1, "/x", "std_msgs/Float64", "float64 data\n") +
                              bag::Connection(2, "/y", "std_msgs/Int8", "int8 data\n") +
                              bag::Connection(3, "/y", "std_msgs/Float64", "float64 data\n") +
                              bag::Message(0, 1, Bytes(1.0)) + bag::Message(1, 2, Bytes(2.0)) +
                              bag::Message(2, 3, "\x05") + bag::Message(3, 4, Bytes(4.0)) +
                              bag::Message(9, 5, Bytes(5.0));
  const auto recording =
      OpenRecording(ScratchFile("a.bag", bag::Head() + bag::Chunk("none", records)));
  const Contents& contents = recording->contents();
  EXPECT_EQ(ChannelNamed(contents, "/x").count, 2U);
  EXPECT_EQ(ChannelNamed(contents, "/y (std_msgs/Int8)").count, 1U);
  EXPECT_EQ(ChannelNamed(contents, "/y (std_msgs/Float64)").count, 1U);
  EXPECT_THAT(ReadAll(*recording, {"/x", {"data"}}).rows,
              ElementsAre(ElementsAre(1), ElementsAre(2)));
  EXPECT_THAT(contents.remarks, ElementsAre(HasSubstr("1 messages belong to no connection")));
}

TEST(Bag, TellsATypeThatItCannotTakeApart) {
  const std::string records =
      bag::Connection(0, "/x", "a/B", "Unknown u\n") + bag::Message(0, 1, "xx");
  const auto recording =
      OpenRecording(ScratchFile("a.bag", bag::Head() + bag::Chunk("none", records)));
  EXPECT_EQ(recording->contents().channels[0].count, 1U);
  EXPECT_THAT(recording->contents().remarks,
              ElementsAre(HasSubstr("/x cannot be read: message type a/B")));
}

TEST(Bag, TellsWhereHeadersHaveAnotherClock) {
  const char definition[] =
      "Header header\nfloat64 x\n===\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring "
      "frame_id\n";
  const std::string message = Bytes<std::uint32_t>(0) + Bytes<std::uint32_t>(900) +
                              Bytes<std::uint32_t>(0) + bag::WithLength("") + Bytes(1.0);
  const auto recording = OpenRecording(
      ScratchFile("a.bag",
                  bag::Head() + bag::Chunk("none",
                                           bag::Connection(0, "/x", "a/B", definition) +
                                               bag::Message(0, 1500000000, message))));
  EXPECT_THAT(recording->contents().remarks, Contains(HasSubstr("another clock, 900.000 s")));
}

// Every message before a cut is there; of a compressed chunk as far as it goes.
TEST_P(BagsOf, ThisCompressionAreReadUpToACut) {
  const std::string all = bag::Head() + bag::Chunk(GetParam(), BagRecords(0, 100)) +
                          bag::Chunk(GetParam(), BagRecords(100, 100));
  const std::size_t first_chunk =
      bag::Head().size() + bag::Chunk(GetParam(), BagRecords(0, 100)).size();
  RandomStream random(6, "cuts");
  for (int trial = 0; trial < 100; ++trial) {
    const auto length =
        bag::Head().size() +
        static_cast<std::size_t>(random.Uniform() *
                                 static_cast<double>(all.size() - bag::Head().size()));
    const auto recording = OpenRecording(ScratchFile("cut.bag", all.substr(0, length)));
    const Contents& contents = recording->contents();
    const std::uint64_t count = contents.channels.empty() ? 0 : contents.channels[0].count;
    EXPECT_LE(contents.read_bytes, length);
    if (length < first_chunk) {
      EXPECT_LE(count, 100U);
    } else {
      EXPECT_GE(count, 100U);
      EXPECT_LE(count, 200U);
    }
    if (length != first_chunk) {
      EXPECT_FALSE(contents.IsComplete());
    }
  }
}

TEST_P(BagsOf, ThisCompressionSurviveFlippedBits) {
  const std::string all = bag::Head() + bag::Chunk(GetParam(), BagRecords(0, 100));
  RandomStream random(7, "flips");
  for (int trial = 0; trial < 100; ++trial) {
    std::string flipped = all;
    for (int k = 0; k < 3; ++k) {
      const auto at =
          static_cast<std::size_t>(random.Uniform() * static_cast<double>(flipped.size()));
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << static_cast<int>(8 * random.Uniform())));
    }
    ErrorFrom([&] {
      const auto recording = OpenRecording(ScratchFile("flipped.bag", flipped));
      for (const Channel& channel : recording->contents().channels) {
        EXPECT_LE(channel.count, 101U);
        for (const Field& field : channel.fields) ReadAll(*recording, {channel.name, {field.name}});
      }
    });
  }
}

// --- MCAP

std::string McapRecord(char op, const std::string& content) {
  return std::string(1, op) + Bytes(static_cast<std::uint64_t>(content.size())) + content;
}

const std::string kMcapMagic = "\x89MCAP0\r\n";

std::string McapHead() {
  return kMcapMagic + McapRecord(1, bag::WithLength("ros2") + bag::WithLength("test"));
}

std::string McapSchemaAndChannel() {
  return McapRecord(3,
                    Bytes<std::uint16_t>(1) + bag::WithLength("std_msgs/msg/Float64") +
                        bag::WithLength("ros2msg") + bag::WithLength("float64 data\n")) +
         McapRecord(4,
                    Bytes<std::uint16_t>(5) + Bytes<std::uint16_t>(1) + bag::WithLength("/depth") +
                        bag::WithLength("cdr") + bag::WithLength(""));
}

std::string McapMessages(int first, int count) {
  std::string records;
  for (int i = first; i < first + count; ++i) {
    const std::uint64_t time = 1500000000500000000U + 1000000000U * static_cast<std::uint64_t>(i);
    records += McapRecord(5,
                          Bytes<std::uint16_t>(5) + Bytes<std::uint32_t>(i) + Bytes(time) +
                              Bytes(time) + std::string("\0\1\0\0", 4) + Bytes(0.5 * i));
  }
  return records;
}

std::string McapChunk(const std::string& compression, const std::string& records) {
  const std::string stored = bag::Compressed(compression, records);
  return McapRecord(6,
                    Bytes<std::uint64_t>(0) + Bytes<std::uint64_t>(1) +
                        Bytes(static_cast<std::uint64_t>(records.size())) +
                        Bytes<std::uint32_t>(0) + bag::WithLength(compression) +
                        Bytes(static_cast<std::uint64_t>(stored.size())) + stored);
}

std::string McapEnd() {
  return McapRecord(15, Bytes<std::uint32_t>(0)) + McapRecord(2, std::string(20, '\0')) +
         kMcapMagic;
}

class McapOf : public ::testing::TestWithParam<const char*> {};

TEST_P(McapOf, ThisCompressionIsRead) {
  const auto recording = OpenRecording(
      ScratchFile("a.mcap",
                  McapHead() + McapChunk(GetParam(), McapSchemaAndChannel() + McapMessages(0, 40)) +
                      McapChunk(GetParam(), McapMessages(40, 10)) + McapEnd()));
  const Contents& contents = recording->contents();
  EXPECT_EQ(contents.format, "mcap");
  EXPECT_TRUE(contents.IsComplete());
  EXPECT_THAT(contents.remarks, IsEmpty());
  const Channel depth = ChannelNamed(contents, "/depth");
  EXPECT_EQ(depth.count, 50U);
  EXPECT_EQ(*depth.last, 1500000049.5);
  EXPECT_EQ(ReadAll(*recording, {"/depth", {"data"}}).rows[49][0], 24.5);
}

TEST_P(McapOf, ThisCompressionIsReadUpToACut) {
  const std::string head =
      McapHead() + McapChunk(GetParam(), McapSchemaAndChannel() + McapMessages(0, 50));
  const std::string all = head + McapChunk(GetParam(), McapMessages(50, 50)) + McapEnd();
  RandomStream random(8, "cuts");
  for (int trial = 0; trial < 100; ++trial) {
    const auto length =
        static_cast<std::size_t>(8 + random.Uniform() * static_cast<double>(all.size() - 8));
    const auto recording = OpenRecording(ScratchFile("cut.mcap", all.substr(0, length)));
    const Contents& contents = recording->contents();
    const std::uint64_t count = contents.channels.empty() ? 0 : contents.channels[0].count;
    if (length >= head.size()) {
      EXPECT_GE(count, 50U);
    }
    EXPECT_LE(count, 100U);
    EXPECT_THAT(contents.remarks, testing::Not(IsEmpty()));
  }
}

TEST_P(McapOf, ThisCompressionSurvivesFlippedBits) {
  const std::string all =
      McapHead() + McapChunk(GetParam(), McapSchemaAndChannel() + McapMessages(0, 100)) + McapEnd();
  RandomStream random(9, "flips");
  for (int trial = 0; trial < 100; ++trial) {
    std::string flipped = all;
    for (int k = 0; k < 3; ++k) {
      const auto at =
          static_cast<std::size_t>(8 + random.Uniform() * static_cast<double>(flipped.size() - 8));
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << static_cast<int>(8 * random.Uniform())));
    }
    ErrorFrom([&] {
      const auto recording = OpenRecording(ScratchFile("flipped.mcap", flipped));
      for (const Channel& channel : recording->contents().channels) {
        for (const Field& field : channel.fields) ReadAll(*recording, {channel.name, {field.name}});
      }
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Compressions, McapOf, ::testing::Values("", "lz4", "zstd"));

TEST(Mcap, WithoutChunksAndSummaryIsRead) {
  const auto recording = OpenRecording(
      ScratchFile("a.mcap", McapHead() + McapSchemaAndChannel() + McapMessages(0, 7)));
  EXPECT_EQ(recording->contents().channels[0].count, 7U);
  EXPECT_TRUE(recording->contents().IsComplete());
  EXPECT_THAT(recording->contents().remarks, ElementsAre(HasSubstr("was not closed")));
}

// As `ros2 bag record --compression-mode message` writes them.
// Some bytes that promise a hundred megabytes.
TEST(Mcap, IsNotUnpackedWhereAChunkIsABomb) {
  const std::string sound = McapHead() + McapChunk("", McapSchemaAndChannel() + McapMessages(0, 2));
  for (const char* compression : {"lz4", "zstd"}) {
    const std::string stored = bag::Compressed(compression, std::string(100000, '\0'));
    const std::string bomb = McapRecord(
        6,
        Bytes<std::uint64_t>(0) + Bytes<std::uint64_t>(1) + Bytes<std::uint64_t>(100000000) +
            Bytes<std::uint32_t>(0) + bag::WithLength(compression) +
            Bytes(static_cast<std::uint64_t>(stored.size())) + stored);
    const auto recording = OpenRecording(
        ScratchFile(std::string(compression) + "_bomb.mcap", sound + bomb + McapEnd()));
    EXPECT_EQ(ChannelNamed(recording->contents(), "/depth").count, 2U);
    EXPECT_THAT(recording->contents().remarks,
                Contains(AllOf(HasSubstr(std::to_string(stored.size()) + " bytes unpack to"),
                               HasSubstr("100000000: it is not unpacked"))));
  }
}

// A rosbag2 database a.db3 of /depth; `messages` as values of SQL, may be none.
std::filesystem::path DepthDatabase(const std::string& messages) {
  const auto path = ScratchFile("a.db3", "");
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
  database.exec("CREATE TABLE topics (id INTEGER PRIMARY KEY, name TEXT, type TEXT)");
  database.exec(
      "CREATE TABLE messages (id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data "
      "BLOB)");
  database.exec("INSERT INTO topics VALUES (1, '/depth', 'std_msgs/msg/Float64')");
  if (!messages.empty()) database.exec("INSERT INTO messages VALUES " + messages);
  return path;
}

TEST(Rosbag2, UnpacksMessagesThatAreCompressedOneByOne) {
  const auto path = DepthDatabase("");
  {
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
    SQLite::Statement insert(database, "INSERT INTO messages VALUES (?, 1, ?, ?)");
    for (int i = 0; i < 3; ++i) {
      const std::string message = std::string("\0\1\0\0", 4) + Bytes(0.5 * i);
      std::string packed = bag::Compressed("zstd", message);
      if (i == 2) packed.resize(5);
      insert.bind(1, i + 1);
      insert.bind(2, std::int64_t{1500000000} * 1000000000 + i);
      insert.bind(3, packed.data(), static_cast<int>(packed.size()));
      insert.exec();
      insert.reset();
    }
  }
  const auto recording = OpenRecording(path);
  EXPECT_THAT(ReadAll(*recording, {"/depth", {"data"}}).rows,
              ElementsAre(ElementsAre(0.0), ElementsAre(0.5)));
  EXPECT_THAT(recording->contents().remarks,
              ElementsAre(HasSubstr("1 messages are compressed by zstd and cannot be unpacked")));
}

// As `ros2 bag record --compression-mode file` writes them.
TEST(Rosbag2, IsUnpackedWhereItIsCompressedAsAWhole) {
  const auto plain = DepthDatabase("(1, 1, 1500000000500000000, x'000100000000000000002940')");
  const std::string packed = bag::Compressed("zstd", ReadFile(plain));
  const auto recording = OpenRecording(ScratchFile("a.db3.zstd", packed));
  EXPECT_THAT(ReadAll(*recording, {"/depth", {"data"}}).rows, ElementsAre(ElementsAre(12.5)));
  EXPECT_TRUE(IsRecording(ScratchFile("a.db3.zstd", packed)));
  // A compressed file of another kind is none, nor is another database.
  EXPECT_FALSE(IsRecording(ScratchFile("text.zstd", bag::Compressed("zstd", "t,u\n0,1\n"))));
  EXPECT_FALSE(IsRecording(ScratchFile("a.sqlite.zstd", packed)));
  EXPECT_FALSE(IsRecording(ScratchFile("a.db3.zstd", packed.substr(0, 6))));
  const auto error = [&](const std::string& bytes) {
    return ErrorFrom([&] { OpenRecording(ScratchFile("b.db3.zstd", bytes)); });
  };
  EXPECT_THAT(error(packed.substr(0, packed.size() / 2)), HasSubstr("ends within a frame"));
  EXPECT_THAT(error(bag::Compressed("zstd", std::string(std::size_t{80} << 20, '\0'))),
              HasSubstr("unpack to over 67108864: no recording does"));
  EXPECT_THAT(error(bag::Compressed("zstd", bag::Compressed("zstd", packed))),
              HasSubstr("b.db3.zstd: is of no known format"));
}

TEST(Rosbag2, TellsMessagesOfNoTopic) {
  const auto recording =
      OpenRecording(DepthDatabase("(1, 1, 1500000000500000000, x'000100000000000000002940'),"
                                  "(2, 7, 1500000001500000000, x'000100000000000000002940')"));
  EXPECT_THAT(ReadAll(*recording, {"/depth", {"data"}}).rows, ElementsAre(ElementsAre(12.5)));
  EXPECT_THAT(recording->contents().remarks, ElementsAre("1 messages belong to no topic."));
}

}  // namespace
}  // namespace fathom
