// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/tlog/tlog_recording.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/import/recording/channel_stamps.h"
#include "fathom/import/recording/find_channel.h"
#include "fathom/import/recording/wanted_fields.h"
#include "fathom/import/tlog/mavlink_message.h"
#include "fathom/import/tlog/tlog_walk.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kMostChannels = 1000;
constexpr std::size_t kMostUnknown = 1000;  // numbers of messages that are not read
constexpr std::size_t kMostTold = 40;       // of them in a remark

// A message of one sender.
struct TlogSource {
  std::uint32_t id = 0;
  int system = 0;
  int component = 0;
  auto operator<=>(const TlogSource&) const = default;
};

TlogSource SourceOf(const TlogPacket& packet) {
  return {packet.id, packet.system, packet.component};
}

// The payload with the zeros that MAVLink 2 leaves out at its end. MAVLink 1 leaves none out;
// fields that it does not have are empty.
std::string_view WholePayload(const TlogPacket& packet,
                              const MavlinkMessage& message,
                              std::string* buffer) {
  if (packet.version == 1 || packet.payload.size() >= message.size) return packet.payload;
  buffer->assign(packet.payload);
  buffer->resize(message.size, '\0');
  return *buffer;
}

// The settings (PARAM_VALUE) that autopilots state.
class TlogSettings {
 public:
  void Take(const TlogPacket& packet, std::string_view payload);

  // Of the first system that drives outputs; ArduPilot's, whose whole numbers are sent as floats.
  // Others send their bits.
  std::map<std::string, double> OfTheVehicle() const;

 private:
  std::map<int, std::map<std::string, double>> by_system_;
  std::set<int> drives_;           // systems that send SERVO_OUTPUT_RAW
  std::set<int> is_no_ardupilot_;  // by their HEARTBEAT
};

void TlogSettings::Take(const TlogPacket& packet, std::string_view payload) {
  constexpr std::uint32_t kHeartbeat = 0, kParamValue = 22, kServoOutputRaw = 36;
  constexpr double kArduPilot = 3.0;  // MAV_AUTOPILOT_ARDUPILOTMEGA
  constexpr std::size_t kMostSettings = 10000;
  if (packet.component != 1) return;  // MAV_COMP_ID_AUTOPILOT1
  if (packet.id == kServoOutputRaw) drives_.insert(packet.system);
  if (packet.id == kHeartbeat) {
    const double autopilot = ValueOf(*FindMavlinkMessage(kHeartbeat)->Find("autopilot"), payload);
    if (autopilot != kArduPilot) is_no_ardupilot_.insert(packet.system);
  }
  if (packet.id != kParamValue) return;
  const MavlinkMessage& message = *FindMavlinkMessage(kParamValue);
  std::string_view name =
      payload.substr(std::min(payload.size(), message.Find("param_id[0]")->offset), 16);
  name = name.substr(0, name.find('\0'));
  auto& settings = by_system_[packet.system];
  if (settings.size() >= kMostSettings) return;
  settings[std::string(name)] = ValueOf(*message.Find("param_value"), payload);
}

std::map<std::string, double> TlogSettings::OfTheVehicle() const {
  for (const int system : drives_) {
    const auto settings = by_system_.find(system);
    if (settings != by_system_.end() && !is_no_ardupilot_.contains(system)) return settings->second;
  }
  return {};
}

class TlogRecording final : public Recording {
 public:
  explicit TlogRecording(const std::filesystem::path& path);

  const Contents& contents() const override { return contents_; }

  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override;

 private:
  void TellUnknown(const std::map<std::uint32_t, std::uint64_t>& counts, std::uint64_t num_others);
  void TellWalk(const TlogWalk& walk);

  std::filesystem::path path_;
  std::map<TlogSource, std::string> names_;  // of the channels
  Contents contents_;
};

