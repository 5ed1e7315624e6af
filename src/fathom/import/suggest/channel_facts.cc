// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/channel_facts.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fathom {

std::string FirstChannelOf(const Contents& contents, std::string_view type) {
  for (const Channel& channel : contents.channels) {
    if (channel.type == type && channel.count > 1) return channel.name;
  }
  return {};
}

bool HasField(const Contents& contents, const std::string& channel, std::string_view field) {
  return std::any_of(contents.channels.begin(), contents.channels.end(), [&](const Channel& c) {
    return c.name == channel && std::any_of(c.fields.begin(), c.fields.end(), [&](const Field& f) {
             return f.name == field;
           });
  });
}

int NumThatReach(const Recording& recording,
                 const std::string& channel,
                 std::span<const std::string> fields,
                 double value) {
  Selection selection = {channel, {}};
  for (const std::string& field : fields) {
    if (!HasField(recording.contents(), channel, field)) break;
    selection.fields.push_back(field);
  }
  std::vector<bool> reaches(selection.fields.size(), false);
  recording.Read({&selection, 1}, [&](std::size_t, double, std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] >= value) reaches[i] = true;
    }
  });
  return static_cast<int>(std::find(reaches.begin(), reaches.end(), false) - reaches.begin());
}

bool IsEverAbove0(const Recording& recording,
                  const std::string& channel,
                  const std::string& field) {
  const Selection selection = {channel, {field}};
  bool is_above = false;
  recording.Read({&selection, 1}, [&](std::size_t, double, std::span<const double> values) {
    is_above = is_above || values.front() > 0.0;
  });
  return is_above;
}

}  // namespace fathom
