// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ros/rosbag2_database.h"

#include "fathom/base/input_error.h"
#include "fathom/import/recording/decompress.h"
#include "fathom/import/ros/ros_definition.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

namespace fathom {
namespace {

// Messages of `ros2 bag record --compression-mode message` begin so, and plain ones (CDR) with 0.
constexpr std::string_view kZstdMagic = "\x28\xb5\x2f\xfd";

// A file whose -wal was not copied with it is complete as it stands.
SQLite::Database OpenReadOnly(const std::filesystem::path& path) {
  const std::string uri = "file:" + path.string() + "?immutable=1";
  const bool is_plain = path.string().find_first_of("?#%") == std::string::npos;
  return SQLite::Database(is_plain ? uri : path.string(),
                          SQLite::OPEN_READONLY | (is_plain ? SQLite::OPEN_URI : 0));
}

std::map<std::string, std::string> DefinitionsOf(SQLite::Database* database) {
  std::map<std::string, std::string> definitions;
  if (!database->tableExists("message_definitions")) return definitions;
  SQLite::Statement query(
      *database,
      "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions");
  while (query.executeStep()) {
    if (query.getColumn(1).getString() != "ros2msg") continue;
    definitions[query.getColumn(0).getString()] = query.getColumn(2).getString();
  }
  return definitions;
}

class Rosbag2Database final : public MessageContainer {
 public:
  explicit Rosbag2Database(const std::filesystem::path& path) : path_(path) {
    try {
      SQLite::Database database = OpenReadOnly(path);
      if (database.tableExists("topics") && database.tableExists("messages")) return;
    } catch (const SQLite::Exception& error) {
      throw InputError(
          fmt::format("{}: {}, expected a database of rosbag2. If the recorder wrote a "
                      "-wal file beside it, copy that too.",
                      path.string(),
                      error.what()));
    }
    throw InputError(path.string() +
                     ": has no tables topics and messages, expected a database of "
                     "rosbag2.");
  }

  std::string format() const override { return "rosbag2"; }

  ContainerWalk Walk(std::vector<MessageChannel>* channels, const MessageSink& take) const override;

 private:
  std::filesystem::path path_;
};

ContainerWalk Rosbag2Database::Walk(std::vector<MessageChannel>* channels,
                                    const MessageSink& take) const {
  ContainerWalk walk;
  walk.size_bytes = std::filesystem::file_size(path_);
  std::uint64_t num_unknown = 0;  // messages of no topic
  std::uint64_t num_broken = 0;   // that cannot be unpacked
  std::string buffer;             // of a message that was compressed
  try {
    SQLite::Database database = OpenReadOnly(path_);
    const auto definitions = DefinitionsOf(&database);
    std::map<std::int64_t, std::size_t> channel_of;
    SQLite::Statement topics(database, "SELECT id, name, type FROM topics ORDER BY id");
    while (topics.executeStep()) {
      MessageChannel channel;
      channel.topic = topics.getColumn(1).getString();
      channel.type = topics.getColumn(2).getString();
      const auto known = definitions.find(channel.type);
      channel.definition =
          known == definitions.end() ? KnownDefinition(channel.type) : known->second;
      channel.encoding = MessageEncoding::kCdr;
      channel_of[topics.getColumn(0).getInt64()] = channels->size();
      channels->push_back(std::move(channel));
    }
    SQLite::Statement messages(database,
                               "SELECT topic_id, timestamp, data FROM messages ORDER BY id");
    while (messages.executeStep()) {
      const auto channel = channel_of.find(messages.getColumn(0).getInt64());
      if (channel == channel_of.end()) {
        ++num_unknown;
        continue;
      }
      const std::int64_t stamp = messages.getColumn(1).getInt64();
      const double time =
          static_cast<double>(stamp / 1000000000) + 1e-9 * static_cast<double>(stamp % 1000000000);
      const SQLite::Column data = messages.getColumn(2);
      const auto size = static_cast<std::size_t>(data.getBytes());
      walk.read_bytes += size;
      std::string_view message(static_cast<const char*>(data.getBlob()), size);
      if (message.starts_with(kZstdMagic)) {
        const std::size_t most = MostUnpackedOf(size);
        message = Decompressed(Compression::kZstd, message, most, &buffer);
        if (message.empty() || message.size() == most) {
          ++num_broken;
          continue;
        }
      }
      take(channel->second, time, message);
    }
    walk.read_bytes = walk.size_bytes;
  } catch (const SQLite::Exception& error) {
    walk.remarks.push_back(
        fmt::format("the database is damaged ({}): {} bytes of messages could be read.",
                    error.what(),
                    walk.read_bytes));
  }
  if (num_broken > 0) {
    walk.remarks.push_back(fmt::format(
        "{} messages are compressed by zstd and cannot be unpacked, or to too much.", num_broken));
  }
  if (num_unknown > 0) {
    walk.remarks.push_back(fmt::format("{} messages belong to no topic.", num_unknown));
  }
  return walk;
}

}  // namespace

bool LooksLikeSqlite(std::string_view first_bytes) {
  return first_bytes.starts_with(std::string_view("SQLite format 3\0", 16));
}

std::unique_ptr<MessageContainer> OpenRosbag2Database(const std::filesystem::path& path) {
  return std::make_unique<Rosbag2Database>(path);
}

}  // namespace fathom
