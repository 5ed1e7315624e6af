// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ros/ros1_bag.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/import/recording/byte_file.h"
#include "fathom/import/recording/decompress.h"
#include "fathom/import/recording/little_endian.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::uint64_t kLargestRecord = std::uint64_t{1} << 28;  // [bytes]

constexpr char kMessageData = 0x02;
constexpr char kBagHeader = 0x03;
constexpr char kIndexData = 0x04;
constexpr char kChunk = 0x05;
constexpr char kChunkInfo = 0x06;
constexpr char kConnection = 0x07;

// The fields of a record's header: "name=value" each behind its length.
class Fields {
 public:
  // Nothing where they do not fit together.
  static std::optional<Fields> Parse(std::string_view bytes) {
    Fields fields;
    fields.bytes_ = bytes;
    while (!bytes.empty()) {
      const auto field = Take(&bytes);
      if (!field || field->find('=') == std::string_view::npos) return std::nullopt;
    }
    return fields;
  }

  // They are few: looked through again for each name.
  std::string_view Text(std::string_view name) const {
    for (std::string_view bytes = bytes_; !bytes.empty();) {
      const std::string_view field = *Take(&bytes);
      if (field.size() > name.size() && field[name.size()] == '=' && field.starts_with(name)) {
        return field.substr(name.size() + 1);
      }
    }
    return {};
  }

  // Nothing if it is not there, or has another size.
  template <typename T>
  std::optional<T> Number(std::string_view name) const {
    const std::string_view text = Text(name);
    if (text.size() != sizeof(T)) return std::nullopt;
    return LittleEndian<T>(text, 0);
  }

 private:
  // The first field, which is taken off. Nothing where the bytes do not hold it.
  static std::optional<std::string_view> Take(std::string_view* bytes) {
    if (bytes->size() < 4) return std::nullopt;
    const auto length = LittleEndian<std::uint32_t>(*bytes, 0);
    if (length > bytes->size() - 4) return std::nullopt;
    const std::string_view field = bytes->substr(4, length);
    bytes->remove_prefix(4 + std::size_t{length});
    return field;
  }

  std::string_view bytes_;
};

// A record: the length of its header, its header, the length of its data, its data.
struct Record {
  Fields header;
  char op = 0;
  std::string_view data;
  std::uint64_t data_offset = 0;  // in what the record was read from
  std::uint64_t data_size = 0;    // as stated: more than `data` holds if that is cut
};

class Bag final : public MessageContainer {
 public:
  explicit Bag(const std::filesystem::path& path) : path_(path) {
    ByteFile file(path);
    if (file.View(0, kMagic.size()) != kMagic) {
      throw InputError(path.string() +
                       ": is a bag of another version than 2.0. rosbag migrates it: rosbag fix.");
    }
  }

  std::string format() const override { return "ros1_bag"; }

  ContainerWalk Walk(std::vector<MessageChannel>* channels, const MessageSink& take) const override;

 private:
  std::filesystem::path path_;
};

// What one walk knows.
struct Walker {
  std::vector<MessageChannel>* channels;
  const MessageSink* take;
  std::map<std::uint32_t, std::size_t> channel_of;  // by the number of the connection
  std::uint64_t num_unknown = 0;                    // messages of no connection

  // False if the record is no connection.
  bool AddConnection(const Record& record) {
    const auto number = record.header.Number<std::uint32_t>("conn");
    const auto fields = Fields::Parse(record.data);
    if (!number || !fields) return false;
    if (channel_of.contains(*number)) return true;  // stands again in the index
    channel_of[*number] = channels->size();
    channels->push_back({std::string(record.header.Text("topic")),
                         std::string(fields->Text("type")),
                         std::string(fields->Text("message_definition")),
                         MessageEncoding::kRos1});
    return true;
  }

  bool TakeMessage(const Record& record) {
    const auto number = record.header.Number<std::uint32_t>("conn");
    const auto time = record.header.Number<std::uint64_t>("time");
    if (!number || !time) return false;
    const auto channel = channel_of.find(*number);
    if (channel == channel_of.end()) {
      ++num_unknown;
      return true;
    }
    // Seconds in the lower half, nanoseconds in the upper.
    const double seconds = static_cast<double>(*time & 0xffffffffU);
    const double nanoseconds = static_cast<double>(*time >> 32U);
    (*take)(channel->second, seconds + 1e-9 * nanoseconds, record.data);
    return true;
  }
};

