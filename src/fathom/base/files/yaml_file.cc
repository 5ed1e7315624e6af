// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/yaml_file.h"

#include "fathom/base/files/yaml_tree.h"
#include "fathom/base/input_error.h"
#include "fathom/base/nearest.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

using Kind = YamlNode::Kind;

// "thrusters[1].coefficient.forward"; empty for the whole file.
std::string PathOf(const YamlNode& node) {
  if (node.parent == nullptr) return "";
  const std::string above = PathOf(*node.parent);
  if (node.parent->kind == Kind::kList) return above + "[" + node.key + "]";
  return above.empty() ? node.key : above + "." + node.key;
}

std::string Describe(const YamlNode& node) {
  switch (node.kind) {
    case Kind::kNull:
      return "empty";
    case Kind::kMap:
      return "a map";
    case Kind::kList:
      return fmt::format("a list of {}", node.items.size());
    case Kind::kText:
      return (node.is_quoted ? "the quoted text " : "") + Quoted(node.text);
  }
  return "";
}

[[noreturn]] void FailAt(const YamlDocument& document,
                         const YamlNode& node,
                         std::string_view problem) {
  const std::string path = PathOf(node);
  throw InputError(
      path.empty() ? fmt::format("{}:{}: {}", document.name, node.line, problem)
                   : fmt::format("{}:{}: key '{}' {}", document.name, node.line, path, problem));
}

[[noreturn]] void FailKind(const YamlDocument& document,
                           const YamlNode& node,
                           std::string_view expected) {
  FailAt(document, node, fmt::format("is {}, expected {}.", Describe(node), expected));
}

double NumberOf(const YamlDocument& document, const YamlNode& node) {
  if (node.kind == Kind::kText && !node.is_quoted) {
    if (const auto number = ParseFiniteNumber(node.text)) return *number;
  }
  FailKind(document, node, "a finite number");
}

std::string StringOf(const YamlDocument& document, const YamlNode& node) {
  if (node.kind != Kind::kText) FailKind(document, node, "a text");
  return node.text;
}

std::vector<double> NumbersOf(const YamlDocument& document, const YamlNode& node, int size) {
  if (node.kind != Kind::kList || (size >= 0 && static_cast<int>(node.items.size()) != size)) {
    FailKind(
        document, node, size < 0 ? "a list of numbers" : fmt::format("a list of {} numbers", size));
  }
  std::vector<double> numbers;
  for (const auto& item : node.items) numbers.push_back(NumberOf(document, item));
  return numbers;
}

void RefuseUnknownKeys(const YamlDocument& document, const YamlNode& node) {
  for (const auto& item : node.items) {
    if (node.kind == Kind::kMap && !node.IsKnown(item.key)) {
      FailAt(document,
             item,
             node.known_keys.empty()
                 ? "is not known here, expected no key."
                 : fmt::format("is not known here, expected one of: {}. Correct or remove it.",
                               fmt::join(node.known_keys, ", ")));
    }
    if (std::find(node.ignored_keys.begin(), node.ignored_keys.end(), item.key) ==
        node.ignored_keys.end()) {
      RefuseUnknownKeys(document, item);
    }
  }
}

}  // namespace

YamlMap::YamlMap(std::shared_ptr<const YamlDocument> document, const YamlNode* node)
    : document_(std::move(document)), node_(node) {}

const YamlNode* YamlMap::Find(std::string_view key) const {
  if (!node_->IsKnown(key)) node_->known_keys.emplace_back(key);
  const auto found = std::find_if(node_->items.begin(),
                                  node_->items.end(),
                                  [&](const YamlNode& item) { return item.key == key; });
  return found == node_->items.end() ? nullptr : &*found;
}

const YamlNode& YamlMap::Require(std::string_view key, std::string_view expected) const {
  if (const YamlNode* node = Find(key)) return *node;
  const std::string above = PathOf(*node_);
  const std::string near = Nearest(key, Keys());
  throw InputError(fmt::format("{}:{}: key '{}{}{}' is missing, expected {}{}.",
                               document_->name,
                               node_->line,
                               above,
                               above.empty() ? "" : ".",
                               key,
                               expected,
                               near.empty() ? "" : ": found " + Quoted(near)));
}

bool YamlMap::Has(std::string_view key) const { return Find(key) != nullptr; }

void YamlMap::Ignore(std::string_view key) const {
  Find(key);
  node_->ignored_keys.emplace_back(key);
}

std::vector<std::string> YamlMap::Keys() const {
  std::vector<std::string> keys;
  for (const YamlNode& item : node_->items) keys.push_back(item.key);
  return keys;
}

std::string YamlMap::String(std::string_view key) const {
  return StringOf(*document_, Require(key, "a text"));
}

std::string YamlMap::String(std::string_view key, const std::string& if_missing) const {
  return Has(key) ? String(key) : if_missing;
}

