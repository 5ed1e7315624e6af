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
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;
using Event = Json::parse_event_t;

constexpr int kDeepestNesting = 16;

std::string Below(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

// Whether a text begins as a JSON file of ours does.
bool MayBeJson(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
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

std::string Shortened(const Json& value) {
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 40) + "...";
}

// The parser takes it for the end of the text, and what follows would not be read.
void RefuseNulByte(const std::string& name, std::string_view text) {
  const std::size_t at = text.find('\0');
  if (at == std::string_view::npos) return;
  const std::string_view before = text.substr(0, at);
  const std::size_t begin = before.rfind('\n') + 1;  // 0 where there is none
  throw InputError(
      fmt::format("{}:{}: a NUL byte stands in column {}, expected the text of a JSON file. It is "
                  "damaged; restore it from its source.",
                  name,
                  1 + std::ranges::count(before, '\n'),
                  at - begin + 1));
}

struct File {
  std::string name;
  Json root;
};

}  // namespace

struct JsonValue::Place {
  std::shared_ptr<const File> file;
  const Json& json;
  std::string path;

  JsonValue At(const Json& value, std::string its_path) const {
    return JsonValue(std::make_shared<const Place>(Place{file, value, std::move(its_path)}));
  }
};

JsonValue::JsonValue(std::shared_ptr<const Place> place) : place_(std::move(place)) {}

JsonValue JsonValue::Parse(const std::string& name, std::string_view text) {
  if (MayBeJson(text)) RefuseNulByte(name, text);
  WhileParsing watch(name);
  const auto see = [&](int depth, Event event, const Json& parsed) {
    watch.See(depth, event, parsed);
    return true;
  };
  try {
    const auto file = std::make_shared<const File>(File{name, Json::parse(text, see)});
    return JsonValue(std::make_shared<const Place>(Place{file, file->root, ""}));
  } catch (const Json::exception& error) {
    if (!MayBeJson(text)) {
      throw InputError(
          fmt::format("{}: is no model, expected the JSON of fathom_identify --model.", name));
    }
    // Without the parser's own name for it, "[json.exception.parse_error.101] ".
    const std::string_view what = error.what();
    throw InputError(fmt::format("{}: is not JSON: {}.", name, what.substr(what.find("] ") + 2)));
  }
}

void JsonValue::Fail(const std::string& problem) const {
  Refuse(place_->file->name, place_->path, problem);
}

bool JsonValue::Has(const std::string& key) const {
  return place_->json.is_object() && place_->json.contains(key);
}

JsonValue JsonValue::Member(const std::string& key) const {
  if (!Has(key)) Refuse(place_->file->name, Below(place_->path, key), "is missing");
  return place_->At(place_->json.at(key), Below(place_->path, key));
}

std::optional<JsonValue> JsonValue::MemberIfThere(const std::string& key) const {
  if (!Has(key)) return std::nullopt;
  return Member(key);
}

std::vector<std::string> JsonValue::Keys() const {
  std::vector<std::string> keys;
  if (!place_->json.is_object())
    Fail(fmt::format("is {}, expected keys and values", Shortened(place_->json)));
  for (const auto& [key, value] : place_->json.items()) keys.push_back(key);
  return keys;
}

std::vector<JsonValue> JsonValue::List() const {
  if (!place_->json.is_array())
    Fail(fmt::format("is {}, expected a list", Shortened(place_->json)));
  std::vector<JsonValue> list;
  for (const Json& value : place_->json) {
    list.push_back(place_->At(value, fmt::format("{}[{}]", place_->path, list.size())));
  }
  return list;
}

std::vector<std::string> JsonValue::Texts() const {
  std::vector<std::string> texts;
  for (const JsonValue& value : List()) texts.push_back(value.Text());
  return texts;
}

std::string JsonValue::Text() const {
  if (!place_->json.is_string())
    Fail(fmt::format("is {}, expected a text", Shortened(place_->json)));
  return place_->json.get<std::string>();
}

bool JsonValue::Boolean() const {
  if (!place_->json.is_boolean()) {
    Fail(fmt::format("is {}, expected true or false", Shortened(place_->json)));
  }
  return place_->json.get<bool>();
}

double JsonValue::Number() const {
  if (!place_->json.is_number() || !std::isfinite(place_->json.get<double>())) {
    Fail(fmt::format("is {}, expected a finite number", Shortened(place_->json)));
  }
  return place_->json.get<double>();
}

double JsonValue::NumberIfKnown() const {
  return place_->json.is_null() ? std::numeric_limits<double>::quiet_NaN() : Number();
}

double JsonValue::NumberIfThere(const std::string& key) const {
  const auto value = MemberIfThere(key);
  return value ? value->NumberIfKnown() : std::numeric_limits<double>::quiet_NaN();
}

void JsonValue::RequireKeysOf(const std::vector<std::string>& known) const {
  for (const std::string& key : Keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    Refuse(place_->file->name,
           Below(place_->path, key),
           fmt::format("is not known here, expected one of {}. Correct or remove it",
                       fmt::join(known, ", ")));
  }
}

}  // namespace fathom