TlogRecording::TlogRecording(const std::filesystem::path& path) : path_(path) {
  ByteFile file(path);
  std::map<TlogSource, ChannelStamps> stamps;
  std::map<std::uint32_t, std::uint64_t> unknown;
  std::uint64_t num_others = 0;
  TlogSettings settings;
  std::string buffer;
  const TlogWalk walk = ForEachTlogPacket(&file, [&](const TlogPacket& packet) {
    if (FindMavlinkMessage(packet.id) == nullptr) {
      const auto counted = unknown.find(packet.id);
      if (counted != unknown.end()) {
        ++counted->second;
      } else if (unknown.size() < kMostUnknown) {
        unknown.emplace(packet.id, 1);
      } else {
        ++num_others;
      }
      return;
    }
    const TlogSource source = SourceOf(packet);
    if (stamps.size() >= kMostChannels && !stamps.contains(source)) {
      ++num_others;
      return;
    }
    stamps[source].Add(packet.time);
    settings.Take(packet, WholePayload(packet, *FindMavlinkMessage(packet.id), &buffer));
  });
  if (stamps.empty()) {
    throw InputError(path_.string() +
                     ": holds no whole MAVLink message of those that are known, expected a "
                     "telemetry log (.tlog).");
  }
  contents_.format = "tlog";
  contents_.utc_of_zero = 0.0;
  contents_.parameters = settings.OfTheVehicle();
  contents_.size_bytes = file.size();
  contents_.read_bytes = file.size() - walk.skipped_bytes - walk.cut_bytes;
  std::map<std::uint32_t, int> num_senders;
  for (const auto& [source, channel_stamps] : stamps) ++num_senders[source.id];
  for (const auto& [source, channel_stamps] : stamps) {
    const MavlinkMessage& message = *FindMavlinkMessage(source.id);
    Channel channel;
    channel.type = message.name;
    channel.name = num_senders[source.id] == 1
                       ? message.name
                       : fmt::format("{} ({}/{})", message.name, source.system, source.component);
    for (std::size_t i = 0; i < message.numbers.size(); ++i) {
      if (message.numbers[i].is_text) continue;
      channel.fields.push_back({message.numbers[i].name, message.units[i]});
    }
    channel_stamps.WriteTo(&channel);
    names_.emplace(source, channel.name);
    contents_.channels.push_back(std::move(channel));
  }
  std::ranges::stable_sort(contents_.channels, {}, &Channel::type);
  contents_.TellSimulation();
  TellWalk(walk);
  TellUnknown(unknown, num_others);
}

void TlogRecording::TellWalk(const TlogWalk& walk) {
  if (walk.skipped_bytes > 0) {
    contents_.remarks.push_back(
        fmt::format("{} of {} bytes belong to no sound packet, the first at byte {}: damage.",
                    walk.skipped_bytes,
                    contents_.size_bytes,
                    walk.first_skipped));
  }
  if (walk.cut_bytes > 0) {
    contents_.remarks.push_back(
        fmt::format("the file ends within a packet: the {} from byte {} on are not read.",
                    Plural(walk.cut_bytes, "byte"),
                    contents_.size_bytes - walk.cut_bytes));
  }
}

void TlogRecording::TellUnknown(const std::map<std::uint32_t, std::uint64_t>& counts,
                                std::uint64_t num_others) {
  if (counts.empty() && num_others == 0) return;
  std::string text;
  std::size_t num_told = 0;
  for (const auto& [id, count] : counts) {
    if (num_told < kMostTold) {
      text += fmt::format("{}message {}: {}", text.empty() ? "" : ", ", id, count);
      ++num_told;
    } else {
      num_others += count;
    }
  }
  if (num_others > 0) text += fmt::format("{}others: {}", text.empty() ? "" : ", ", num_others);
  contents_.remarks.push_back("not read, by the numbers of MAVLink: " + text + ".");
}

std::vector<std::string> TlogRecording::Read(std::span<const Selection> selections,
                                             const SampleSink& sink) const {
  std::map<TlogSource, std::vector<WantedFields<PackedNumber>>> wanted;
  for (std::size_t i = 0; i < selections.size(); ++i) {
    const Channel& channel = FindChannel(contents_, path_, selections[i]);
    for (const auto& [source, name] : names_) {
      if (name != channel.name) continue;
      wanted[source].emplace_back(i, selections[i], [&, id = source.id](const std::string& field) {
        return FindMavlinkMessage(id)->Find(field);
      });
    }
  }
  ByteFile file(path_);
  std::string buffer;
  ForEachTlogPacket(&file, [&](const TlogPacket& packet) {
    const auto found = wanted.find(SourceOf(packet));
    if (found == wanted.end()) return;
    const std::string_view payload = WholePayload(packet, *FindMavlinkMessage(packet.id), &buffer);
    for (auto& entry : found->second) entry.HandOn(packet.time, payload, sink);
  });
  return {};
}

}  // namespace

bool LooksLikeTlog(std::string_view first_bytes) { return BeginsTlogRecord(first_bytes); }

std::unique_ptr<Recording> OpenTlog(const std::filesystem::path& path) {
  return std::make_unique<TlogRecording>(path);
}

}  // namespace fathom
