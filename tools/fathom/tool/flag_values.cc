// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/flag_values.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace fathom {

std::vector<std::string> SplitAtCommas(const std::string& text) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  size_t begin = 0;
  while (true) {
    const size_t comma = text.find(',', begin);
    parts.push_back(text.substr(begin, comma - begin));
    if (comma == std::string::npos) return parts;
    begin = comma + 1;
  }
}

std::vector<std::string> RepeatedValues(const std::string& flag) {
  std::vector<std::string> values;
  if (flag.empty()) return values;
  std::size_t begin = 0;
  for (std::size_t end; (end = flag.find(kBetweenValues, begin)) != std::string::npos;
       begin = end + 1) {
    values.push_back(flag.substr(begin, end - begin));
  }
  values.push_back(flag.substr(begin));
  return values;
}

std::vector<std::string> PathsInValues(const std::string& flag) {
  std::vector<std::string> paths;
  for (const std::string& value : RepeatedValues(flag)) {
    std::error_code error;
    if (std::filesystem::exists(value, error)) {
      paths.push_back(value);
      continue;
    }
    for (std::string& path : SplitAtCommas(value)) paths.push_back(std::move(path));
  }
  return paths;
}

void RequireOnePath(const std::string& flag, const std::string& value) {
  const std::size_t size = PathsInValues(value).size();
  if (size < 2) return;
  throw InputError(
      fmt::format("--{}: names {}, expected one: this program takes one at a time.", flag, size));
}

}  // namespace fathom