// The record at the start of `bytes`, whose data may be cut off; nothing where none begins.
std::optional<Record> RecordAt(std::string_view bytes) {
  if (bytes.size() < 4) return std::nullopt;
  const auto header_size = LittleEndian<std::uint32_t>(bytes, 0);
  if (header_size > bytes.size() - 4 || bytes.size() - 4 - header_size < 4) return std::nullopt;
  auto fields = Fields::Parse(bytes.substr(4, header_size));
  if (!fields || fields->Text("op").size() != 1) return std::nullopt;
  Record record;
  record.op = fields->Text("op").front();
  record.header = *std::move(fields);
  record.data_offset = 8 + std::uint64_t{header_size};
  record.data_size = LittleEndian<std::uint32_t>(bytes, 4 + header_size);
  record.data = bytes.substr(record.data_offset, record.data_size);
  return record;
}

// The messages and connections of a chunk that is not compressed, or no longer. False where it is
// damaged or cut.
bool WalkChunk(std::string_view bytes, Walker* walker) {
  while (!bytes.empty()) {
    const auto record = RecordAt(bytes);
    if (!record || record->data.size() < record->data_size) return false;
    if (record->op == kConnection && !walker->AddConnection(*record)) return false;
    if (record->op == kMessageData && !walker->TakeMessage(*record)) return false;
    bytes.remove_prefix(record->data_offset + record->data_size);
  }
  return true;
}

std::optional<Compression> CompressionOf(std::string_view name) {
  if (name == "none") return Compression::kNone;
  if (name == "bz2") return Compression::kBzip2;
  if (name == "lz4") return Compression::kLz4;
  return std::nullopt;
}

// The record at a place in the file, with all of its data if that is wanted and there.
std::optional<Record> RecordIn(ByteFile* file, std::uint64_t at) {
  constexpr std::size_t kUsualHeader = 512;
  const std::string_view begin = file->View(at, kUsualHeader);
  if (begin.size() < 4) return std::nullopt;
  const std::uint64_t header_size = LittleEndian<std::uint32_t>(begin, 0);
  if (header_size > kLargestRecord) return std::nullopt;
  const auto head = RecordAt(file->View(at, static_cast<std::size_t>(header_size + 8)));
  if (!head) return std::nullopt;
  const bool is_index = head->op == kIndexData || head->op == kChunkInfo || head->op == kBagHeader;
  const bool is_plain_chunk = head->op == kChunk && head->header.Text("compression") == "none";
  if (is_index || is_plain_chunk || head->data_size > kLargestRecord) return head;
  return RecordAt(file->View(at, static_cast<std::size_t>(head->data_offset + head->data_size)));
}

ContainerWalk Bag::Walk(std::vector<MessageChannel>* channels, const MessageSink& take) const {
  ByteFile file(path_);
  Walker walker = {channels, &take, {}, 0};
  ContainerWalk walk;
  walk.size_bytes = file.size();
  std::uint64_t at = kMagic.size();
  bool is_indexed = true;
  std::string buffer;  // of a chunk that was compressed
  while (at < file.size()) {
    const auto record = RecordIn(&file, at);
    if (!record) break;
    const std::uint64_t data = at + record->data_offset;
    const std::uint64_t end = data + record->data_size;
    if (record->op == kBagHeader) {
      is_indexed = record->header.Number<std::uint64_t>("index_pos").value_or(0) != 0;
    } else if (record->op == kConnection || record->op == kMessageData) {
      if (record->data.size() < record->data_size) break;
      const bool is_sound =
          record->op == kConnection ? walker.AddConnection(*record) : walker.TakeMessage(*record);
      if (!is_sound) break;
    } else if (record->op == kChunk) {
      const auto compression = CompressionOf(record->header.Text("compression"));
      const auto size = record->header.Number<std::uint32_t>("size");
      if (!compression || !size) break;
      if (*compression == Compression::kNone) {
        // Its records are the next ones in the file: no chunk has to fit into memory.
        at = data;
        continue;
      }
      const std::string_view plain = Decompressed(*compression, record->data, *size, &buffer);
      if (!WalkChunk(plain, &walker) || plain.size() < *size) break;
    }
    if (end > file.size()) break;
    at = end;
  }
  walk.read_bytes = at;
  if (at < file.size()) {
    walk.remarks.push_back(
        fmt::format("the bag is cut or damaged at byte {}: what is before it, and "
                    "whole behind it in the same chunk, is read.",
                    at));
  }
  if (!is_indexed) {
    walk.remarks.emplace_back(
        "the bag was not closed and has no index. All of its messages are read without one.");
  }
  if (walker.num_unknown > 0) {
    walk.remarks.push_back(fmt::format("{} messages belong to no connection.", walker.num_unknown));
  }
  return walk;
}

}  // namespace

bool LooksLikeRos1Bag(std::string_view first_bytes) { return first_bytes.starts_with("#ROSBAG V"); }

std::unique_ptr<MessageContainer> OpenRos1Bag(const std::filesystem::path& path) {
  return std::make_unique<Bag>(path);
}

}  // namespace fathom
