// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/dataflash/dataflash_recording.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/import/dataflash/gps_time.h"
#include "fathom/import/dataflash/message_units.h"
#include "fathom/import/dataflash/message_walk.h"
#include "fathom/import/recording/channel_stamps.h"
#include "fathom/import/recording/find_channel.h"
#include "fathom/import/recording/wanted_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

// The fields of a type that listing and reading look at in every message.
struct CommonFields {
  const MessageField* stamp = nullptr;     // [s]; null if there is none
  const MessageField* instance = nullptr;  // which of several sensors it is of; likewise
};

// Keeps the setting that a message PARM states.
void TakeParameter(const MessageFormat& format,
                   std::string_view message,
                   std::map<std::string, double>* parameters) {
  if (format.name != "PARM") return;
  const MessageField* name = format.FindText("Name");
  const MessageField* value = format.FindNumber("Value");
  if (name == nullptr || value == nullptr) return;
  constexpr std::size_t kMostParameters = 10000;
  if (parameters->size() >= kMostParameters) return;
  (*parameters)[std::string(TextOf(*name, message))] = ValueOf(*value, message);
}

CommonFields CommonFieldsOf(const MessageFormat& format) {
  CommonFields fields;
  fields.stamp = format.FindNumber("TimeUS");
  if (fields.stamp == nullptr) fields.stamp = format.FindNumber("TimeMS");
  for (const MessageField& field : format.numbers) {
    if (field.unit != "instance") continue;
    fields.instance = &field;
    break;
  }
  return fields;
}

// By type.
std::array<CommonFields, 256> CommonFieldsOf(const MessageFormats& formats) {
  std::array<CommonFields, 256> fields;
  std::transform(formats.begin(), formats.end(), fields.begin(), [](const MessageFormat& format) {
    return CommonFieldsOf(format);
  });
  return fields;
}

// NaN if it has none.
double StampOf(const CommonFields& fields, std::string_view message) {
  return fields.stamp == nullptr ? NAN : ValueOf(*fields.stamp, message);
}

int InstanceOf(const CommonFields& fields, std::string_view message) {
  if (fields.instance == nullptr) return 0;
  const double number = ValueOf(*fields.instance, message);
  // Instances are few; a damaged one is of none of them.
  return number >= 0.0 && number < 256.0 ? static_cast<int>(number) : -1;
}

class DataflashRecording final : public Recording {
 public:
  explicit DataflashRecording(const std::filesystem::path& path) : path_(path) {
    ByteFile file(path);
    int num_redefined = 0;
    formats_ = ReadFormats(&file, &num_redefined);
    AddUnits(&file, &formats_);
    List(&file);
    if (num_redefined > 0) {
      contents_.remarks.push_back(fmt::format(
          "{} messages FMT define a type anew that was defined otherwise; the first definition "
          "holds.",
          num_redefined));
    }
  }

  const Contents& contents() const override { return contents_; }

  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override;

 private:
  void List(ByteFile* file);

  std::filesystem::path path_;
  MessageFormats formats_;
  Contents contents_;
};

void DataflashRecording::List(ByteFile* file) {
  std::map<std::pair<int, int>, ChannelStamps> stamps;  // by type and instance
  std::map<int, int> num_instances;
  const std::array<CommonFields, 256> fields = CommonFieldsOf(formats_);
  GpsTime gps_time;
  std::uint64_t num_messages = 0;
  const MessageWalk walk =
      ForEachMessage(file, formats_, [&](const MessageFormat& format, std::string_view message) {
        const auto [place, is_new] =
            stamps.try_emplace({format.type, InstanceOf(fields[format.type], message)});
        if (is_new) ++num_instances[format.type];
        place->second.Add(StampOf(fields[format.type], message));
        gps_time.Take(format, message);
        TakeParameter(format, message, &contents_.parameters);
        ++num_messages;
      });
  if (num_messages == 0) {
    throw InputError(path_.string() + ": holds no whole message, expected a DataFlash log.");
  }
  contents_.format = "dataflash";
  contents_.utc_of_zero = gps_time.utc_of_zero();
  contents_.size_bytes = file->size();
  contents_.read_bytes = file->size() - walk.skipped_bytes - walk.cut_bytes;
  for (const auto& [key, channel_stamps] : stamps) {
    const auto& [type, instance] = key;
    const MessageFormat& format = formats_[type];
    Channel channel;
    channel.type = format.name;
    channel.name =
        num_instances[type] == 1 ? format.name : fmt::format("{}[{}]", format.name, instance);
    for (const MessageField& field : format.numbers) {
      channel.fields.push_back({field.name, field.unit});
    }
    channel_stamps.WriteTo(&channel);
    contents_.channels.push_back(std::move(channel));
  }
  std::ranges::stable_sort(contents_.channels, {}, &Channel::type);
  contents_.TellSimulation();
  if (walk.skipped_bytes > 0) {
    contents_.remarks.push_back(
        fmt::format("{} of {} bytes belong to no message, the first at byte {}: damage, or a type "
                    "that no FMT defines.",
                    walk.skipped_bytes,
                    file->size(),
                    walk.first_skipped));
  }
  if (walk.cut_bytes > 0) {
    contents_.remarks.push_back(
        fmt::format("the file ends within a message {}: the {} from byte {} on are not read.",
                    walk.cut_message,
                    Plural(walk.cut_bytes, "byte"),
                    file->size() - walk.cut_bytes));
  }
}

std::vector<std::string> DataflashRecording::Read(std::span<const Selection> selections,
                                                  const SampleSink& sink) const {
  struct Wanted {
    std::optional<int> instance;
    WantedFields<MessageField> fields;
  };
  std::array<std::vector<Wanted>, 256> wanted;  // by type
  for (std::size_t i = 0; i < selections.size(); ++i) {
    const Channel& channel = FindChannel(contents_, path_, selections[i]);
    const auto format = std::find_if(formats_.begin(), formats_.end(), [&](const auto& f) {
      return f.type >= 0 && f.name == channel.type;
    });
    std::optional<int> instance;
    if (channel.name != channel.type) {
      instance = std::stoi(channel.name.substr(channel.type.size() + 1));
    }
    const auto find = [&](const std::string& field) { return format->FindNumber(field); };
    wanted[format->type].push_back({instance, {i, selections[i], find}});
  }
  const std::array<CommonFields, 256> fields = CommonFieldsOf(formats_);
  ByteFile file(path_);
  ForEachMessage(&file, formats_, [&](const MessageFormat& format, std::string_view message) {
    const CommonFields& common = fields[format.type];
    for (Wanted& entry : wanted[format.type]) {
      if (entry.instance && *entry.instance != InstanceOf(common, message)) continue;
      entry.fields.HandOn(StampOf(common, message), message, sink);
    }
  });
  return {};
}

}  // namespace

bool LooksLikeDataflash(std::string_view first_bytes) {
  return first_bytes.starts_with("\xa3\x95");
}

std::unique_ptr<Recording> OpenDataflash(const std::filesystem::path& path) {
  return std::make_unique<DataflashRecording>(path);
}

}  // namespace fathom
