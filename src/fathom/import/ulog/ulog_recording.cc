// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ulog/ulog_recording.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/import/recording/channel_stamps.h"
#include "fathom/import/recording/find_channel.h"
#include "fathom/import/recording/number_type.h"
#include "fathom/import/recording/wanted_fields.h"
#include "fathom/import/ulog/ulog_format.h"
#include "fathom/import/ulog/ulog_time.h"
#include "fathom/import/ulog/ulog_walk.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::string_view kULogMagic("ULog\x01\x12\x35", 7);
constexpr std::size_t kMostULogFields = 100000;  // of all channels; PX4 logs some thousands
constexpr std::size_t kMostULogChannels = 4096;  // PX4 logs some hundreds at most
constexpr std::size_t kLongestTopic = 256;

// What is subscribed: an instance of a topic.
struct UlogTopic {
  std::string name;
  int instance = 0;
  auto operator<=>(const UlogTopic&) const = default;
};

std::string NameOf(const UlogTopic& topic) {
  return topic.instance == 0 ? topic.name : fmt::format("{}[{}]", topic.name, topic.instance);
}

// From a message 'A'.
UlogTopic TopicOf(std::string_view payload) {
  return {std::string(payload.substr(3, kLongestTopic)), static_cast<unsigned char>(payload[0])};
}

std::uint16_t IdOf(char type, std::string_view payload) {
  return NumberAt<std::uint16_t>(payload, type == 'A' ? 1 : 0);
}

// What the walk finds besides data.
struct UlogCounts {
  std::uint64_t parameters = 0;
  std::uint64_t information = 0;
  std::uint64_t texts = 0;
  std::uint64_t unknown = 0;       // messages of types that the format does not have
  std::uint64_t unsubscribed = 0;  // data that no subscription, or one too many, says the topic of
  std::uint64_t dropouts = 0;
  double lost = 0.0;  // [s], in dropouts

  void Take(char type, std::string_view payload) {
    if (type == 'P' || type == 'Q') ++parameters;
    if (type == 'I' || type == 'M') ++information;
    if (type == 'L' || type == 'C') ++texts;
    if (std::string_view("BFIMPQARDLCSO").find(type) == std::string_view::npos) ++unknown;
    if (type != 'O') return;
    ++dropouts;
    lost += 1e-3 * NumberAt<std::uint16_t>(payload, 0);
  }
};

class UlogRecording final : public Recording {
 public:
  explicit UlogRecording(const std::filesystem::path& path);

  const Contents& contents() const override { return contents_; }

  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override;

 private:
  // What is known of a channel.
  struct UlogChannel {
    UlogLayout layout;
    UlogClock clock;
    ChannelStamps stamps;
    std::uint64_t num_short = 0;  // messages that end before their format does
  };

  void List(ByteFile* file, const UlogFormats& formats);

  // Adds a channel, with a remark if nobody can say what it is made of.
  UlogChannel* Add(const UlogTopic& topic, const UlogFormats& formats);

  void TellWalk(const UlogWalk& walk);
  void TellCounts(const UlogCounts& counts);

  std::filesystem::path path_;
  UlogHead head_;
  std::map<UlogTopic, UlogChannel> channels_;
  std::size_t fields_left_ = kMostULogFields;
  Contents contents_;
};

UlogRecording::UlogRecording(const std::filesystem::path& path) : path_(path) {
  ByteFile file(path);
  head_ = ReadUlogHead(&file);
  contents_.format = "ulog";
  contents_.size_bytes = file.size();
  if (head_.version > 1) {
    contents_.remarks.push_back(
        fmt::format("the file is of ULog version {}; it is read as version 1.", head_.version));
  }
  if (head_.has_bad_offsets) {
    contents_.remarks.push_back(
        "the header tells of appended data at a place where none can be; it is not looked for.");
  }
  UlogFormats formats;
  ForEachUlogMessage(&file, head_, [&](char type, std::string_view payload) {
    if (type == 'F') formats.Take(payload);
  });
  if (formats.num_redefined() > 0) {
    contents_.remarks.push_back(
        fmt::format("{} messages F define a format anew that was defined otherwise; the first "
                    "definition holds.",
                    formats.num_redefined()));
  }
  if (formats.num_unreadable() > 0) {
    contents_.remarks.push_back(
        fmt::format("{} messages F are no formats: damage.", formats.num_unreadable()));
  }
  List(&file, formats);
}

UlogRecording::UlogChannel* UlogRecording::Add(const UlogTopic& topic, const UlogFormats& formats) {
  UlogChannel& channel = channels_[topic];
  try {
    channel.layout = formats.LayoutOf(topic.name, &fields_left_);
  } catch (const InputError& error) {
    contents_.remarks.push_back(
        fmt::format("{} cannot be read: {}", Printable(NameOf(topic)), error.what()));
  }
  return &channel;
}

