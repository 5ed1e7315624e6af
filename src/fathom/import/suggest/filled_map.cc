// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/filled_map.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/import/suggest/channel_facts.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::string_view kIfLine = "#if ";
constexpr std::string_view kElseLine = "#else";
constexpr std::string_view kEndLine = "#end";
constexpr std::string_view kChannelPlace = "{channel}";
constexpr std::string_view kThrusterPlace = "{thrusters}";
constexpr std::string_view kOutputRole = "outputs";

std::vector<std::string> ConditionsOf(std::string_view line) {
  std::istringstream words{std::string(line.substr(kIfLine.size()))};
  return {std::istream_iterator<std::string>(words), {}};
}

// "gps" and "fix" of "gps.fix".
std::pair<std::string_view, std::string_view> SplitAtDot(std::string_view text) {
  const std::size_t dot = std::min(text.find('.'), text.size());
  return {text.substr(0, dot), text.substr(std::min(dot + 1, text.size()))};
}

// For a place between double quotes.
std::string EscapedInYaml(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += ShownOnOneLine({&c, 1});  // \x.. is YAML's own
  }
  return text;
}

}  // namespace

bool HasChoices(const MapLines& lines) {
  return std::ranges::any_of(lines, [](const MapLine& line) {
    return line.text.starts_with(kIfLine) || line.text == kThrusterPlace;
  });
}

std::string UnknownCondition(const std::vector<std::string>& conditions,
                             const WantedChannels& wanted) {
  for (const std::string& condition : conditions) {
    const auto channel = SplitAtDot(condition).first;
    const auto name = channel.substr(channel.starts_with('!') ? 1 : 0);
    if (name != "vehicle" && !wanted.contains(name)) return condition;
  }
  return {};
}

void CheckLines(const std::string& file, const MapLines& lines, const WantedChannels& wanted) {
  int depth = 0;
  for (const MapLine& line : lines) {
    const bool is_if = line.text.starts_with(kIfLine);
    if (is_if) {
      ++depth;
      const std::string unknown = UnknownCondition(ConditionsOf(line.text), wanted);
      if (!unknown.empty()) {
        throw InputError(
            fmt::format("{}:{}: 'find' holds no {}.", file, line.number, Quoted(unknown)));
      }
    }
    const bool needs_if = line.text == kElseLine || line.text == kEndLine;
    if (needs_if && depth == 0) {
      throw InputError(fmt::format("{}:{}: {} without #if.", file, line.number, line.text));
    }
    if (line.text == kEndLine) --depth;
  }
  if (depth > 0) throw InputError(fmt::format("{}: an #if has no #end.", file));
}

FilledMap::FilledMap(FoundChannels found, const std::optional<Vehicle>& vehicle)
    : found_(std::move(found)), vehicle_(vehicle) {}

bool FilledMap::IsDriven() {
  if (!vehicle_) return false;
  const FoundChannel& outputs = found_.Of(kOutputRole);
  const bool has_actuators = !vehicle_->thrusters.empty() || !vehicle_->fins.empty();
  if (outputs.channel != nullptr && !has_actuators) return false;
  return outputs.num_outputs >= std::ssize(vehicle_->thrusters) ||
         (outputs.channel != nullptr && outputs.wanted->is_idle_too);
}

bool FilledMap::MeetsOne(std::string_view condition) {
  if (condition.starts_with('!')) return !MeetsOne(condition.substr(1));
  if (condition == "vehicle") return IsDriven();
  const auto [name, detail] = SplitAtDot(condition);
  const FoundChannel& found = found_.Of(name);
  if (found.channel == nullptr || detail.empty()) return found.channel != nullptr;
  return detail == "alone" ? found.num_others == 0 : HasField(*found.channel, detail);
}

bool FilledMap::Meets(const std::vector<std::string>& conditions) {
  return std::ranges::all_of(conditions, [&](const auto& one) { return MeetsOne(one); });
}

