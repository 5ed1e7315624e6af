// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

struct YamlDocument;
struct YamlNode;

// One map of a YAML file, read key by key. Whatever does not fit throws InputError that names file,
// line and key ("thrusters[1].coefficient.forward"), what was found and what was expected.
//
//   const YamlMap file = ParseYaml("vehicle.yaml", ReadFile("vehicle.yaml"));
//   const std::string name = file.String("name");                 // must be there
//   const double mass = file.Number("mass");
//   const double volume = file.Number("volume", mass / 1000.0);   // may be missing
//   for (const YamlMap& thruster : file.OptionalMaps("thrusters")) { ... }
//   file.Finish();                                                // nothing else is in the file
//
// A key that was asked for once, found or not, is known. Finish() refuses every other key, here and
// in all maps below: a key that nobody reads is a mistake. Anchors, aliases, tags, repeated keys,
// several documents and numbers that are not finite are refused.
//
// Cheap to copy; copies share the record of what was asked for. Not for several threads at once.
class YamlMap {
 public:
  // True if the key is there. Makes it known.
  bool Has(std::string_view key) const;

  // Makes a key known that is allowed but not read.
  void Ignore(std::string_view key) const;

  // The keys there are, in the order of the file. Makes none known.
  std::vector<std::string> Keys() const;

  // Without a default the key must be there. Strings may be empty only if quoted.
  std::string String(std::string_view key) const;
  std::string String(std::string_view key, const std::string& if_missing) const;

  // A string that is not empty and holds no control characters, which a terminal would obey.
  std::string Name(std::string_view key) const;

  double Number(std::string_view key) const;
  double Number(std::string_view key, double if_missing) const;
  std::int64_t Integer(std::string_view key) const;
  std::int64_t Integer(std::string_view key, std::int64_t if_missing) const;
  bool Boolean(std::string_view key) const;  // true or false
  bool Boolean(std::string_view key, bool if_missing) const;

  // A list of numbers; of exactly `size` of them unless that is negative.
  std::vector<double> Numbers(std::string_view key, int size = -1) const;

  // A list of lists of `size` numbers each, or a single such list: [a, b] is read as [[a, b]].
  std::vector<std::vector<double>> NumberLists(std::string_view key, int size) const;

  // A list of strings, or a single string.
  std::vector<std::string> Strings(std::string_view key) const;

  // True if the key is there and its value a list that begins with a map. Makes it known.
  bool HoldsMaps(std::string_view key) const;

  // True if the key is there and its value a map. Makes it known.
  bool HoldsMap(std::string_view key) const;

  // A map below this one, and a list of maps.
  YamlMap Map(std::string_view key) const;
  std::optional<YamlMap> OptionalMap(std::string_view key) const;
  std::vector<YamlMap> Maps(std::string_view key) const;
  std::vector<YamlMap> OptionalMaps(std::string_view key) const;  // none if the key is missing

  // Throws InputError, listing the known keys, if this map or one below holds a key that nobody
  // asked for. Call it on the whole file, last.
  void Finish() const;

  // Throws InputError: "file:line: key 'x' <problem>", for rules that only the caller knows. The
  // problem reads on from the key: "is '-3', expected a mass above 0 kg."
  [[noreturn]] void Fail(std::string_view key, std::string_view problem) const;

  // The same about the map as a whole: "file:line: <problem>".
  [[noreturn]] void Fail(std::string_view problem) const;

  // Public only for its implementation.
  YamlMap(std::shared_ptr<const YamlDocument> document, const YamlNode* node);

 private:
  const YamlNode* Find(std::string_view key) const;  // null if missing
  const YamlNode& Require(std::string_view key, std::string_view expected) const;

  std::shared_ptr<const YamlDocument> document_;
  const YamlNode* node_;  // owned by the document
};

// From the text of a file whose top level is a map; `name` stands for the file in messages. Throws
// InputError if it is empty, is not UTF-8, breaks YAML's syntax, nests deeper than 32 levels or is
// not a map.
YamlMap ParseYaml(const std::string& name, const std::string& text);

}  // namespace fathom
