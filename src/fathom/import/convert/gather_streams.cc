// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/gather_streams.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/import/convert/stream_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// A channel of commands that sends nothing for so long has fallen silent.
constexpr double kSilentSteps = 10.0;
constexpr double kShortestSilence = 1.0;  // [s]

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

// The columns of one stream that one channel holds.
struct ChannelPart {
  Selection selection;  // the columns' fields, then those of the conditions
  std::vector<ColumnSource> columns;
  std::size_t num_fields = 0;              // of all columns together
  std::vector<double> conditions;          // the values that the latter must have
  std::optional<ColumnSource> time;        // the field of the stamps, behind all of them
  bool has_nanoseconds = false;            // a field of these follows the stamps
  std::optional<ColumnSource> other_time;  // instead: stamps of another channel, one a sample
  std::vector<double> other_stamps;        // [s]
  bool is_unit_guessed = false;            // of the stamps
  std::optional<double> rate;
  double delay = 0.0;
  ChannelSamples samples;
  std::uint64_t num_seen = 0;     // that the conditions let through
  std::uint64_t num_samples = 0;  // of the channel

  void Take(double time, std::span<const double> values) {
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
};

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

// Says of which unit stamps were taken that state none.
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

// Angles from -pi to pi go on beyond, so that a line between two of them is the short way.
void Unwrap(std::vector<double>* angles) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  for (std::size_t i = 1; i < angles->size(); ++i) {
    const double step = (*angles)[i] - (*angles)[i - 1];
    (*angles)[i] -= kTurn * std::round(step / kTurn);
  }
}

void TellLeftOut(const char* stream,
                 const std::string& channel,
                 const LeftOutRows& left_out,
                 std::vector<std::string>* remarks) {
  const std::string place = fmt::format("{} of {}: ", stream, channel);
  if (left_out.incomplete > 0) {
    remarks->push_back(fmt::format("{}{} left out, in which some cells are empty.",
                                   place,
                                   Plural(left_out.incomplete, "row")));
  }
  if (left_out.num_back > 0) {
    remarks->push_back(
        fmt::format("{}the stamps of {} lie before that of an earlier row; the rows were put in "
                    "order.",
                    place,
                    Plural(left_out.num_back, "row")));
  }
  if (left_out.repeated > 0) {
    remarks->push_back(
        fmt::format("{}{} left out, whose stamp another row has. The last one of a stamp stays.",
                    place,
                    Plural(left_out.repeated, "row")));
  }
}

// A command of several channels.
ChannelSamples JoinedCommand(const std::vector<ChannelSamples>& channels,
                             std::vector<std::string>* remarks) {
  ChannelSamples held = Held(channels);
  if (channels.size() == 1 || held.time.empty()) return held;
  remarks->push_back(
      fmt::format("command: each of {} holds its value until its next sample; the rows begin when "
                  "all have one, at {:.3f} s.",
                  held.channel,
                  held.time.front()));
  for (const ChannelSamples& channel : channels) {
    const double silent = held.time.back() - channel.time.back();
    const double longest = std::max(kSilentSteps * StepOf(channel), kShortestSilence);
    if (silent <= longest) continue;
    remarks->push_back(fmt::format(
        "command: {} falls silent at {:.3f} s, {:.1f} s before the last command: its last value is "
        "held.",
        channel.channel,
        channel.time.back(),
        silent));
  }
  return held;
}

// Speeds or poses of several channels.
ChannelSamples JoinedMeasurement(const char* name,
                                 const std::vector<ChannelSamples>& channels,
                                 std::vector<std::string>* remarks) {
  std::size_t num_alone = 0;
  ChannelSamples joined = Joined(channels, &num_alone);
  if (channels.size() > 1) {
    remarks->push_back(fmt::format(
        "{}: {} are brought to the stamps of the slowest of them.", name, joined.channel));
  }
  if (num_alone > 0) {
    remarks->push_back(fmt::format(
        "{}: {} left out, where another channel has a gap.", name, Plural(num_alone, "row")));
  }
  return joined;
}

// Where the columns of a channel hold a quaternion.
std::optional<std::array<std::size_t, 4>> QuaternionOf(const std::vector<ColumnSource>& columns) {
  constexpr std::array<std::string_view, 4> kNames = {"qx", "qy", "qz", "qw"};
  std::array<std::size_t, 4> indices = {};
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    const auto found = std::find_if(
        columns.begin(), columns.end(), [&](const auto& c) { return c.column == kNames[k]; });
    if (found == columns.end()) return std::nullopt;
    indices[k] = static_cast<std::size_t>(found - columns.begin());
  }
  return indices;
}

