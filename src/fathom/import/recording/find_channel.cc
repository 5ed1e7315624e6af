// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/find_channel.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kMostNames = 40;
constexpr std::size_t kFewFields = 20;

// "'a', 'b', ...".
std::string Listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i) {
    text += (i == 0 ? "" : ", ") + Quoted(names[i]);
  }
  return names.size() > kMostNames ? text + ", ..." : text;
}

// Why a name may be missing: what the contents say of it, or of a file that is cut or damaged.
std::string WhyMissing(const Contents& contents, const std::string& name) {
  constexpr std::size_t kMostReasons = 3;
  std::string why;
  std::size_t num_reasons = 0;
  for (const std::string& remark : contents.remarks) {
    const bool names_it = remark.find(Quoted(name)) != std::string::npos;
    if (!names_it && contents.IsComplete()) continue;
    if (num_reasons++ == kMostReasons) break;
    why += " " + remark;
  }
  return why.empty() ? "" : " Not all of the file is read:" + why;
}

}  // namespace

const Channel& FindChannel(const Contents& contents,
                           const std::filesystem::path& path,
                           const Selection& selection) {
  const auto& channels = contents.channels;
  const auto channel = std::find_if(channels.begin(), channels.end(), [&](const Channel& c) {
    return c.name == selection.channel;
  });
  if (channel == channels.end()) {
    std::vector<std::string> names;
    for (const Channel& c : channels) names.push_back(c.name);
    throw InputError(fmt::format("{}: holds no channel {}, expected one of {}.{}",
                                 path.string(),
                                 Quoted(selection.channel),
                                 Listed(names),
                                 WhyMissing(contents, selection.channel)));
  }
  // Of many fields of many, one search each would take their product.
  const auto& fields = channel->fields;
  std::set<std::string_view> known;
  if (selection.fields.size() > kFewFields) {
    for (const Field& field : fields) known.insert(field.name);
  }
  const auto is_there = [&](const std::string& name) {
    if (!known.empty()) return known.contains(name);
    return std::any_of(
        fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
  };
  for (const std::string& name : selection.fields) {
    if (is_there(name)) continue;
    std::vector<std::string> names;
    for (const Field& field : fields) names.push_back(field.name);
    throw InputError(fmt::format("{}: {}has no field {}, expected one of {}.{}",
                                 path.string(),
                                 channel->name.empty() ? "" : "channel " + channel->name + " ",
                                 Quoted(name),
                                 Listed(names),
                                 WhyMissing(contents, name)));
  }
  return *channel;
}

}  // namespace fathom
