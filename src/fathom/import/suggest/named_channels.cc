// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/named_channels.h"

#include "fathom/base/number.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace fathom {
namespace {

// What the columns of an array with such a name are, in the order of Fossen's vectors.
struct VectorNames {
  std::vector<std::string_view> arrays;  // in lower case, letters only
  std::vector<const char*> columns;
};

const std::vector<VectorNames>& KnownVectors() {
  static const std::vector<VectorNames> kVectors = {
      {{"eta", "pose"}, {"x", "y", "z", "roll", "pitch", "yaw"}},
      {{"nu", "velocity", "vel", "linearspeed", "linearvelocity"}, {"u", "vy", "w", "p", "q", "r"}},
      {{"angularspeed", "angularvelocity", "omega", "gyro", "rates"}, {"p", "q", "r"}},
      {{"tau", "thrust", "force", "wrench"},
       {"tau_surge", "tau_sway", "tau_heave", "tau_roll", "tau_pitch", "tau_yaw"}}};
  return kVectors;
}

// "eta" of "run.Eta".
std::string LastPart(const std::string& name) {
  std::string letters;
  for (const char c : name.substr(name.rfind('.') + 1)) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters;
}

// The name of this column of an array; empty if it is not known.
std::string NameOfColumn(const std::string& array, std::size_t index) {
  const std::string letters = LastPart(array);
  for (const VectorNames& known : KnownVectors()) {
    const auto& arrays = known.arrays;
    const bool is_it = std::find(arrays.begin(), arrays.end(), letters) != arrays.end();
    if (is_it && index < known.columns.size()) return known.columns[index];
  }
  return "";
}

// What the field of an array of a .mat or .npz is called.
std::string NameOf(const Channel& channel, std::size_t index) {
  if (channel.fields.size() == 1) return channel.name.substr(channel.name.rfind('.') + 1);
  const std::string name = NameOfColumn(channel.name, index);
  return name.empty() ? channel.name + " " + channel.fields[index].name : name;
}

// The same of a field of a struct: x of "eta.1".
std::string NameInStruct(const std::string& field) {
  const std::size_t dot = field.rfind('.');
  const auto number =
      dot == std::string::npos ? std::nullopt : ParseFiniteNumber(field.substr(dot + 1));
  if (!number || *number < 1.0 || *number > 100.0) return field;
  const std::string name =
      NameOfColumn(field.substr(0, dot), static_cast<std::size_t>(*number) - 1);
  return name.empty() ? field : name;
}

bool IsTimeArray(const Channel& channel) {
  const std::string letters = LastPart(channel.name);
  return channel.fields.size() == 1 &&
         (letters == "t" || letters == "time" || letters == "stamp" || letters == "timestamp");
}

// Of a table with one column beside its stamps, whose name says nothing, the name of the table:
// "cmd" of cmd.csv, as `rostopic echo -p` writes %time and field.
void NameByTable(Channel* channel) {
  if (channel->type != "table" || !channel->clock || channel->fields.size() != 2) return;
  const auto is_clock = [&](const Field& field) { return field.number == channel->clock->number; };
  Field& field = is_clock(channel->fields[0]) ? channel->fields[1] : channel->fields[0];
  const std::string letters = LastPart(field.name);
  if (letters == "field" || letters == "data" || letters == "value") field.name = channel->name;
}

}  // namespace

std::vector<NamedChannel> NamedChannels(const Contents& contents) {
  std::vector<NamedChannel> all;
  std::map<std::uint64_t, NamedChannel> of_count;  // arrays without stamps
  // Arrays of MATLAB or numpy, whose columns may have no other name than a number.
  const bool has_arrays = contents.format.starts_with("mat") || contents.format.starts_with("np");
  for (const Channel& channel : contents.channels) {
    const bool is_array = has_arrays && !channel.first;
    NamedChannel own;
    own.channel = channel;
    NamedChannel& named = is_array ? of_count[channel.count] : own;
    for (std::size_t i = 0; i < channel.fields.size(); ++i) {
      named.places.push_back({channel.name, channel.fields[i].name});
      if (is_array) {
        named.channel.fields.push_back({NameOf(channel, i), "", 0});
      } else if (has_arrays) {
        named.channel.fields[i].name = NameInStruct(channel.fields[i].name);
      }
    }
    if (!is_array) {
      NameByTable(&own.channel);
      all.push_back(std::move(own));
      continue;
    }
    if (named.channel.name.empty()) named.channel.name = channel.name;
    if (named.time_channel.empty() && IsTimeArray(channel)) named.time_channel = channel.name;
  }
  for (auto& entry : of_count) all.push_back(std::move(entry.second));
  return all;
}

}  // namespace fathom