void UlogRecording::List(ByteFile* file, const UlogFormats& formats) {
  std::map<std::uint16_t, UlogTopic> topics;
  std::map<std::uint16_t, UlogChannel*> channels;
  UlogCounts counts;
  UlogGpsTime gps_time;
  const UlogWalk walk = ForEachUlogMessage(file, head_, [&](char type, std::string_view payload) {
    counts.Take(type, payload);
    if (type == 'A') {
      topics[IdOf(type, payload)] = TopicOf(payload);
      channels.erase(IdOf(type, payload));
    }
    if (type != 'D') return;
    const std::uint16_t id = IdOf(type, payload);
    const auto topic = topics.find(id);
    if (topic == topics.end()) {
      ++counts.unsubscribed;
      return;
    }
    UlogChannel*& channel = channels[id];
    if (channel == nullptr) {
      const auto known = channels_.find(topic->second);
      if (known == channels_.end() && channels_.size() >= kMostULogChannels) {
        ++counts.unsubscribed;
        return;
      }
      channel = known != channels_.end() ? &known->second : Add(topic->second, formats);
    }
    const std::string_view data = payload.substr(2);
    if (data.size() < channel->layout.size) ++channel->num_short;
    channel->stamps.Add(channel->clock.StampOf(channel->layout, data));
    gps_time.Take(topic->second.name, channel->layout, data);
  });
  if (channels_.empty()) {
    throw InputError(path_.string() + ": holds no data that is subscribed, expected a PX4 log.");
  }
  contents_.utc_of_zero = gps_time.utc_of_zero();
  contents_.read_bytes = file->size() - walk.skipped_bytes - walk.cut_bytes;
  for (const auto& [topic, known] : channels_) {
    Channel channel;
    channel.name = NameOf(topic);
    channel.type = topic.name;
    for (const PackedNumber& number : known.layout.numbers) {
      const bool is_stamp = number.name == "timestamp";
      const char* unit = number.type == NumberType::kUint8 ? "ms" : "us";
      channel.fields.push_back({number.name, is_stamp ? unit : ""});
    }
    known.stamps.WriteTo(&channel);
    contents_.channels.push_back(std::move(channel));
    if (known.num_short > 0) {
      contents_.remarks.push_back(
          fmt::format("{}: {} of its messages end before their format does; the fields behind are "
                      "empty.",
                      NameOf(topic),
                      known.num_short));
    }
  }
  TellWalk(walk);
  TellCounts(counts);
}

void UlogRecording::TellWalk(const UlogWalk& walk) {
  if (walk.skipped_bytes > 0) {
    contents_.remarks.push_back(
        fmt::format("{} of {} bytes belong to no message, the first at byte {}: damage.",
                    walk.skipped_bytes,
                    contents_.size_bytes,
                    walk.first_skipped));
  }
  if (walk.cut_bytes > 0) {
    contents_.remarks.push_back(
        fmt::format("the file ends within a message: the {} from byte {} on are not read.",
                    Plural(walk.cut_bytes, "byte"),
                    walk.first_cut));
  }
}

void UlogRecording::TellCounts(const UlogCounts& counts) {
  if (counts.unsubscribed > 0) {
    contents_.remarks.push_back(fmt::format(
        "not read, since no subscription, or one too many, says of which topic they are: {}.",
        Plural(counts.unsubscribed, "message")));
  }
  if (counts.unknown > 0) {
    contents_.remarks.push_back(
        fmt::format("not read, since ULog has no messages of their type: {}.",
                    Plural(counts.unknown, "message")));
  }
  if (counts.dropouts > 0) {
    contents_.remarks.push_back(
        fmt::format("the autopilot tells of {}, {:.3f} s in all, for which it lost what it wanted "
                    "to log.",
                    Plural(counts.dropouts, "dropout"),
                    counts.lost));
  }
  if (counts.parameters + counts.information + counts.texts > 0) {
    contents_.remarks.push_back(
        fmt::format("not read, since they are no measurements: {}, {} of information, {}.",
                    Plural(counts.parameters, "parameter"),
                    Plural(counts.information, "message"),
                    Plural(counts.texts, "text")));
  }
}

std::vector<std::string> UlogRecording::Read(std::span<const Selection> selections,
                                             const SampleSink& sink) const {
  // A topic that is subscribed twice has one clock.
  struct UlogStream {
    const UlogLayout* layout = nullptr;
    UlogClock clock;
    std::vector<WantedFields<PackedNumber>> wanted;
  };
  std::map<UlogTopic, UlogStream> streams;
  for (std::size_t i = 0; i < selections.size(); ++i) {
    const Channel& channel = FindChannel(contents_, path_, selections[i]);
    for (const auto& [topic, known] : channels_) {
      if (NameOf(topic) != channel.name) continue;
      UlogStream& stream = streams[topic];
      stream.layout = &known.layout;
      stream.wanted.emplace_back(
          i, selections[i], [&](const std::string& field) { return stream.layout->Find(field); });
    }
  }
  ByteFile file(path_);
  std::map<std::uint16_t, UlogStream*> by_id;
  ForEachUlogMessage(&file, head_, [&](char type, std::string_view payload) {
    if (type == 'A') {
      const auto stream = streams.find(TopicOf(payload));
      by_id[IdOf(type, payload)] = stream == streams.end() ? nullptr : &stream->second;
    }
    if (type != 'D') return;
    const auto found = by_id.find(IdOf(type, payload));
    if (found == by_id.end() || found->second == nullptr) return;
    UlogStream& stream = *found->second;
    const std::string_view data = payload.substr(2);
    const double stamp = stream.clock.StampOf(*stream.layout, data);
    for (auto& wanted : stream.wanted) wanted.HandOn(stamp, data, sink);
  });
  return {};
}

}  // namespace

bool LooksLikeUlog(std::string_view first_bytes) { return first_bytes.starts_with(kULogMagic); }

std::unique_ptr<Recording> OpenUlog(const std::filesystem::path& path) {
  return std::make_unique<UlogRecording>(path);
}

}  // namespace fathom