// Puts the channels of a stream together, its columns in the order of the map.
GatheredStream Assemble(const std::filesystem::path& file,
                        const char* name,
                        const StreamMap& stream,
                        std::vector<ChannelPart>* parts,
                        std::vector<StampsOutOfOrder>* out_of_order,
                        std::vector<std::string>* remarks) {
  std::vector<ChannelSamples> channels;
  std::vector<ColumnSource> columns;
  for (ChannelPart& part : *parts) {
    const std::size_t num_rows = part.samples.time.size();
    const LeftOutRows left_out = Clean(&part.samples);
    TellLeftOut(name, part.selection.channel, left_out, remarks);
    if (left_out.num_back > 0) {
      out_of_order->push_back(
          {name, static_cast<double>(left_out.num_back) / static_cast<double>(num_rows)});
    }
    for (std::size_t i = 0; i < part.columns.size(); ++i) {
      const bool is_attitude = part.columns[i].unit.dimension == Dimension::kAngle &&
                               !part.columns[i].column.starts_with("fin_");
      if (is_attitude) Unwrap(&part.samples.values[i]);
      columns.push_back(part.columns[i]);
    }
    part.samples.quaternion = QuaternionOf(part.columns);
    channels.push_back(std::move(part.samples));
  }
  const bool is_command = std::string_view(name) == "command";
  ChannelSamples joined =
      is_command ? JoinedCommand(channels, remarks) : JoinedMeasurement(name, channels, remarks);
  if (joined.time.size() < 2) {
    throw InputError(fmt::format("{}: {} of {} has {}, expected two at least.",
                                 file.string(),
                                 name,
                                 joined.channel,
                                 Plural(joined.time.size(), "sample")));
  }
  GatheredStream gathered;
  gathered.samples.channel = joined.channel;
  gathered.samples.time = std::move(joined.time);
  for (const auto& entry : stream.columns) {
    const std::string& column = entry.first;
    const auto at = std::find_if(columns.begin(), columns.end(), [&](const ColumnSource& source) {
      return source.column == column;
    });
    gathered.columns.push_back(column);
    gathered.dimensions.push_back(at->unit.dimension);
    gathered.samples.values.push_back(std::move(joined.values[at - columns.begin()]));
  }
  return gathered;
}

// What is asked of the recording for one stream.
struct StreamRequest {
  const char* name;
  StreamMap map;
  std::vector<ChannelPart> parts = {};
};

// Gives the samples of a part the stamps that another channel holds.
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

// Gives the column that counts rows where that is what the stamps are; else nothing.
std::string RequireStamps(const std::filesystem::path& file,
                          const Contents& contents,
                          const StreamRequest& request) {
  std::string counter;
  for (const ChannelPart& part : request.parts) {
    const auto channel =
        std::find_if(contents.channels.begin(), contents.channels.end(), [&](const Channel& c) {
          return c.name == part.selection.channel;
        });
    if (part.rate || part.time || part.other_time) continue;
    if (channel->first) {
      if (channel->clock_counts_rows) counter = channel->clock->name;
      continue;
    }
    throw InputError(
        fmt::format("{}: {} has no stamps, expected the map to give its 'rate' in Hz, "
                    "or the column or channel of the 'time'.",
                    file.string(),
                    channel->name));
  }
  return counter;
}

}  // namespace

GatheredStreams GatherStreams(const std::filesystem::path& file,
                              const Recording& recording,
                              const ImportMap& map) {
  GatheredStreams gathered;
  std::vector<StreamRequest> requests;
  if (map.command) requests.push_back({"command", *map.command});
  if (map.voltage) {
    StreamMap voltage = *map.command;
    voltage.columns = {{"voltage", *map.voltage}};
    voltage.where.clear();
    requests.push_back({"voltage", std::move(voltage)});
  }
  if (map.velocity) requests.push_back({"velocity", *map.velocity});
  if (map.pose) requests.push_back({"pose", *map.pose});

  std::vector<Selection> selections;
  for (StreamRequest& request : requests) {
    const bool is_plain = std::string_view(request.name) == "command" && !map.command_unit.empty();
    for (const auto& [column, column_map] : request.map.columns) {
      AddColumn(
          SourceOf(file,
                   recording.contents(),
                   request.map,
                   column,
                   column_map,
                   (is_plain && !column.starts_with("fin_") && !column.starts_with("shaft_")) ||
                       column_map.pulses,
                   &gathered.remarks),
          request.map,
          &request.parts);
    }
    AddConditions(request.map, &request.parts);
    AddTime(file, recording.contents(), request.map, &request.parts, &gathered.remarks);
    const std::string counter = RequireStamps(file, recording.contents(), request);
    if (!counter.empty()) gathered.row_counter = counter;
    for (const ChannelPart& part : request.parts) selections.push_back(part.selection);
  }
  std::vector<ChannelPart*> part_of;
  for (StreamRequest& request : requests) {
    for (ChannelPart& part : request.parts) part_of.push_back(&part);
  }
  std::vector<ChannelPart*> part_of_stamps;
  for (ChannelPart* part : part_of) {
    if (!part->other_time) continue;
    selections.push_back(part->other_time->selection);
    part_of_stamps.push_back(part);
  }
  const auto take = [&](std::size_t i, double time, std::span<const double> values) {
    if (i < part_of.size()) return part_of[i]->Take(time, values);
    ChannelPart* part = part_of_stamps[i - part_of.size()];
    part->other_stamps.push_back(StampOf(&*part->other_time, part->has_nanoseconds, values));
  };
  for (std::string& remark : recording.Read(selections, take)) {
    gathered.remarks.push_back(std::move(remark));
  }
  for (ChannelPart* part : part_of_stamps) TakeOtherStamps(file, part);
  for (const ChannelPart* part : part_of) TellStampUnit(*part, &gathered.remarks);

  for (StreamRequest& request : requests) {
    GatheredStream stream = Assemble(
        file, request.name, request.map, &request.parts, &gathered.out_of_order, &gathered.remarks);
    const std::string_view name = request.name;
    if (name == "command") gathered.command = std::move(stream);
    if (name == "voltage") gathered.voltage = std::move(stream.samples);
    if (name == "velocity") gathered.velocity = std::move(stream);
    if (name == "pose") gathered.pose = std::move(stream);
  }
  return gathered;
}

}  // namespace fathom
