// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ros/mcap_file.h"

#include "fathom/import/recording/byte_file.h"
#include "fathom/import/recording/decompress.h"
#include "fathom/import/recording/number_type.h"
#include "fathom/import/ros/ros_definition.h"

#include <map>
#include <optional>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";
constexpr std::size_t kRecordHead = 9;                            // op, length
constexpr std::uint64_t kLargestRecord = std::uint64_t{1} << 28;  // [bytes]

constexpr char kFooter = 0x02;
constexpr char kSchema = 0x03;
constexpr char kChannel = 0x04;
constexpr char kMessage = 0x05;
constexpr char kChunk = 0x06;

// Takes one value after the other from the content of a record; not good once one is not there.
class Content {
 public:
  explicit Content(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  T Number() {
    const std::string_view raw = Bytes(sizeof(T));
    return raw.size() == sizeof(T) ? NumberAt<T>(raw, 0) : T{};
  }

  std::string_view Text() { return Bytes(Number<std::uint32_t>()); }

  std::string_view Bytes(std::uint64_t size) {
    if (size > bytes_.size()) is_good_ = false;
    if (!is_good_) return {};
    const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(size));
    bytes_.remove_prefix(static_cast<std::size_t>(size));
    return taken;
  }

  std::string_view Rest() const { return bytes_; }
  bool is_good() const { return is_good_; }

 private:
  std::string_view bytes_;
  bool is_good_ = true;
};

struct Schema {
  std::string name, encoding, text;
};

// What one walk knows.
struct Walker {
  std::vector<MessageChannel>* channels;
  const MessageSink* take;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, std::size_t> channel_of;  // by the channel's number
  std::uint64_t num_unknown = 0;                    // messages of no channel

  bool TakeSchema(Content content) {
    const auto number = content.Number<std::uint16_t>();
    Schema schema;
    schema.name = content.Text();
    schema.encoding = content.Text();
    schema.text = content.Text();
    if (content.is_good()) schemas[number] = std::move(schema);
    return content.is_good();
  }

  bool TakeChannel(Content content) {
    const auto number = content.Number<std::uint16_t>();
    const auto schema_number = content.Number<std::uint16_t>();
    MessageChannel channel;
    channel.topic = content.Text();
    const std::string_view encoding = content.Text();
    if (!content.is_good() || channel_of.contains(number)) return content.is_good();
    const Schema schema = schemas[schema_number];
    channel.type = schema.name;
    channel.encoding = encoding == "ros1" ? MessageEncoding::kRos1 : MessageEncoding::kCdr;
    if (schema.encoding == "ros1msg" || schema.encoding == "ros2msg") {
      channel.definition = schema.text;
    } else if (encoding == "cdr") {
      channel.definition = KnownDefinition(channel.type);
    }
    channel_of[number] = channels->size();
    channels->push_back(std::move(channel));
    return true;
  }

  bool TakeMessage(Content content) {
    const auto number = content.Number<std::uint16_t>();
    content.Number<std::uint32_t>();  // of the sequence
    const auto log_time = content.Number<std::uint64_t>();
    content.Number<std::uint64_t>();  // when it was published
    if (!content.is_good()) return false;
    const auto channel = channel_of.find(number);
    if (channel == channel_of.end()) {
      ++num_unknown;
      return true;
    }
    const double seconds = static_cast<double>(log_time / 1000000000);
    const double nanoseconds = static_cast<double>(log_time % 1000000000);
    (*take)(channel->second, seconds + 1e-9 * nanoseconds, content.Rest());
    return true;
  }

  bool Take(char op, std::string_view bytes) {
    if (op == kSchema) return TakeSchema(Content(bytes));
    if (op == kChannel) return TakeChannel(Content(bytes));
    if (op == kMessage) return TakeMessage(Content(bytes));
    return true;
  }
};

std::optional<Compression> McapCompression(std::string_view name) {
  if (name.empty() || name == "none") return Compression::kNone;
  if (name == "lz4") return Compression::kLz4;
  if (name == "zstd") return Compression::kZstd;
  return std::nullopt;
}

// The head of a chunk, up to its records.
struct Chunk {
  std::uint64_t size = 0;  // of its records, not compressed
  std::optional<Compression> compression;
  std::uint64_t stored_size = 0;
  std::size_t head_size = 0;
};

