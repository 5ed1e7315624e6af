// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// What a YAML file holds, with the line of each value; what is behind YamlMap.
struct YamlNode {
  enum class Kind { kNull, kText, kList, kMap };

  Kind kind = Kind::kNull;
  int line = 1;            // of its key, or of its first character in a list; counted from 1
  std::string key;         // its name in the map above, or its index in the list above
  std::string text;        // of a kText
  bool is_quoted = false;  // a kText that was written in quotes or as a block
  std::vector<YamlNode> items;
  const YamlNode* parent = nullptr;

  // What the reader of a map has asked for.
  mutable std::vector<std::string> known_keys;
  mutable std::vector<std::string> ignored_keys;

  bool IsKnown(std::string_view key) const;
};

struct YamlDocument {
  std::string name;
  YamlNode root;
};

// Throws InputError for everything that ParseYaml refuses but a top level that is no map.
std::shared_ptr<const YamlDocument> ParseYamlTree(const std::string& name, const std::string& text);

}  // namespace fathom