std::string FilledMap::ThrusterText() {
  const FoundChannel& outputs = found_.Of(kOutputRole);
  if (outputs.channel == nullptr) return {};
  const int number =
      IsDriven() ? static_cast<int>(vehicle_->thrusters.size()) : outputs.num_outputs;
  const std::string& field = outputs.wanted->outputs;
  if (field.empty()) {
    return ThrusterLines(outputs.motors, number, outputs.channel->name) +
           SteeringLines(outputs.motors.boat,
                         vehicle_ ? std::span<const Fin>(vehicle_->fins) : std::span<const Fin>(),
                         outputs.channel->name);
  }
  std::string text;
  for (int i = 0; i < number; ++i) {
    text += fmt::format("  thruster_{}: \"{}\"\n", i + 1, WithNumber(field, i));
  }
  return text;
}

std::optional<std::string> FilledMap::ValueOf(std::string_view place) {
  const auto [name, detail] = SplitAtDot(place);
  const FoundChannel& found = found_.Of(name);
  if (found.channel == nullptr) return std::nullopt;
  if (detail.empty()) return EscapedInYaml(found.channel->name);
  if (detail == "type") return ShownOnOneLine(found.channel->type);
  if (detail == "text") return found.wanted->text;
  if (detail != "others") return std::nullopt;
  return found.num_others == 0 ? ""
                               : fmt::format("; {} may be it", Plural(found.num_others, "other"));
}

std::string FilledMap::Filled(std::string_view line) {
  std::string text;
  while (!line.empty()) {
    const std::size_t open = std::min(line.find('{'), line.size());
    const std::size_t close = line.find_first_of("{}", open + 1);
    text += line.substr(0, open);
    line.remove_prefix(open);
    if (line.empty()) break;
    const bool is_pair = close != std::string_view::npos && line[close - open] == '}';
    const auto value = is_pair ? ValueOf(line.substr(1, close - open - 1)) : std::nullopt;
    text += value ? *value : "{";
    line.remove_prefix(value ? close - open + 1 : 1);
  }
  return text;
}

std::string FilledMap::TextOf(const MapLines& lines) {
  std::vector<bool> is_shown;  // of each #if that is open
  const auto is_all_shown = [&] { return std::ranges::find(is_shown, false) == is_shown.end(); };
  std::string text;
  for (const MapLine& line : lines) {
    std::string shown = line.text;
    if (shown.starts_with(kIfLine)) {
      is_shown.push_back(is_all_shown() && Meets(ConditionsOf(shown)));
    } else if (shown == kElseLine) {
      is_shown.back() = !is_shown.back();
    } else if (shown == kEndLine) {
      is_shown.pop_back();
    } else if (is_all_shown() && shown == kThrusterPlace) {
      text += ThrusterText();
    } else if (is_all_shown()) {
      const std::size_t place = shown.find(kChannelPlace);
      if (place != std::string::npos && !channel_) continue;
      if (channel_ && place != std::string::npos) {
        shown.replace(place, kChannelPlace.size(), EscapedInYaml(*channel_));
        text += shown + "\n";
      } else {
        text += Filled(shown) + "\n";
      }
    }
  }
  return text;
}

void FilledMap::TellWhyNotDriven(SuggestedMap* map) {
  if (!vehicle_ || IsDriven()) return;
  map->why_not_ready = fmt::format("the log drives {} outputs, and the vehicle '{}' has {}",
                                   found_.Of(kOutputRole).num_outputs,
                                   vehicle_->name,
                                   Plural(vehicle_->thrusters.size(), "thruster"));
  map->text += fmt::format("# {}: this map cannot be imported with it.\n", map->why_not_ready);
}

void FilledMap::TellUnknown(SuggestedMap* map) {
  // What a rudder turns is not seen from its command.
  if (found_.Of(kOutputRole).motors.boat.steering) {
    map->text = "dof: [surge, sway, yaw]\n" + map->text;
  }
  TellUnknownOutputs(found_.Of(kOutputRole).motors, map);
}

}  // namespace fathom
