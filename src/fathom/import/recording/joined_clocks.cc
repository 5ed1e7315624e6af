// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/joined_clocks.h"

#include "fathom/base/quoted.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

// GPS tells the UTC of a start to about a second; no vehicle starts again this fast.
constexpr double kSameStart = 3.0;  // [s]

// Two parts of one recording may meet within a buffer's length.
constexpr double kLongestMeeting = 1.0;  // [s]

// Tables of one name are channels apart, and are no parts of one recording.
bool AreOfOneRecorder(const Contents& a, const Contents& b) {
  return a.format == b.format && a.format != "csv";
}

// A channel that both hold at the same time; null if there is none.
const Channel* FindChannelAtOnce(const Contents& a, const Contents& b) {
  std::map<std::string_view, const Channel*> of_b;
  for (const Channel& channel : b.channels) of_b.emplace(channel.name, &channel);
  for (const Channel& channel : a.channels) {
    const auto other = of_b.find(channel.name);
    if (other == of_b.end() || other->second->type != channel.type) continue;
    if (!channel.first || !other->second->first) continue;
    const double begin = std::max(*channel.first, *other->second->first);
    const double end = std::min(*channel.last, *other->second->last);
    if (end - begin > kLongestMeeting) return &channel;
  }
  return nullptr;
}

bool ShareAChannel(const Contents& a, const Contents& b) {
  return std::any_of(a.channels.begin(), a.channels.end(), [&](const Channel& channel) {
    return channel.first &&
           std::any_of(b.channels.begin(), b.channels.end(), [&](const Channel& c) {
             return c.first && c.name == channel.name && c.type == channel.type;
           });
  });
}

// Moves the files that tell their UTC to the clock that begins first.
void MoveToOneClock(const std::vector<ClockOfPart>& parts, JoinedClocks* joined) {
  std::vector<std::size_t> told;  // files, by the UTC of their stamp 0
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].contents->utc_of_zero) told.push_back(i);
  }
  if (told.empty()) return;
  const auto utc_of = [&](std::size_t i) { return *parts[i].contents->utc_of_zero; };
  std::stable_sort(told.begin(), told.end(), [&](std::size_t a, std::size_t b) {
    return utc_of(a) < utc_of(b);
  });
  const double zero = utc_of(told.front());
  if (told.size() == parts.size()) joined->utc_of_zero = zero;
  std::map<std::string, double> last_start;  // by format
  for (const std::size_t i : told) {
    const auto [start, is_new] = last_start.try_emplace(parts[i].contents->format, utc_of(i));
    if (utc_of(i) - start->second >= kSameStart) start->second = utc_of(i);
    joined->shifts[i] = start->second - zero;
    if (joined->shifts[i] == 0.0) continue;
    joined->remarks.push_back(
        fmt::format("{}: its stamps are moved by {:.3f} s to the clock of {}, by the UTC that both "
                    "tell. GPS tells it to about a second.",
                    Printable(parts[i].file),
                    joined->shifts[i],
                    Printable(parts[told.front()].file)));
  }
}

}  // namespace

JoinedClocks JoinClocks(const std::vector<ClockOfPart>& parts) {
  JoinedClocks joined;
  joined.shifts.assign(parts.size(), 0.0);
  MoveToOneClock(parts, &joined);
  const auto is_told = [&](std::size_t i) { return parts[i].contents->utc_of_zero.has_value(); };
  std::set<std::string> moved_formats;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (joined.shifts[i] != 0.0) moved_formats.insert(parts[i].contents->format);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t k = i + 1; k < parts.size(); ++k) {
      const Contents& a = *parts[i].contents;
      const Contents& b = *parts[k].contents;
      if ((is_told(i) && is_told(k)) || !AreOfOneRecorder(a, b)) continue;
      const Channel* at_once = FindChannelAtOnce(a, b);
      // A file without UTC may be of any of the clocks of its format.
      const bool is_moved = moved_formats.contains(a.format);
      if (at_once == nullptr && !(is_moved && ShareAChannel(a, b))) continue;
      const std::string file = Printable(parts[i].file), other = Printable(parts[k].file);
      joined.conflicts.push_back(
          {parts[i].file,
           parts[k].file,
           fmt::format(
               "{} and {} count their stamps from {}, and {} no UTC, as of a GPS with a fix, from "
               "which the time between them would follow",
               file,
               other,
               at_once != nullptr
                   ? "two starts of the vehicle: both hold " + Quoted(at_once->name) +
                         " at the same stamps"
                   : "starts of the vehicle that may differ: files of the folder are moved by "
                     "their UTC",
               is_told(i)   ? other + " has"
               : is_told(k) ? file + " has"
                            : "they have")});
    }
  }
  return joined;
}

}  // namespace fathom
