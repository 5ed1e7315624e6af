// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/channel_facts.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace fathom {

std::string FirstChannelOf(const Contents& contents, std::string_view type) {
  for (const Channel& channel : contents.channels) {
    if (channel.type == type && channel.count > 1) return channel.name;
  }
  return {};
}

bool HasField(const Channel& channel, std::string_view field) {
  return std::ranges::any_of(channel.fields, [&](const Field& f) { return f.name == field; });
}

bool HasField(const Contents& contents, const std::string& channel, std::string_view field) {
  return std::ranges::any_of(
      contents.channels, [&](const Channel& c) { return c.name == channel && HasField(c, field); });
}

std::string WithNumber(std::string field, int number) {
  const std::size_t place = field.find('#');
  return place == std::string::npos ? field : field.replace(place, 1, std::to_string(number));
}

std::vector<bool> ThatReach(const Recording& recording,
                            std::span<const FieldPlace> places,
                            double value) {
  std::vector<Selection> selections;
  std::vector<std::vector<std::size_t>> indices;  // of the fields of a selection, in `places`
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].field.empty()) continue;
    const auto found = std::find_if(selections.begin(), selections.end(), [&](const auto& s) {
      return s.channel == places[i].channel;
    });
    const auto index = static_cast<std::size_t>(found - selections.begin());
    if (found == selections.end()) {
      selections.push_back({places[i].channel, {}});
      indices.emplace_back();
    }
    selections[index].fields.push_back(places[i].field);
    indices[index].push_back(i);
  }
  std::vector<bool> reaches(places.size(), false);
  if (selections.empty()) return reaches;
  recording.Read(selections, [&](std::size_t s, double, std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] >= value) reaches[indices[s][i]] = true;
    }
  });
  return reaches;
}

int NumThatReach(const Recording& recording,
                 const std::string& channel,
                 const std::vector<std::string>& fields,
                 double value) {
  std::vector<FieldPlace> places;
  for (const std::string& field : fields) {
    if (!HasField(recording.contents(), channel, field)) break;
    places.push_back({channel, field});
  }
  const std::vector<bool> reaches = ThatReach(recording, places, value);
  return static_cast<int>(std::find(reaches.begin(), reaches.end(), false) - reaches.begin());
}

double LargestOf(const Recording& recording, const std::string& channel, const std::string& field) {
  const Selection selection = {channel, {field}};
  double largest = -std::numeric_limits<double>::infinity();
  recording.Read({&selection, 1}, [&](std::size_t, double, std::span<const double> values) {
    largest = std::max(largest, values.front());  // NaN is not larger
  });
  return largest;
}

}  // namespace fathom
