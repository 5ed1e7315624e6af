// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/assembled_stream.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// A channel of commands that sends nothing for so long has fallen silent.
constexpr double kSilentSteps = 10.0;
constexpr double kShortestSilence = 1.0;  // [s]

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
                 std::size_t num_rows,
                 const LeftOutRows& left_out,
                 std::vector<std::string>* remarks) {
  const std::string place = fmt::format("{} of {}: ", stream, channel);
  if (left_out.empty > 0) {
    remarks->push_back(fmt::format("{}{} of {} left out, in which no cell holds a number.",
                                   place,
                                   Plural(left_out.empty, "row"),
                                   num_rows));
  }
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

}  // namespace

GatheredStream Assembled(const std::filesystem::path& file,
                         const char* name,
                         const StreamMap& stream,
                         std::vector<ChannelPart> parts,
                         std::vector<StampsOutOfOrder>* out_of_order,
                         std::vector<std::string>* remarks) {
  std::vector<ChannelSamples> channels;
  std::vector<ColumnSource> columns;
  for (ChannelPart& part : parts) {
    const std::size_t num_rows = part.samples.time.size();
    const LeftOutRows left_out = Clean(&part.samples);
    TellLeftOut(name, part.selection.channel, num_rows, left_out, remarks);
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

}  // namespace fathom