std::optional<Chunk> ChunkOf(std::string_view bytes) {
  Content content(bytes);
  content.Number<std::uint64_t>();  // first and last stamp
  content.Number<std::uint64_t>();
  Chunk chunk;
  chunk.size = content.Number<std::uint64_t>();
  content.Number<std::uint32_t>();  // check sum
  chunk.compression = McapCompression(content.Text());
  chunk.stored_size = content.Number<std::uint64_t>();
  chunk.head_size = bytes.size() - content.Rest().size();
  if (!content.is_good() || !chunk.compression) return std::nullopt;
  return chunk;
}

// The records of a chunk that was compressed. False where they are damaged or cut.
bool WalkRecords(std::string_view bytes, Walker* walker) {
  while (!bytes.empty()) {
    if (bytes.size() < kRecordHead) return false;
    const auto size = NumberAt<std::uint64_t>(bytes, 1);
    if (size > bytes.size() - kRecordHead) return false;
    const auto length = static_cast<std::size_t>(size);
    if (!walker->Take(bytes[0], bytes.substr(kRecordHead, length))) return false;
    bytes.remove_prefix(kRecordHead + length);
  }
  return true;
}

class McapFile final : public MessageContainer {
 public:
  explicit McapFile(const std::filesystem::path& path) : path_(path) {}

  std::string format() const override { return "mcap"; }

  ContainerWalk Walk(std::vector<MessageChannel>* channels, const MessageSink& take) const override;

 private:
  std::filesystem::path path_;
};

ContainerWalk McapFile::Walk(std::vector<MessageChannel>* channels, const MessageSink& take) const {
  constexpr std::size_t kLongestChunkHead = 128;
  ByteFile file(path_);
  Walker walker = {channels, &take, {}, {}, 0};
  ContainerWalk walk;
  walk.size_bytes = file.size();
  std::uint64_t at = kMcapMagic.size();
  bool is_closed = false;
  std::string buffer;  // of a chunk that was compressed
  while (!is_closed) {
    const std::string_view head = file.View(at, kRecordHead);
    if (head.size() < kRecordHead) break;
    const char op = head[0];
    const auto size = NumberAt<std::uint64_t>(head, 1);
    const std::uint64_t left = file.size() - at - kRecordHead;
    if (op == kChunk) {
      const auto chunk = ChunkOf(file.View(at + kRecordHead, kLongestChunkHead));
      if (!chunk || chunk->stored_size > size) break;
      const std::uint64_t records = at + kRecordHead + chunk->head_size;
      if (*chunk->compression == Compression::kNone) {
        // Its records are the next ones in the file: no chunk has to fit into memory.
        at = records;
        continue;
      }
      if (chunk->size > kLargestRecord || chunk->stored_size > kLargestRecord) break;
      if (chunk->size > MostUnpackedOf(static_cast<std::size_t>(chunk->stored_size))) {
        walk.remarks.push_back(fmt::format(
            "the chunk at byte {} says that its {} bytes unpack to {}: it is not unpacked.",
            records,
            chunk->stored_size,
            chunk->size));
        break;
      }
      const std::string_view plain =
          Decompressed(*chunk->compression,
                       file.View(records, static_cast<std::size_t>(chunk->stored_size)),
                       static_cast<std::size_t>(chunk->size),
                       &buffer);
      if (!WalkRecords(plain, &walker) || plain.size() < chunk->size || size > left) break;
    } else {
      if (size > left) break;
      const bool is_wanted = op == kSchema || op == kChannel || op == kMessage;
      if (is_wanted) {
        if (size > kLargestRecord) break;
        const std::string_view content =
            file.View(at + kRecordHead, static_cast<std::size_t>(size));
        if (!walker.Take(op, content)) break;
      }
      is_closed = op == kFooter;
    }
    at += kRecordHead + size;
  }
  if (is_closed && file.View(at, kMcapMagic.size()) == kMcapMagic) at += kMcapMagic.size();
  walk.read_bytes = at;
  if (at < file.size()) {
    walk.remarks.push_back(fmt::format(
        "the file is cut or damaged at byte {}: what is before it, and whole behind it in the same "
        "chunk, is read.",
        at));
  } else if (!is_closed) {
    walk.remarks.emplace_back("the file was not closed: it has no footer.");
  }
  if (walker.num_unknown > 0) {
    walk.remarks.push_back(fmt::format("{} messages belong to no channel.", walker.num_unknown));
  }
  return walk;
}

}  // namespace

bool LooksLikeMcap(std::string_view first_bytes) { return first_bytes.starts_with(kMcapMagic); }

std::unique_ptr<MessageContainer> OpenMcap(const std::filesystem::path& path) {
  return std::make_unique<McapFile>(path);
}

}  // namespace fathom
