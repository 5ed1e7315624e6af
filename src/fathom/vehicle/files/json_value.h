// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A value of a JSON file that knows its path, as "structure.effects[0].effect". Whatever does not
// fit throws InputError: "file: 'path' is <found>, expected <expected>."
class JsonValue {
 public:
  // The whole file; `name` stands for it in messages. Throws InputError for what is no JSON, nests
  // more than 16 levels deep, or holds a key twice: which of the two was meant, nobody can tell.
  static JsonValue Parse(const std::string& name, std::string_view text);

  bool Has(const std::string& key) const;

  // The value of a key that must be there, and of one that may be missing.
  JsonValue Member(const std::string& key) const;
  std::optional<JsonValue> MemberIfThere(const std::string& key) const;

  std::vector<std::string> Keys() const;  // in the order of the file
  std::vector<JsonValue> List() const;
  std::vector<std::string> Texts() const;
  std::string Text() const;
  bool Boolean() const;
  double Number() const;         // finite
  double NumberIfKnown() const;  // NaN for null

  // Of a key: NaN where it is null or missing.
  double NumberIfThere(const std::string& key) const;

  // Throws InputError if this is no object, or holds a key beside these.
  void RequireKeysOf(const std::vector<std::string>& known) const;

  // Throws InputError: "file: 'path' <problem>."
  [[noreturn]] void Fail(const std::string& problem) const;

 private:
  struct Place;  // the value, its path and the file that holds both

  explicit JsonValue(std::shared_ptr<const Place> place);

  std::shared_ptr<const Place> place_;
};

}  // namespace fathom
