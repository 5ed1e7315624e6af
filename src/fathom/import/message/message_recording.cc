// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/message/message_recording.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/import/recording/channel_stamps.h"
#include "fathom/import/recording/find_channel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

class MessageRecording final : public Recording {
 public:
  MessageRecording(const std::filesystem::path& path,
                   std::unique_ptr<MessageContainer> container,
                   DefinitionParser parse);

  const Contents& contents() const override { return contents_; }

  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override;

 private:
  // The channel of a recording that a stream of the file belongs to: connections of one topic and
  // type are one channel.
  std::string NameOf(const MessageChannel& channel) const {
    return topics_of_several_types_.contains(channel.topic)
               ? fmt::format("{} ({})", channel.topic, channel.type)
               : channel.topic;
  }

  // A remark where a channel's first message itself tells another time.
  void TellOtherClock(const Channel& channel,
                      const MessageDefinition& definition,
                      MessageEncoding encoding,
                      const std::string& message,
                      double log_time);

  // What a walk over all of the file found, `count` messages, that its list does not tell.
  std::vector<std::string> NewIn(const ContainerWalk& walk, std::uint64_t count) const;

  std::filesystem::path path_;
  std::unique_ptr<MessageContainer> container_;
  std::set<std::string> topics_of_several_types_;
  std::map<std::string, MessageDefinition> definitions_;  // by channel
  Contents contents_;
};

// What listing learns of one stream of the file.
struct StreamFacts {
  ChannelStamps stamps;
  std::optional<std::string> first_message;
  double first = NAN;  // its stamp
};

MessageRecording::MessageRecording(const std::filesystem::path& path,
                                   std::unique_ptr<MessageContainer> container,
                                   DefinitionParser parse)
    : path_(path), container_(std::move(container)) {
  std::vector<MessageChannel> streams;
  std::vector<StreamFacts> facts;
  const ContainerWalk walk =
      container_->List(&streams, [&](std::size_t stream, double time, std::string_view message) {
        facts.resize(streams.size());
        facts[stream].stamps.Add(time);
        if (facts[stream].first_message) return;
        facts[stream].first_message = std::string(message);
        facts[stream].first = time;
      });
  facts.resize(streams.size());
  contents_.format = container_->format();
  contents_.read_bytes = walk.read_bytes;
  contents_.size_bytes = walk.size_bytes;
  contents_.remarks = walk.remarks;

  std::map<std::string, std::string> type_of;
  for (const MessageChannel& stream : streams) {
    const auto [known, is_new] = type_of.emplace(stream.topic, stream.type);
    if (!is_new && known->second != stream.type) topics_of_several_types_.insert(stream.topic);
  }
  std::map<std::string, std::pair<Channel, ChannelStamps>> channels;
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const MessageChannel& stream = streams[i];
    const std::string name = NameOf(stream);
    auto& [channel, stamps] = channels[name];
    channel.name = name;
    channel.type = stream.type;
    stamps.Add(facts[i].stamps);
    if (!channel.fields.empty() || !facts[i].first_message) continue;
    if (stream.definition.empty()) {
      contents_.remarks.push_back(fmt::format(
          "{}: the file does not say what a {} is made of; it cannot be read.", name, stream.type));
      continue;
    }
    try {
      const MessageDefinition definition = parse(stream.type, stream.definition);
      channel.fields = NumbersOf(definition, stream.encoding, *facts[i].first_message);
      TellOtherClock(channel, definition, stream.encoding, *facts[i].first_message, facts[i].first);
      definitions_[name] = definition;
    } catch (const InputError& error) {
      contents_.remarks.push_back(
          fmt::format("{} cannot be read: {}", Printable(name), error.what()));
    }
  }
  for (auto& [name, entry] : channels) {
    entry.second.WriteTo(&entry.first);
    contents_.channels.push_back(std::move(entry.first));
  }
  // The clock of the machine that wrote it down.
  for (const Channel& channel : contents_.channels) {
    constexpr double kYear1973 = 1e8;  // [s]
    if (channel.first && *channel.first > kYear1973) contents_.utc_of_zero = 0.0;
  }
}

void MessageRecording::TellOtherClock(const Channel& channel,
                                      const MessageDefinition& definition,
                                      MessageEncoding encoding,
                                      const std::string& message,
                                      double log_time) {
  constexpr double kSameClock = 10.0;  // [s]
  const auto& fields = channel.fields;
  const auto own = std::find_if(fields.begin(), fields.end(), [](const Field& field) {
    return field.unit == "s" && (field.name == "header.stamp" || field.name == "time");
  });
  if (own == fields.end()) return;
  std::vector<double> stamp;
  MessageDecoder(definition, encoding, {own->name}).Decode(message, &stamp);
  if (!(std::abs(stamp.front() - log_time) > kSameClock)) return;
  contents_.remarks.push_back(
      fmt::format("{}: its {} is of another clock, {:.3f} s where the message was written down at "
                  "{:.3f} s. The latter is the stamp; 'time: {}' in a map takes the former.",
                  Printable(channel.name),
                  own->name,
                  stamp.front(),
                  log_time,
                  own->name));
}

std::vector<std::string> MessageRecording::Read(std::span<const Selection> selections,
                                                const SampleSink& sink) const {
  struct Wanted {
    std::size_t selection;
    MessageDecoder decoder;
  };
  for (const Selection& selection : selections) FindChannel(contents_, path_, selection);
  std::vector<MessageChannel> streams;
  std::vector<std::vector<Wanted>> wanted;  // by stream
  std::vector<double> values;
  std::uint64_t count = 0;
  const auto take = [&](std::size_t stream, double time, std::string_view message) {
    ++count;
    while (wanted.size() < streams.size()) {
      const MessageChannel& added = streams[wanted.size()];
      std::vector<Wanted>& of_stream = wanted.emplace_back();
      const auto definition = definitions_.find(NameOf(added));
      if (definition == definitions_.end()) continue;
      for (std::size_t i = 0; i < selections.size(); ++i) {
        if (selections[i].channel != NameOf(added)) continue;
        of_stream.push_back(
            {i, MessageDecoder(definition->second, added.encoding, selections[i].fields)});
      }
    }
    for (const Wanted& entry : wanted[stream]) {
      // Of a message that ends too early, what it has before its end.
      entry.decoder.Decode(message, &values);
      sink(entry.selection, time, values);
    }
  };
  const ContainerWalk walk = container_->Walk(&streams, take);
  return NewIn(walk, count);
}

std::vector<std::string> MessageRecording::NewIn(const ContainerWalk& walk,
                                                 std::uint64_t count) const {
  std::vector<std::string> remarks;
  const auto& known = contents_.remarks;
  for (const std::string& remark : walk.remarks) {
    if (std::find(known.begin(), known.end(), remark) == known.end()) remarks.push_back(remark);
  }
  std::uint64_t listed = 0;
  for (const Channel& channel : contents_.channels) listed += channel.count;
  if (count != listed) {
    remarks.push_back(fmt::format("the index lists {} messages, {} are read.", listed, count));
  }
  return remarks;
}

}  // namespace

std::unique_ptr<Recording> OpenMessageRecording(const std::filesystem::path& path,
                                                std::unique_ptr<MessageContainer> container,
                                                DefinitionParser parse) {
  return std::make_unique<MessageRecording>(path, std::move(container), parse);
}

}  // namespace fathom
