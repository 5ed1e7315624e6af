// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/yaml_tree.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

namespace fathom {
namespace {

using Node = YamlNode;

constexpr std::size_t kDeepest = 32;

// Length of the UTF-8 character that starts at `at`, or 0 if none does.
std::size_t Utf8Length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t length = first < 0x80           ? 1
                             : (first >> 5) == 0x06 ? 2
                             : (first >> 4) == 0x0e ? 3
                             : (first >> 3) == 0x1e ? 4
                                                    : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = at + 1; i < at + length; ++i) {
    if ((byte(i) >> 6) != 0x02) return 0;
  }
  // Longer than needed, a half of a pair, or beyond the last code point.
  const unsigned char second = length > 1 ? byte(at + 1) : 0;
  if (first == 0xc0 || first == 0xc1 || (first == 0xe0 && second < 0xa0) ||
      (first == 0xed && second > 0x9f) || (first == 0xf0 && second < 0x90) ||
      (first == 0xf4 && second > 0x8f) || first > 0xf4) {
    return 0;
  }
  return length;
}

bool IsUtf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = Utf8Length(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

// Builds the tree from yaml-cpp's events. Its own node type would hide repeated keys and follow
// aliases into cycles.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(const std::string& name) : name_(name) {}

  Node root;
  bool has_root = false;

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (has_root) Fail(mark, "a second document starts here, expected one per file.");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    RefuseExtras(mark, "", anchor);
    Add(mark, Node());
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    Fail(mark, "an alias ('*') stands here, expected the value itself.");
  }
  void OnScalar(const YAML::Mark& mark,
                const std::string& tag,
                YAML::anchor_t anchor,
                const std::string& value) override {
    RefuseExtras(mark, tag, anchor);
    // yaml-cpp 0.7 takes the escapes \N and \_ for single bytes, which no text can hold.
    if (!IsUtf8(value)) {
      Fail(mark, "the escape '\\N' or '\\_' stands in a text, expected the character itself.");
    }
    if (!open_.empty() && open_.back().WaitsForKey()) {
      OpenKey(mark, value);
      return;
    }
    Node node;
    node.kind = Node::Kind::kText;
    node.text = value;
    node.is_quoted = tag == "!";
    Add(mark, std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark,
                       const std::string& tag,
                       YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    RefuseExtras(mark, tag, anchor);
    Open(mark, Node::Kind::kList);
  }
  void OnSequenceEnd() override { Close(); }

  void OnMapStart(const YAML::Mark& mark,
                  const std::string& tag,
                  YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    RefuseExtras(mark, tag, anchor);
    Open(mark, Node::Kind::kMap);
  }
  void OnMapEnd() override { Close(); }

 private:
  [[noreturn]] void Fail(const YAML::Mark& mark, std::string_view problem) const {
    throw InputError(fmt::format("{}:{}: {}", name_, mark.line + 1, problem));
  }

  void RefuseExtras(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) const {
    if (anchor != 0) Fail(mark, "an anchor ('&') stands here, expected plain values.");
    if (!tag.empty() && tag != "?" && tag != "!") {
      Fail(mark, fmt::format("a tag ({}) stands here, expected plain values.", Quoted(tag)));
    }
  }

  void OpenKey(const YAML::Mark& mark, const std::string& key) {
    Collection& map = open_.back();
    const auto [same, is_new] = map.line_of_key.emplace(key, mark.line + 1);
    if (!is_new) {
      Fail(mark,
           fmt::format("key {} was given on line {} already. Remove one of the two.",
                       Quoted(key),
                       same->second));
    }
    map.pending_key = key;
  }

  // Takes the name of a value that starts here from the collection it is in.
  void Name(const YAML::Mark& mark, Node* node) {
    node->line = mark.line + 1;
    if (open_.empty()) return;
    Collection& above = open_.back();
    if (above.node.kind == Node::Kind::kList) {
      node->key = std::to_string(above.node.items.size());
      return;
    }
    if (above.WaitsForKey()) Fail(mark, "a key is not a text, expected 'key: value'.");
    node->key = std::move(*above.pending_key);
    node->line = above.line_of_key.at(node->key);
    above.pending_key.reset();
  }

  void Add(const YAML::Mark& mark, Node node) {
    Name(mark, &node);
    Finish(std::move(node));
  }

  void Open(const YAML::Mark& mark, Node::Kind kind) {
    if (open_.size() == kDeepest) {
      Fail(mark, fmt::format("values nest deeper than {} levels.", kDeepest));
    }
    Collection collection;
    collection.node.kind = kind;
    Name(mark, &collection.node);
    open_.push_back(std::move(collection));
  }

  void Close() {
    Node node = std::move(open_.back().node);
    open_.pop_back();
    Finish(std::move(node));
  }

  void Finish(Node node) {
    if (open_.empty()) {
      root = std::move(node);
      has_root = true;
    } else {
      open_.back().node.items.push_back(std::move(node));
    }
  }

  // A list or map that is not closed yet.
  struct Collection {
    Node node;
    std::map<std::string, int> line_of_key;
    std::optional<std::string> pending_key;  // whose value comes next

    bool WaitsForKey() const { return node.kind == Node::Kind::kMap && !pending_key; }
  };
  const std::string& name_;
  std::vector<Collection> open_;  // outermost first
};

void RefuseBadCharacters(const std::string& name, std::string_view text) {
  int line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const std::size_t length = Utf8Length(text, at);
    if (length == 0) {
      throw InputError(fmt::format(
          "{}:{}: byte 0x{:02x} is not UTF-8. Save the file as UTF-8.", name, line, byte));
    }
    if (byte < 0x20 && byte != '\n' && byte != '\t' && byte != '\r') {
      throw InputError(fmt::format(
          "{}:{}: control character 0x{:02x}, expected text. The file is damaged; restore it.",
          name,
          line,
          byte));
    }
    if (byte == '\n') ++line;
    at += length;
  }
}

void LinkParents(Node* node) {
  for (Node& item : node->items) {
    item.parent = node;
    LinkParents(&item);
  }
}

}  // namespace

bool YamlNode::IsKnown(std::string_view name) const {
  return std::find(known_keys.begin(), known_keys.end(), name) != known_keys.end();
}

std::shared_ptr<const YamlDocument> ParseYamlTree(const std::string& name,
                                                  const std::string& text) {
  RefuseBadCharacters(name, text);
  TreeBuilder builder(name);
  try {
    // Without a last comment yaml-cpp takes a quote that is open at the end of the file for closed.
    std::istringstream stream(text + (text.ends_with('\n') ? "#" : "\n#"));
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    // msg, not what(): the latter counts lines in its own way. A mark is missing (-1) at the file's
    // end.
    throw InputError(fmt::format(
        "{}:{}: not valid YAML: {}.", name, std::max(error.mark.line, 0) + 1, error.msg));
  }
  if (!builder.has_root || builder.root.kind == Node::Kind::kNull) {
    throw InputError(fmt::format("{}: is empty, expected keys and values ('key: value').", name));
  }
  auto document = std::make_shared<YamlDocument>();
  document->name = name;
  document->root = std::move(builder.root);
  LinkParents(&document->root);
  return document;
}

}  // namespace fathom
