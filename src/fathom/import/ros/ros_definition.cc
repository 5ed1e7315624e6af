// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ros/ros_definition.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"
#include "fathom/base/trimmed.h"
#include "fathom/import/recording/data_files.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kMostTypes = 1000;
constexpr int kDeepest = 32;
constexpr std::int64_t kLongestFixedArray = 1 << 24;

// What a type is that is no message; nothing for the name of one.
std::optional<MessageMember> Primitive(std::string_view type, bool is_ros2) {
  MessageMember member;
  if (type == "string") {
    member.kind = MemberKind::kString;
  } else if (type == "wstring") {
    member.kind = MemberKind::kWideString;
  } else if (type == "time") {
    member.kind = MemberKind::kTime;
  } else if (type == "duration") {
    member.kind = MemberKind::kDuration;
  } else if (type == "byte" && !is_ros2) {
    member.number = NumberType::kInt8;  // in ROS 2 an octet
  } else if (type != "bool" && type != "byte" && type != "char") {
    const auto number = NumberTypeNamed(type);
    if (!number) return std::nullopt;
    member.number = *number;
  }
  return member;
}

std::string_view TrimmedLine(std::string_view text) { return Trimmed(text, " \t\r"); }

std::string_view PackageOf(std::string_view type) { return type.substr(0, type.find('/')); }

// The texts of the types by their names.
std::map<std::string, std::string_view> TextsOf(std::string_view type, std::string_view text) {
  std::map<std::string, std::string_view> texts;
  std::string name = WithoutMsg(type);
  std::size_t begin = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = TrimmedLine(text.substr(at, end - at));
    const std::size_t next = end + 1;
    if (line.size() >= 3 && line.find_first_not_of('=') == std::string_view::npos) {
      const std::size_t end_of_name =
          std::min(text.find('\n', std::min(next, text.size())), text.size());
      std::string_view header = TrimmedLine(
          text.substr(std::min(next, text.size()), end_of_name - std::min(next, text.size())));
      if (header.starts_with("MSG:")) {
        texts.emplace(name, text.substr(begin, at - begin));
        name = WithoutMsg(TrimmedLine(header.substr(4)));
        begin = std::min(end_of_name + 1, text.size());
        at = begin;
        continue;
      }
    }
    at = next;
  }
  texts.emplace(name, text.substr(begin));
  return texts;
}

class Parser {
 public:
  Parser(std::string_view type, std::string_view text)
      : type_(WithoutMsg(type)),
        is_ros2_(type.find("/msg/") != std::string_view::npos),
        texts_(TextsOf(type, text)) {}

  MessageDefinition Parse() {
    AddType(type_, 0);
    return std::move(definition_);
  }

 private:
  [[noreturn]] void Fail(const std::string& problem) const {
    throw InputError(fmt::format("message type {}: {}", Printable(type_), problem));
  }

  // The name in the definition of a type that a member of `package` names.
  std::string Resolve(std::string_view name, std::string_view package) const {
    const std::string short_name = WithoutMsg(name);
    if (texts_.contains(short_name)) return short_name;
    const std::string in_package = std::string(package) + "/" + short_name;
    if (texts_.contains(in_package)) return in_package;
    if (short_name == "Header" && texts_.contains("std_msgs/Header")) return "std_msgs/Header";
    Fail(fmt::format("its definition holds no type {}.", Quoted(name)));
  }

  std::size_t AddType(const std::string& name, int depth) {
    if (const auto known = index_.find(name); known != index_.end()) return known->second;
    if (depth > kDeepest || definition_.size() >= kMostTypes) {
      Fail("its definition holds too many types, or one that holds itself.");
    }
    if (std::find(open_.begin(), open_.end(), name) != open_.end()) {
      Fail(fmt::format("type {} holds itself.", Quoted(name)));
    }
    open_.push_back(name);
    const std::size_t index = definition_.size();
    definition_.push_back({name, {}});
    std::string_view text = texts_.at(name);
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      AddMember(text.substr(0, end), index, depth);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    open_.pop_back();
    index_[name] = index;
    return index;
  }

  void AddMember(std::string_view line, std::size_t index, int depth) {
    line = TrimmedLine(line.substr(0, line.find('#')));
    const std::size_t end_of_type = line.find_first_of(" \t");
    if (end_of_type == std::string_view::npos) return;
    std::string_view type = line.substr(0, end_of_type);
    std::string_view name = TrimmedLine(line.substr(end_of_type));
    const std::size_t end_of_name = std::min(name.find_first_of(" \t="), name.size());
    const std::string_view behind = TrimmedLine(name.substr(end_of_name));
    if (behind.starts_with('=')) return;  // a constant; "name value" is a default of ROS 2
    MessageMember member;
    member.name = name.substr(0, end_of_name);
    if (type.ends_with(']')) {
      const std::size_t open = type.find('[');
      if (open == std::string_view::npos) Fail(fmt::format("{} is no type.", Quoted(type)));
      member.length = LengthOf(type.substr(open + 1, type.size() - open - 2));
      type = type.substr(0, open);
    }
    type = type.substr(0, type.find("<="));  // a string of bounded length
    if (const auto primitive = Primitive(type, is_ros2_)) {
      member.kind = primitive->kind;
      member.number = primitive->number;
    } else {
      member.kind = MemberKind::kMessage;
      const std::string package(PackageOf(definition_[index].name));
      member.message = AddType(Resolve(type, package), depth + 1);
      const std::string& message = definition_[member.message].name;
      // In ROS 2 these are messages of two numbers.
      if (message == "builtin_interfaces/Time") member.kind = MemberKind::kTime;
      if (message == "builtin_interfaces/Duration") member.kind = MemberKind::kDuration;
    }
    definition_[index].members.push_back(std::move(member));
  }

  // "", "<=10" and "10".
  std::int64_t LengthOf(std::string_view text) const {
    if (text.empty() || text.starts_with("<=")) return kSequence;
    const auto length = ParseFiniteNumber(text);
    if (!length || *length < 0 || *length > kLongestFixedArray) {
      Fail(fmt::format("{} is no length of an array.", Quoted(text)));
    }
    return static_cast<std::int64_t>(*length);
  }

  std::string type_;
  bool is_ros2_;  // whose types are called package/msg/Type
  std::map<std::string, std::string_view> texts_;
  MessageDefinition definition_;
  std::map<std::string, std::size_t> index_;
  std::vector<std::string> open_;
};

}  // namespace

MessageDefinition ParseRosDefinition(std::string_view type, std::string_view text) {
  return Parser(type, text).Parse();
}

std::string KnownDefinition(std::string_view type) {
  const std::string head = fmt::format("MSG: {}\n", WithoutMsg(type));
  const std::size_t begin = data_files::ros_types.find(head);
  if (begin == std::string_view::npos) return {};
  const std::string_view text = data_files::ros_types.substr(begin + head.size());
  return std::string(text.substr(0, text.find("===\n"))) + std::string(data_files::ros_types);
}

std::string WithoutMsg(std::string_view type) {
  std::string name(type);
  const std::size_t middle = name.find("/msg/");
  if (middle != std::string::npos) name.erase(middle, 4);
  return name;
}

}  // namespace fathom
