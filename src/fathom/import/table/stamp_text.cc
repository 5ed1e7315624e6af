// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/table/stamp_text.h"

#include "fathom/base/utc_time.h"

#include <cctype>
#include <cstddef>
#include <string>

namespace fathom {
namespace {

// Whether `text` begins as `shape` does, where '#' stands for any digit.
bool HasShape(std::string_view text, std::string_view shape) {
  if (text.size() < shape.size()) return false;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const bool is_digit = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    if (shape[i] == '#' ? !is_digit : text[i] != shape[i]) return false;
  }
  return true;
}

// The date in the form of ISO 8601 with what follows it; empty if it begins with no date.
std::string WithIsoDate(std::string_view text) {
  constexpr std::size_t kDate = 10;  // characters
  if (HasShape(text, "####-##-##")) return std::string(text);
  std::string rest(text.substr(std::min(kDate, text.size())));
  if (HasShape(text, "####/##/##")) {
    return std::string(text.substr(0, 4)) + "-" + std::string(text.substr(5, 2)) + "-" +
           std::string(text.substr(8, 2)) + rest;
  }
  if (HasShape(text, "##.##.####")) {
    return std::string(text.substr(6, 4)) + "-" + std::string(text.substr(3, 2)) + "-" +
           std::string(text.substr(0, 2)) + rest;
  }
  return {};
}

}  // namespace

std::optional<TextStamp> ParseTextStamp(std::string_view text) {
  TextStamp stamp;
  std::string iso = WithIsoDate(text);
  stamp.has_date = !iso.empty();
  if (!stamp.has_date) {
    if (!HasShape(text, "##:##")) return std::nullopt;
    iso = "1970-01-01T" + std::string(text);
  }
  for (char& c : iso) {
    if (c == ',') c = '.';
  }
  const std::optional<double> seconds = ParseUtc(iso);
  if (!seconds) return std::nullopt;
  stamp.seconds = *seconds;
  return stamp;
}

}  // namespace fathom
