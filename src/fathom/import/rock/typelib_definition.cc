// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/rock/typelib_definition.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pugixml.hpp>

namespace fathom {
namespace {

constexpr std::size_t kMostTypelibTypes = 1000;
constexpr int kDeepestTypelib = 32;
constexpr std::int64_t kLargestSize = 1 << 28;  // of a type, in bytes or elements

// A member without its name, and the bytes that it takes in the memory of the program.
struct Placed {
  MessageMember member;
  std::int64_t size = 0;
};

MessageMember NumberMember(NumberType type) {
  return {.name = "", .kind = MemberKind::kNumber, .number = type};
}

MessageMember Padding(std::int64_t size) {
  return {.name = "", .kind = MemberKind::kPadding, .message = 0, .length = size};
}

class TypelibParser {
 public:
  TypelibParser(std::string_view type, std::string_view text) : type_(type) {
    const pugi::xml_parse_result result =
        document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result) {
      Fail(fmt::format(
          "its description is no XML at byte {}: {}.", result.offset, result.description()));
    }
    for (const pugi::xml_node& node : document_.child("typelib").children()) {
      nodes_.emplace(node.attribute("name").value(), node);
    }
  }

  MessageDefinition Parse() {
    definition_.push_back({type_, {}});
    const Placed top = Place(type_, 0);
    if (top.member.kind == MemberKind::kMessage) {
      definition_[0] = definition_[top.member.message];
      auto& members = definition_[0].members;
      if (!members.empty() && members.back().kind == MemberKind::kPadding) members.pop_back();
    } else {
      definition_[0].members.push_back(Named("value", top.member));
    }
    return std::move(definition_);
  }

 private:
  [[noreturn]] void Fail(const std::string& problem) const {
    throw InputError(fmt::format("type {}: {}", Printable(type_), problem));
  }

  static MessageMember Named(std::string name, MessageMember member) {
    member.name = std::move(name);
    return member;
  }

  std::int64_t NumberIn(const pugi::xml_node& node, const char* attribute) const {
    const auto number = ParseFiniteNumber(node.attribute(attribute).value());
    if (!number || !(*number >= 0.0) || *number > static_cast<double>(kLargestSize)) {
      Fail(fmt::format("{} of {} is {}, expected a number of bytes or elements.",
                       attribute,
                       Quoted(node.attribute("name").value()),
                       Quoted(node.attribute(attribute).value())));
    }
    return static_cast<std::int64_t>(*number);
  }

  // What a member of this type is.
  Placed Place(const std::string& name, int depth) {
    if (depth > kDeepestTypelib || definition_.size() >= kMostTypelibTypes) {
      Fail("its description holds too many types, or one that holds itself.");
    }
    // "/double[3]", which need not be described itself.
    if (const std::size_t open = name.rfind('['); name.ends_with(']') && open > 0) {
      const auto length = ParseFiniteNumber(name.substr(open + 1, name.size() - open - 2));
      if (!length || !(*length >= 0.0) || *length > static_cast<double>(kLargestSize)) {
        Fail(fmt::format("{} is no type.", Quoted(name)));
      }
      return Repeated(Place(name.substr(0, open), depth + 1), static_cast<std::int64_t>(*length));
    }
    const auto found = nodes_.find(name);
    if (found == nodes_.end()) {
      Fail(fmt::format("its description holds no type {}.", Quoted(name)));
    }
    const pugi::xml_node& node = found->second;
    const std::string_view kind = node.name();
    if (kind == "alias") return Place(node.attribute("source").value(), depth + 1);
    if (kind == "numeric") {
      const std::int64_t size = NumberIn(node, "size");
      const std::string_view category = node.attribute("category").value();
      const char first = category == "sint" ? 'i' : category == "uint" ? 'u' : 'f';
      const bool is_known = first != 'f' || category == "float";
      const auto number = is_known ? NumberTypeOf(first, size) : std::nullopt;
      if (!number) Fail(fmt::format("{} is no number of a known kind.", Quoted(name)));
      return {NumberMember(*number), size};
    }
    if (kind == "enum") return {NumberMember(NumberType::kInt32), 4};
    if (kind == "array") {
      return Repeated(Place(node.attribute("of").value(), depth + 1), NumberIn(node, "dimension"));
    }
    if (kind == "container") return Container(node, depth);
    if (kind == "compound") return Compound(name, node, depth);
    Fail(fmt::format("holds {}, which is {} and cannot be read.", Quoted(name), Quoted(kind)));
  }

