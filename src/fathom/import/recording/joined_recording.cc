// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/joined_recording.h"

#include "fathom/base/input_error.h"
#include "fathom/import/recording/find_channel.h"
#include "fathom/import/recording/joined_clocks.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// A file with what is to be added to its stamps [s].
struct TimedPart {
  std::string file;
  std::unique_ptr<Recording> recording;
  double shift = 0.0;
};

// On the common clock.
double FirstStampOf(const TimedPart& part) {
  double first = std::numeric_limits<double>::infinity();
  for (const Channel& channel : part.recording->contents().channels) {
    if (channel.first) first = std::min(first, *channel.first + part.shift);
  }
  return first;
}

// With its stamps on the common clock.
Channel Shifted(Channel channel, double shift) {
  if (channel.first) *channel.first += shift;
  if (channel.last) *channel.last += shift;
  return channel;
}

// Appends the fields that are new.
void AddFields(const std::vector<Field>& from, std::vector<Field>* to) {
  for (const Field& field : from) {
    if (std::none_of(to->begin(), to->end(), [&](const Field& f) { return f.name == field.name; }))
      to->push_back(field);
  }
}

void Join(const Channel& other, Channel* channel) {
  AddFields(other.fields, &channel->fields);
  channel->count += other.count;
  if (!other.first) return;
  channel->first = std::min(channel->first.value_or(*other.first), *other.first);
  channel->last = std::max(channel->last.value_or(*other.last), *other.last);
}

class JoinedRecording final : public Recording {
 public:
  JoinedRecording(const std::filesystem::path& folder,
                  std::vector<RecordingPart> parts,
                  std::vector<std::string> remarks);

  const Contents& contents() const override { return contents_; }

  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override;

 private:
  // What a part's channel is called here.
  std::string NameOf(const TimedPart& part, const Channel& channel) const {
    return names_of_several_types_.contains(channel.name) ? part.file + "/" + channel.name
                                                          : channel.name;
  }

  void PutOnOneClock(std::vector<RecordingPart> parts);

  // Throws InputError where two files that are read count on clocks of unknown difference.
  void RefuseConflicts(std::span<const Selection> selections) const;

  std::filesystem::path folder_;
  std::vector<TimedPart> parts_;
  std::set<std::string> names_of_several_types_;
  std::vector<ClockConflict> conflicts_;
  Contents contents_;
};

void JoinedRecording::PutOnOneClock(std::vector<RecordingPart> parts) {
  std::vector<ClockOfPart> clocks;
  for (const RecordingPart& part : parts)
    clocks.push_back({part.file, &part.recording->contents()});
  JoinedClocks joined = JoinClocks(clocks);
  contents_.utc_of_zero = joined.utc_of_zero;
  conflicts_ = std::move(joined.conflicts);
  contents_.remarks.insert(contents_.remarks.end(), joined.remarks.begin(), joined.remarks.end());
  for (const ClockConflict& conflict : conflicts_) {
    contents_.remarks.push_back(conflict.why + ". They are not read together.");
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts_.push_back({std::move(parts[i].file), std::move(parts[i].recording), joined.shifts[i]});
  }
  std::stable_sort(parts_.begin(), parts_.end(), [](const TimedPart& a, const TimedPart& b) {
    return std::pair(FirstStampOf(a), a.file) < std::pair(FirstStampOf(b), b.file);
  });
}

void JoinedRecording::RefuseConflicts(std::span<const Selection> selections) const {
  if (conflicts_.empty()) return;
  std::set<std::string> read;
  for (const TimedPart& part : parts_) {
    for (const Channel& channel : part.recording->contents().channels) {
      const std::string name = NameOf(part, channel);
      if (std::any_of(selections.begin(), selections.end(), [&](const Selection& selection) {
            return selection.channel == name;
          })) {
        read.insert(part.file);
      }
    }
  }
  for (const ClockConflict& conflict : conflicts_) {
    if (!read.contains(conflict.first) || !read.contains(conflict.second)) continue;
    throw InputError(fmt::format("{}: {}, expected files of one clock. Import each by itself.",
                                 folder_.string(),
                                 conflict.why));
  }
}

