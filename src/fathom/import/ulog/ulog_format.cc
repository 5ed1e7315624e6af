// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ulog/ulog_format.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kMostBytes = 65533;       // of a message's data: 65535 less its id
constexpr std::size_t kMostText = 1 << 20;      // of all formats of a file; PX4 writes 50 kB
constexpr std::size_t kLongestFieldName = 256;  // of a field, with those that it is nested in
constexpr int kDeepestNesting = 16;             // nesting; PX4 has 2
constexpr std::string_view kPadding = "_padding";

bool IsName(std::string_view text) {
  return !text.empty() && text.size() <= kLongestFieldName &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '_' || c == '-' || c == '/';
         });
}

}  // namespace

// "float x" or "float[4] q".
bool UlogFormats::ParseUlogField(std::string_view text, UlogField* field) {
  const std::size_t blank = text.find(' ');
  if (blank == std::string_view::npos) return false;
  std::string_view type = text.substr(0, blank);
  const std::string_view name = text.substr(blank + 1);
  if (type.ends_with(']')) {
    const std::size_t bracket = type.find('[');
    if (bracket == std::string_view::npos) return false;
    const char* const end = type.data() + type.size() - 1;
    const auto [stop, error] = std::from_chars(type.data() + bracket + 1, end, field->count);
    if (error != std::errc() || stop != end || field->count == 0) return false;
    field->is_array = true;
    type = type.substr(0, bracket);
  }
  field->type = type;
  field->name = name;
  return IsName(type) && IsName(name);
}

void UlogFormats::Take(std::string_view text) {
  const std::size_t colon = text.find(':');
  text_bytes_ += text.size();
  if (colon == std::string_view::npos || !IsName(text.substr(0, colon)) ||
      text_bytes_ > kMostText) {
    ++num_unreadable_;
    return;
  }
  const std::string name(text.substr(0, colon));
  std::vector<UlogField> fields;
  std::string_view rest = text.substr(colon + 1);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    UlogField field;
    if (end > 0) {
      if (!ParseUlogField(rest.substr(0, end), &field)) {
        ++num_unreadable_;
        return;
      }
      fields.push_back(std::move(field));
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (fields.empty()) {
    ++num_unreadable_;
    return;
  }
  const auto known = formats_.find(name);
  if (known == formats_.end()) {
    formats_.emplace(name, std::move(fields));
  } else if (known->second != fields) {
    ++num_redefined_;
  }
}

UlogLayout UlogFormats::LayoutOf(const std::string& name, std::size_t* budget) const {
  UlogLayout layout;
  AddFields(name, "", 0, budget, &layout);
  // Padding at the end is not logged, be it the message's own or that of a type nested in it.
  const auto& fields = formats_.at(name);
  for (auto field = fields.rbegin(); field != fields.rend(); ++field) {
    const auto type = PackedTypeNamed(field->type);
    if (!field->name.starts_with(kPadding) || !type) break;
    layout.size -= field->count * SizeOf(*type);
  }
  return layout;
}

void UlogFormats::AddFields(const std::string& format,
                            const std::string& prefix,
                            int depth,
                            std::size_t* budget,
                            UlogLayout* layout) const {
  const auto found = formats_.find(format);
  if (found == formats_.end()) {
    throw InputError(fmt::format("no message F defines {}.", Quoted(format)));
  }
  if (depth > kDeepestNesting) {
    throw InputError(fmt::format(
        "{} is nested over {} deep, expected no circle.", Quoted(format), kDeepestNesting));
  }
  for (const UlogField& field : found->second) {
    const std::optional<NumberType> type = PackedTypeNamed(field.type);
    const bool is_passed_over = type && (field.type == "char" || field.name.starts_with(kPadding));
    // Those that are passed over are one piece.
    const std::size_t count = is_passed_over ? 1 : field.count;
    for (std::size_t i = 0; i < count; ++i) {
      if (*budget == 0) {
        throw InputError(
            fmt::format("the formats up to {} have more fields than any autopilot "
                        "logs.",
                        Quoted(format)));
      }
      --*budget;
      std::string name = prefix + field.name;
      if (field.is_array) name += fmt::format("[{}]", i);
      if (name.size() > kLongestFieldName) {
        throw InputError(
            fmt::format("{} has a field with a name of {} characters, expected {} at "
                        "most.",
                        Quoted(format),
                        name.size(),
                        kLongestFieldName));
      }
      if (!type) {
        AddFields(field.type, name + ".", depth + 1, budget, layout);
        continue;
      }
      const std::size_t size = SizeOf(*type) * (is_passed_over ? field.count : 1);
      if (field.count > kMostBytes || layout->size + size > kMostBytes) {
        throw InputError(fmt::format("{} has over {} bytes.", Quoted(format), kMostBytes));
      }
      if (!is_passed_over) layout->numbers.push_back({std::move(name), *type, layout->size, false});
      layout->size += size;
    }
  }
}

}  // namespace fathom
