// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/json_value.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

using Json = JsonValue::Json;
using Event = Json::parse_event_t;

constexpr int kDeepestNesting = 16;

std::string Below(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

[[noreturn]] void Refuse(const std::string& file,
                         const std::string& path,
                         const std::string& problem) {
  throw InputError(path.empty() ? fmt::format("{}: {}.", file, problem)
                                : fmt::format("{}: {} {}.", file, Quoted(path), problem));
}

// Looks at a file while it is parsed: the parser itself keeps the last of two values of a key.
class WhileParsing {
 public:
  explicit WhileParsing(const std::string& file) : file_(file) {}

  void See(int depth, Event event, const Json& parsed) {
    if (depth > kDeepestNesting) {
      Refuse(file_,
             "",
             fmt::format("is nested more than {} levels deep: not a model file", kDeepestNesting));
    }
    switch (event) {
      case Event::object_start:
      case Event::array_start:
        open_.push_back({.path = NextPath(), .is_list = event == Event::array_start});
        break;
      case Event::key: {
        Level& level = open_.back();
        level.key = parsed.get<std::string>();
        if (!level.keys.insert(level.key).second) {
          Refuse(file_, Below(level.path, level.key), "is given twice, expected once");
        }
        break;
      }
      case Event::object_end:
      case Event::array_end:
        open_.pop_back();
        [[fallthrough]];
      case Event::value:
        if (!open_.empty()) ++open_.back().size;
    }
  }

 private:
  struct Level {
    std::string path;
    bool is_list = false;
    std::size_t size = 0;  // what is in it so far
    std::string key = {};  // the last one
    std::set<std::string> keys = {};
  };

  // Of the value that begins now.
  std::string NextPath() const {
    if (open_.empty()) return "";
    const Level& level = open_.back();
    return level.is_list ? fmt::format("{}[{}]", level.path, level.size)
                         : Below(level.path, level.key);
  }

  const std::string& file_;
  std::vector<Level> open_;
};

}  // namespace

JsonValue::JsonValue(std::shared_ptr<const File> file, const Json* value, std::string path)
    : file_(std::move(file)), value_(value), path_(std::move(path)) {}

JsonValue JsonValue::Parse(const std::string& file, std::string_view text) {
  WhileParsing watch(file);
  const auto see = [&](int depth, Event event, const Json& parsed) {
    watch.See(depth, event, parsed);
    return true;
  };
  try {
    auto parsed = std::make_shared<const File>(file, Json::parse(text, see));
    const Json* root = &parsed->root;
    return {std::move(parsed), root, ""};
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: is not JSON: {}.", file, error.what()));
  }
}

void JsonValue::Fail(const std::string& problem) const { Refuse(file_->name, path_, problem); }

std::string JsonValue::PathOf(const std::string& key) const { return Below(path_, key); }

std::string JsonValue::Shortened() const {
  const std::string text = value_->dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 40) + "...";
}

bool JsonValue::Has(const std::string& key) const {
  return value_->is_object() && value_->contains(key);
}

JsonValue JsonValue::Member(const std::string& key) const {
  if (!Has(key)) Refuse(file_->name, PathOf(key), "is missing");
  return {file_, &value_->at(key), PathOf(key)};
}

std::optional<JsonValue> JsonValue::MemberIfThere(const std::string& key) const {
  if (!Has(key)) return std::nullopt;
  return Member(key);
}

std::vector<std::string> JsonValue::Keys() const {
  std::vector<std::string> keys;
  if (!value_->is_object()) Fail(fmt::format("is {}, expected keys and values", Shortened()));
  for (const auto& [key, value] : value_->items()) keys.push_back(key);
  return keys;
}

std::vector<JsonValue> JsonValue::List() const {
  if (!value_->is_array()) Fail(fmt::format("is {}, expected a list", Shortened()));
  std::vector<JsonValue> list;
  for (const Json& value : *value_) {
    list.push_back({file_, &value, fmt::format("{}[{}]", path_, list.size())});
  }
  return list;
}

std::vector<std::string> JsonValue::Texts() const {
  std::vector<std::string> texts;
  for (const JsonValue& value : List()) texts.push_back(value.Text());
  return texts;
}

std::string JsonValue::Text() const {
  if (!value_->is_string()) Fail(fmt::format("is {}, expected a text", Shortened()));
  return value_->get<std::string>();
}

double JsonValue::Number() const {
  if (!value_->is_number() || !std::isfinite(value_->get<double>())) {
    Fail(fmt::format("is {}, expected a finite number", Shortened()));
  }
  return value_->get<double>();
}

double JsonValue::NumberIfKnown() const {
  return value_->is_null() ? std::numeric_limits<double>::quiet_NaN() : Number();
}

void JsonValue::RequireKeysOf(const std::vector<std::string>& known) const {
  for (const std::string& key : Keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    Refuse(file_->name,
           PathOf(key),
           fmt::format("is not known here, expected one of {}. Correct or remove it",
                       fmt::join(known, ", ")));
  }
}

}  // namespace fathom
