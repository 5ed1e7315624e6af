// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/gather_streams.h"

#include "fathom/base/input_error.h"
#include "fathom/import/convert/assembled_stream.h"
#include "fathom/import/convert/channel_part.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// What is asked of the recording for one stream.
struct StreamRequest {
  const char* name;
  StreamMap map;
  std::vector<ChannelPart> parts = {};
};

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
    request.parts =
        ChannelPartsOf(file, recording.contents(), request.map, is_plain, &gathered.remarks);
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
    part_of_stamps[i - part_of.size()]->TakeStamp(values);
  };
  for (std::string& remark : recording.Read(selections, take)) {
    gathered.remarks.push_back(std::move(remark));
  }
  for (ChannelPart* part : part_of_stamps) TakeOtherStamps(file, part);
  for (const ChannelPart* part : part_of) TellStampUnit(*part, &gathered.remarks);

  for (StreamRequest& request : requests) {
    GatheredStream stream = Assembled(file,
                                      request.name,
                                      request.map,
                                      std::move(request.parts),
                                      &gathered.out_of_order,
                                      &gathered.remarks);
    const std::string_view name = request.name;
    if (name == "command") gathered.command = std::move(stream);
    if (name == "voltage") gathered.voltage = std::move(stream.samples);
    if (name == "velocity") gathered.velocity = std::move(stream);
    if (name == "pose") gathered.pose = std::move(stream);
  }
  return gathered;
}

}  // namespace fathom