  // A type that holds this member alone, since arrays hold no arrays.
  MessageMember Wrapped(const MessageMember& member) {
    definition_.push_back({"", {Named("value", member)}});
    return {.name = "", .kind = MemberKind::kMessage, .message = definition_.size() - 1};
  }

  Placed Repeated(const Placed& element, std::int64_t count) {
    const std::int64_t size = std::min(element.size, kLargestSize) * count;
    if (size > kLargestSize) Fail("an array in it is too large.");
    MessageMember member = element.member;
    if (member.length == kSequence) member = Wrapped(member);
    member.length = member.length == kNoArray ? count : member.length * count;
    return {member, size};
  }

  Placed Container(const pugi::xml_node& node, int depth) {
    const std::string kind = node.attribute("kind").value();
    const std::int64_t size = NumberIn(node, "size");
    if (kind == "/std/string") return {{.name = "", .kind = MemberKind::kString}, size};
    MessageMember member = Place(node.attribute("of").value(), depth + 1).member;
    if (member.length != kNoArray) member = Wrapped(member);
    member.length = kSequence;
    return {member, size};
  }

  Placed Compound(const std::string& name, const pugi::xml_node& node, int depth) {
    const std::int64_t size = NumberIn(node, "size");
    if (name == "/base/Time" && size == 8) {
      return {{.name = "", .kind = MemberKind::kMicroseconds}, size};
    }
    if (const auto known = index_.find(name); known != index_.end()) {
      return {{.name = "", .kind = MemberKind::kMessage, .message = known->second}, size};
    }
    if (!open_.insert(name).second) Fail(fmt::format("type {} holds itself.", Quoted(name)));
    std::vector<std::pair<std::int64_t, pugi::xml_node>> fields;
    for (const pugi::xml_node& field : node.children("field")) {
      fields.emplace_back(NumberIn(field, "offset"), field);
    }
    std::stable_sort(fields.begin(), fields.end(), [](const auto& a, const auto& b) {
      return a.first < b.first;
    });
    MessageType type = {name, {}};
    std::int64_t end = 0;
    for (const auto& [offset, field] : fields) {
      if (offset < end) {
        Fail(fmt::format("{} of {} overlaps the member before it.",
                         Quoted(field.attribute("name").value()),
                         Quoted(name)));
      }
      if (offset > end) type.members.push_back(Padding(offset - end));
      const Placed placed = Place(field.attribute("type").value(), depth + 1);
      type.members.push_back(Named(field.attribute("name").value(), placed.member));
      end = offset + placed.size;
    }
    if (size < end) Fail(fmt::format("{} is smaller than its members.", Quoted(name)));
    if (size > end) type.members.push_back(Padding(size - end));
    open_.erase(name);
    definition_.push_back(std::move(type));
    index_[name] = definition_.size() - 1;
    return {{.name = "", .kind = MemberKind::kMessage, .message = definition_.size() - 1}, size};
  }

  std::string type_;
  pugi::xml_document document_;
  std::map<std::string, pugi::xml_node> nodes_;
  MessageDefinition definition_;
  std::map<std::string, std::size_t> index_;  // of compounds
  std::set<std::string> open_;                // those that are being read
};

}  // namespace

MessageDefinition ParseTypelibDefinition(std::string_view type, std::string_view text) {
  return TypelibParser(type, text).Parse();
}

}  // namespace fathom