std::string YamlMap::Name(std::string_view key) const {
  std::string name = String(key);
  if (name.find_first_not_of(' ') == std::string::npos) {
    Fail(key, "is empty, expected a name.");
  }
  if (ShownOnOneLine(name) != name) {
    Fail(key, fmt::format("is {}, expected a name without control characters.", Quoted(name)));
  }
  return name;
}

double YamlMap::Number(std::string_view key) const {
  return NumberOf(*document_, Require(key, "a finite number"));
}

double YamlMap::Number(std::string_view key, double if_missing) const {
  return Has(key) ? Number(key) : if_missing;
}

std::int64_t YamlMap::Integer(std::string_view key) const {
  const YamlNode& node = Require(key, "a whole number");
  std::int64_t value = 0;
  const char* const end = node.text.data() + node.text.size();
  const auto result = std::from_chars(node.text.data(), end, value);
  if (node.kind != Kind::kText || node.is_quoted || result.ec != std::errc() || result.ptr != end) {
    FailKind(*document_, node, "a whole number");
  }
  return value;
}

std::int64_t YamlMap::Integer(std::string_view key, std::int64_t if_missing) const {
  return Has(key) ? Integer(key) : if_missing;
}

bool YamlMap::Boolean(std::string_view key) const {
  const YamlNode& node = Require(key, "true or false");
  if (node.kind != Kind::kText || (node.text != "true" && node.text != "false")) {
    FailKind(*document_, node, "true or false");
  }
  return node.text == "true";
}

bool YamlMap::Boolean(std::string_view key, bool if_missing) const {
  return Has(key) ? Boolean(key) : if_missing;
}

std::vector<double> YamlMap::Numbers(std::string_view key, int size) const {
  return NumbersOf(*document_, Require(key, "a list of numbers"), size);
}

std::vector<std::vector<double>> YamlMap::NumberLists(std::string_view key, int size) const {
  const std::string expected = fmt::format("a list of {} numbers, or a list of such lists", size);
  const YamlNode& node = Require(key, expected);
  if (node.kind != Kind::kList) FailKind(*document_, node, expected);
  if (!node.items.empty() && node.items.front().kind != Kind::kList) {
    return {NumbersOf(*document_, node, size)};
  }
  std::vector<std::vector<double>> lists;
  for (const YamlNode& item : node.items) lists.push_back(NumbersOf(*document_, item, size));
  return lists;
}

std::vector<std::string> YamlMap::Strings(std::string_view key) const {
  const YamlNode& node = Require(key, "a text or a list of texts");
  if (node.kind == Kind::kText) return {node.text};
  if (node.kind != Kind::kList) FailKind(*document_, node, "a text or a list of texts");
  std::vector<std::string> strings;
  for (const YamlNode& item : node.items) strings.push_back(StringOf(*document_, item));
  return strings;
}

bool YamlMap::HoldsMaps(std::string_view key) const {
  const YamlNode* const node = Find(key);
  return node != nullptr && node->kind == Kind::kList && !node->items.empty() &&
         node->items.front().kind == Kind::kMap;
}

bool YamlMap::HoldsMap(std::string_view key) const {
  const YamlNode* const node = Find(key);
  return node != nullptr && node->kind == Kind::kMap;
}

YamlMap YamlMap::Map(std::string_view key) const {
  const YamlNode& node = Require(key, "a map");
  if (node.kind != Kind::kMap) FailKind(*document_, node, "a map");
  return YamlMap(document_, &node);
}

std::optional<YamlMap> YamlMap::OptionalMap(std::string_view key) const {
  if (!Has(key)) return std::nullopt;
  return Map(key);
}

std::vector<YamlMap> YamlMap::Maps(std::string_view key) const {
  const YamlNode& node = Require(key, "a list of maps");
  if (node.kind != Kind::kList) FailKind(*document_, node, "a list of maps");
  std::vector<YamlMap> maps;
  for (const YamlNode& item : node.items) {
    if (item.kind != Kind::kMap) FailKind(*document_, item, "a map");
    maps.emplace_back(document_, &item);
  }
  return maps;
}

std::vector<YamlMap> YamlMap::OptionalMaps(std::string_view key) const {
  return Has(key) ? Maps(key) : std::vector<YamlMap>();
}

void YamlMap::Finish() const { RefuseUnknownKeys(*document_, *node_); }

void YamlMap::Fail(std::string_view key, std::string_view problem) const {
  FailAt(*document_, Require(key, "a value"), problem);
}

void YamlMap::Fail(std::string_view problem) const { FailAt(*document_, *node_, problem); }

YamlMap ParseYaml(const std::string& name, const std::string& text) {
  auto document = ParseYamlTree(name, text);
  const YamlNode* const root = &document->root;
  if (root->kind != Kind::kMap) {
    // A text may be any file of anybody: it does not stand in the message.
    const std::string found = root->kind == Kind::kText ? "a text" : Describe(*root);
    FailAt(*document, *root, fmt::format("is {}, expected keys and values ('key: value').", found));
  }
  return YamlMap(std::move(document), root);
}

}  // namespace fathom
