// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/channel_part.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// The stamp that the last field holds, or the last two: seconds and nanoseconds [s]. The first one
// says of which unit they are where nobody does.
double StampOf(ColumnSource* time, bool has_nanoseconds, std::span<const double> values) {
  const double number = values[values.size() - (has_nanoseconds ? 2 : 1)];
  if (time->is_unit_open && std::isfinite(number)) {
    time->unit = *FindUnit(UnitOfStamp(number), Dimension::kTime);
    time->is_unit_open = false;
  }
  return time->InSi(number) + (has_nanoseconds ? 1e-9 * values.back() : 0.0);
}

void AddColumn(const ColumnSource& source,
               const StreamMap& stream,
               std::vector<ChannelPart>* parts) {
  auto part = std::find_if(parts->begin(), parts->end(), [&](const ChannelPart& p) {
    return p.selection.channel == source.selection.channel;
  });
  if (part == parts->end()) {
    ChannelPart added;
    added.selection.channel = source.selection.channel;
    added.samples.channel = source.selection.channel;
    added.rate = stream.rate;
    added.delay = stream.delay;
    part = parts->insert(parts->end(), std::move(added));
  }
  part->columns.push_back(source);
  for (const std::string& field : source.selection.fields) {
    part->selection.fields.push_back(field);
    ++part->num_fields;
  }
  part->samples.values.emplace_back();
}

// Whether the stamps have a field of nanoseconds, which is then selected behind their seconds.
bool AddNanoseconds(const StreamMap& stream, Selection* selection) {
  if (stream.nanoseconds.empty()) return false;
  selection->fields.push_back(stream.nanoseconds);
  return true;
}

// Of a stream whose stamps are a field, that field of each of its channels, or of the channel that
// the map names.
void AddTime(const std::filesystem::path& file,
             const Contents& contents,
             const StreamMap& stream,
             std::vector<ChannelPart>* parts,
             std::vector<std::string>* remarks) {
  if (!stream.time) return;
  for (ChannelPart& part : *parts) {
    ColumnMap time = *stream.time;
    if (!time.channel.empty() && time.channel != part.selection.channel) {
      part.other_time = SourceOf(file, contents, stream, "time", time, /*is_plain=*/false, remarks);
      part.has_nanoseconds = AddNanoseconds(stream, &part.other_time->selection);
      part.is_unit_guessed = part.other_time->is_unit_open;
      continue;
    }
    time.channel = part.selection.channel;
    part.time = SourceOf(file, contents, stream, "time", time, /*is_plain=*/false, remarks);
    part.selection.fields.push_back(part.time->selection.fields.front());
    part.has_nanoseconds = AddNanoseconds(stream, &part.selection);
    part.is_unit_guessed = part.time->is_unit_open;
  }
}

void AddConditions(const StreamMap& stream, std::vector<ChannelPart>* parts) {
  for (ChannelPart& part : *parts) {
    for (const Condition& condition : stream.where) {
      part.selection.fields.push_back(condition.field);
      part.conditions.push_back(condition.value);
    }
  }
}

}  // namespace

void ChannelPart::Take(double time, std::span<const double> values) {
  const std::uint64_t index = num_samples++;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (values[num_fields + i] != conditions[i]) return;
  }
  if (this->time) time = StampOf(&*this->time, has_nanoseconds, values);
  // Rows without a stamp come at the rate, each after the one before.
  if (rate) time = static_cast<double>(num_seen) / *rate;
  ++num_seen;
  // Which of the other channel's stamps is known when all is read.
  samples.time.push_back(other_time ? static_cast<double>(index) : time + delay);
  std::size_t next = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < columns[i].selection.fields.size(); ++k) sum += values[next++];
    samples.values[i].push_back(columns[i].InSi(sum));
  }
}

void ChannelPart::TakeStamp(std::span<const double> values) {
  other_stamps.push_back(StampOf(&*other_time, has_nanoseconds, values));
}

std::vector<ChannelPart> ChannelPartsOf(const std::filesystem::path& file,
                                        const Contents& contents,
                                        const StreamMap& stream,
                                        bool is_plain,
                                        std::vector<std::string>* remarks) {
  std::vector<ChannelPart> parts;
  for (const auto& [column, map] : stream.columns) {
    const bool is_angle_or_turns = column.starts_with("fin_") || column.starts_with("shaft_");
    const bool stays = (is_plain && !is_angle_or_turns) || map.pulses;
    AddColumn(SourceOf(file, contents, stream, column, map, stays, remarks), stream, &parts);
  }
  AddConditions(stream, &parts);
  AddTime(file, contents, stream, &parts, remarks);
  return parts;
}

void TakeOtherStamps(const std::filesystem::path& file, ChannelPart* part) {
  if (!part->other_time) return;
  if (part->other_stamps.size() != part->num_samples) {
    throw InputError(fmt::format("{}: {} holds {}, expected as many as {} has samples: {}.",
                                 file.string(),
                                 part->other_time->selection.channel,
                                 Plural(part->other_stamps.size(), "stamp"),
                                 part->selection.channel,
                                 part->num_samples));
  }
  for (double& time : part->samples.time) {
    time = part->other_stamps[static_cast<std::size_t>(time)] + part->delay;
  }
}

void TellStampUnit(const ChannelPart& part, std::vector<std::string>* remarks) {
  if (!part.is_unit_guessed) return;
  const ColumnSource& time = part.time ? *part.time : *part.other_time;
  std::string_view unit = "s";
  for (const std::string_view name : {"ns", "us", "ms"}) {
    if (FindUnit(name, Dimension::kTime)->factor == time.unit.factor) unit = name;
  }
  const std::string& field = time.selection.fields.front();
  std::string remark = fmt::format(
      "{} {} states no unit: its stamps are taken as {}. The map says another one by 'time: "
      "{{field: {}, unit: {}}}'.",
      time.selection.channel,
      Quoted(field),
      unit == "s" ? "seconds" : fmt::format("{} since 1970", unit),
      field,
      unit == "s" ? "ms" : "s");
  if (std::find(remarks->begin(), remarks->end(), remark) == remarks->end()) {
    remarks->push_back(std::move(remark));
  }
}

}  // namespace fathom
