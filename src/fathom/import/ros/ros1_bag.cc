// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ros/ros1_bag.h"

#include "fathom/base/input_error.h"
#include "fathom/import/recording/byte_file.h"
#include "fathom/import/recording/decompress.h"
#include "fathom/import/recording/number_type.h"
#include "fathom/import/ros/bag_record.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::string_view kBagMagic = "#ROSBAG V2.0\n";

class Bag final : public MessageContainer {
 public:
  explicit Bag(const std::filesystem::path& path) : path_(path) {
    ByteFile file(path);
    if (file.View(0, kBagMagic.size()) != kBagMagic) {
      throw InputError(path.string() +
                       ": is a bag of another version than 2.0. rosbag migrates it: rosbag fix.");
    }
  }

  std::string format() const override { return "ros1_bag"; }

  ContainerWalk Walk(std::vector<MessageChannel>* channels, const MessageSink& take) const override;

  // Of the chunks that the index tells all about, their messages' times.
  ContainerWalk List(std::vector<MessageChannel>* channels, const MessageSink& take) const override;

 private:
  std::filesystem::path path_;
};

// Seconds in the lower half, nanoseconds in the upper.
double SecondsOf(std::uint64_t time) {
  return static_cast<double>(time & 0xffffffffU) + 1e-9 * static_cast<double>(time >> 32U);
}

std::optional<Compression> BagCompression(std::string_view name) {
  if (name == "none") return Compression::kNone;
  if (name == "bz2") return Compression::kBzip2;
  if (name == "lz4") return Compression::kLz4;
  return std::nullopt;
}

// One walk over a bag, record by record.
class BagWalk {
 public:
  BagWalk(ByteFile* file,
          bool is_list,
          std::vector<MessageChannel>* channels,
          const MessageSink* take)
      : file_(file), is_list_(is_list), channels_(channels), take_(take) {}

  // Takes the record at a place, and says where the next one is; nothing where the file is damaged.
  std::optional<std::uint64_t> Step(std::uint64_t at);

  bool is_indexed() const { return index_at_ != 0; }
  std::uint64_t num_unknown() const { return num_unknown_; }
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  struct Connection {
    std::size_t channel = 0;
    bool has_message = false;
  };

  // Each is false where the record is damaged.
  bool AddConnection(const BagRecord& record);
  bool TakeMessage(const BagRecord& record);
  bool TakeChunk(std::string_view plain);

  // Whether the file goes on with zeros there.
  bool IsZeroAt(std::uint64_t at) const;

  // Hands on the times of the chunk that ends there, out of the index behind it. False, and none is
  // handed on, where there is no sound one, or the chunk holds the first message of a connection.
  bool ListChunk(std::uint64_t end);

  // The same of a chunk, whose data are from `data` to `end`.
  std::optional<std::uint64_t> StepOverChunk(const BagRecord& record,
                                             std::uint64_t data,
                                             std::uint64_t end);

  ByteFile* file_;
  bool is_list_;
  std::vector<MessageChannel>* channels_;
  const MessageSink* take_;
  std::map<std::uint32_t, Connection> connections_;
  std::uint64_t index_at_ = 1;     // where the bag says that its index is: not 0 if it is closed
  std::uint64_t num_unknown_ = 0;  // messages of no connection
  std::string buffer_;             // of a chunk that was compressed
  std::vector<std::string> remarks_;
};

bool BagWalk::AddConnection(const BagRecord& record) {
  const auto number = record.header.Number<std::uint32_t>("conn");
  const auto fields = BagFields::Parse(record.data);
  if (!number || !fields || !record.IsWhole()) return false;
  if (connections_.contains(*number)) return true;  // stands again in the index
  connections_[*number].channel = channels_->size();
  channels_->push_back({std::string(record.header.Text("topic")),
                        std::string(fields->Text("type")),
                        std::string(fields->Text("message_definition")),
                        MessageEncoding::kRos1});
  return true;
}

bool BagWalk::TakeMessage(const BagRecord& record) {
  const auto number = record.header.Number<std::uint32_t>("conn");
  const auto time = record.header.Number<std::uint64_t>("time");
  if (!number || !time || !record.IsWhole()) return false;
  const auto connection = connections_.find(*number);
  if (connection == connections_.end()) {
    ++num_unknown_;
    return true;
  }
  connection->second.has_message = true;
  (*take_)(connection->second.channel, SecondsOf(*time), record.data);
  return true;
}

bool BagWalk::TakeChunk(std::string_view plain) {
  while (!plain.empty()) {
    const auto record = BagRecordAt(plain);
    if (!record || !record->IsWhole()) return false;
    if (record->op == kBagConnection && !AddConnection(*record)) return false;
    if (record->op == kBagMessage && !TakeMessage(*record)) return false;
    plain.remove_prefix(record->data_offset + record->data_size);
  }
  return true;
}