JoinedRecording::JoinedRecording(const std::filesystem::path& folder,
                                 std::vector<RecordingPart> parts,
                                 std::vector<std::string> remarks)
    : folder_(folder) {
  contents_.remarks = std::move(remarks);
  if (parts.empty()) {
    throw InputError(fmt::format("{}: holds no recording that can be read.{}",
                                 folder.string(),
                                 contents_.remarks.empty() ? "" : " " + contents_.remarks.front()));
  }
  PutOnOneClock(std::move(parts));
  std::map<std::string, std::string> type_of;
  std::set<std::string> formats;
  for (const TimedPart& part : parts_) {
    formats.insert(part.recording->contents().format);
    for (const Channel& channel : part.recording->contents().channels) {
      const auto [known, is_new] = type_of.emplace(channel.name, channel.type);
      const bool is_table = part.recording->contents().format == "csv";
      if (!is_new && (is_table || known->second != channel.type)) {
        names_of_several_types_.insert(channel.name);
      }
    }
  }
  contents_.format = formats.size() == 1 ? *formats.begin() : "several";
  std::map<std::string, Channel> channels;
  for (const TimedPart& part : parts_) {
    const Contents& of_part = part.recording->contents();
    for (const Channel& own : of_part.channels) {
      const Channel channel = Shifted(own, part.shift);
      const std::string name = NameOf(part, channel);
      const auto [known, is_new] = channels.try_emplace(name, channel);
      known->second.name = name;
      if (!is_new) Join(channel, &known->second);
    }
    for (const auto& [name, value] : of_part.parameters) contents_.parameters[name] = value;
    contents_.read_bytes += of_part.read_bytes;
    contents_.size_bytes += of_part.size_bytes;
    for (const std::string& remark : of_part.remarks) {
      contents_.remarks.push_back(part.file + ": " + remark);
    }
  }
  for (auto& [name, channel] : channels) contents_.channels.push_back(std::move(channel));
}

std::vector<std::string> JoinedRecording::Read(std::span<const Selection> selections,
                                               const SampleSink& sink) const {
  for (const Selection& selection : selections) FindChannel(contents_, folder_, selection);
  RefuseConflicts(selections);
  std::vector<std::string> remarks;
  for (const TimedPart& part : parts_) {
    std::vector<Selection> of_part;
    // By selection of the part: which of ours it is, and the places of its fields in that.
    std::vector<std::pair<std::size_t, std::vector<std::size_t>>> ours;
    for (const Channel& channel : part.recording->contents().channels) {
      const std::string name = NameOf(part, channel);
      for (std::size_t i = 0; i < selections.size(); ++i) {
        if (selections[i].channel != name) continue;
        Selection selection = {channel.name, {}};
        std::vector<std::size_t> places;
        for (std::size_t k = 0; k < selections[i].fields.size(); ++k) {
          const auto& fields = channel.fields;
          if (std::none_of(fields.begin(), fields.end(), [&](const Field& field) {
                return field.name == selections[i].fields[k];
              })) {
            continue;
          }
          selection.fields.push_back(selections[i].fields[k]);
          places.push_back(k);
        }
        of_part.push_back(std::move(selection));
        ours.emplace_back(i, std::move(places));
      }
    }
    if (of_part.empty()) continue;
    std::vector<double> all;
    const double shift = part.shift;
    const auto found = part.recording->Read(
        of_part, [&](std::size_t selection, double time, std::span<const double> values) {
          const auto& [index, places] = ours[selection];
          all.assign(selections[index].fields.size(), std::numeric_limits<double>::quiet_NaN());
          for (std::size_t k = 0; k < places.size(); ++k) all[places[k]] = values[k];
          sink(index, time + shift, all);
        });
    for (const std::string& remark : found) remarks.push_back(part.file + ": " + remark);
  }
  return remarks;
}

}  // namespace

std::unique_ptr<Recording> JoinRecordings(const std::filesystem::path& folder,
                                          std::vector<RecordingPart> parts,
                                          std::vector<std::string> remarks) {
  return std::make_unique<JoinedRecording>(folder, std::move(parts), std::move(remarks));
}

}  // namespace fathom