bool BagWalk::ListChunk(std::uint64_t end) {
  constexpr std::size_t kEntry = 12;  // [bytes] a time, and a place in the chunk
  std::vector<std::pair<std::size_t, double>> messages;
  while (true) {
    const auto record = BagRecordIn(file_, end);
    if (!record) return false;
    if (record->op != kBagIndex) break;
    const auto number = record->header.Number<std::uint32_t>("conn");
    const auto count = record->header.Number<std::uint32_t>("count");
    if (!number || !count || record->data_size != kEntry * std::uint64_t{*count}) return false;
    const auto connection = connections_.find(*number);
    if (connection == connections_.end() || !connection->second.has_message) return false;
    const std::uint64_t data = end + record->data_offset;
    end = data + record->data_size;
    if (end > file_->size() || record->data_size > kLargestBagRecord) return false;
    const auto entries = file_->View(data, static_cast<std::size_t>(end - data));
    for (std::size_t i = 0; i < entries.size(); i += kEntry) {
      messages.emplace_back(connection->second.channel,
                            SecondsOf(NumberAt<std::uint64_t>(entries, i)));
    }
  }
  for (const auto& [channel, time] : messages) (*take_)(channel, time, {});
  return !messages.empty();
}

std::optional<std::uint64_t> BagWalk::StepOverChunk(const BagRecord& record,
                                                    std::uint64_t data,
                                                    std::uint64_t end) {
  const auto compression = BagCompression(record.header.Text("compression"));
  const auto size = record.header.Number<std::uint32_t>("size");
  if (!compression || !size) return std::nullopt;
  const bool is_closed = end <= index_at_ && index_at_ < file_->size();
  if (is_list_ && is_closed && ListChunk(end)) return end;
  // The records of a plain chunk are the next ones in the file: no chunk has to fit into memory.
  if (*compression == Compression::kNone) return data;
  const auto stored = static_cast<std::size_t>(std::min(end - data, kLargestBagRecord));
  if (*size > MostUnpackedOf(stored)) {
    remarks_.push_back(
        fmt::format("the chunk at byte {} says that its {} bytes unpack to {}: it is not unpacked.",
                    data,
                    stored,
                    *size));
    return std::nullopt;
  }
  const std::string_view plain =
      Decompressed(*compression, file_->View(data, stored), *size, &buffer_);
  if (!TakeChunk(plain) || plain.size() < *size) return std::nullopt;
  return end;
}

// A card that loses power leaves zeros behind what was written: a message that ends in zeros before
// them was not written to its end.
bool BagWalk::IsZeroAt(std::uint64_t at) const {
  constexpr std::size_t kEnough = 64;  // a record begins with its length, which is not 0
  const std::string_view bytes = file_->View(at, kEnough);
  return bytes.size() == kEnough && bytes.find_first_not_of('\0') == std::string_view::npos;
}

std::optional<std::uint64_t> BagWalk::Step(std::uint64_t at) {
  auto record = BagRecordIn(file_, at);
  if (!record) return std::nullopt;
  const std::uint64_t data = at + record->data_offset;
  const std::uint64_t end = data + record->data_size;
  std::optional<std::uint64_t> next = end;
  if (record->op == kBagHeader) {
    index_at_ = record->header.Number<std::uint64_t>("index_pos").value_or(0);
  } else if (record->op == kBagConnection) {
    if (!AddConnection(*record)) return std::nullopt;
  } else if (record->op == kBagMessage) {
    if (record->data.ends_with('\0')) {
      if (IsZeroAt(end)) return std::nullopt;
      record = BagRecordIn(file_, at);  // its view is gone
    }
    if (!TakeMessage(*record)) return std::nullopt;
  } else if (record->op == kBagChunk) {
    next = StepOverChunk(*record, data, end);
  }
  return next && *next <= file_->size() ? next : std::nullopt;
}

ContainerWalk WalkBag(const std::filesystem::path& path,
                      bool is_list,
                      std::vector<MessageChannel>* channels,
                      const MessageSink& take) {
  ByteFile file(path);
  BagWalk bag(&file, is_list, channels, &take);
  ContainerWalk walk;
  walk.size_bytes = file.size();
  walk.read_bytes = kBagMagic.size();
  while (walk.read_bytes < file.size()) {
    const auto next = bag.Step(walk.read_bytes);
    if (!next) break;
    walk.read_bytes = *next;
  }
  walk.remarks = bag.remarks();
  if (walk.read_bytes < file.size()) {
    walk.remarks.push_back(
        fmt::format("the bag is cut or damaged at byte {}: what is before it, and "
                    "whole behind it in the same chunk, is read.",
                    walk.read_bytes));
  }
  if (!bag.is_indexed()) {
    walk.remarks.emplace_back(
        "the bag was not closed and has no index. All of its messages are read without one.");
  }
  if (bag.num_unknown() > 0) {
    walk.remarks.push_back(fmt::format("{} messages belong to no connection.", bag.num_unknown()));
  }
  return walk;
}

ContainerWalk Bag::Walk(std::vector<MessageChannel>* channels, const MessageSink& take) const {
  return WalkBag(path_, false, channels, take);
}

ContainerWalk Bag::List(std::vector<MessageChannel>* channels, const MessageSink& take) const {
  return WalkBag(path_, true, channels, take);
}

}  // namespace

bool LooksLikeRos1Bag(std::string_view first_bytes) { return first_bytes.starts_with("#ROSBAG V"); }

std::unique_ptr<MessageContainer> OpenRos1Bag(const std::filesystem::path& path) {
  return std::make_unique<Bag>(path);
}

}  // namespace fathom
