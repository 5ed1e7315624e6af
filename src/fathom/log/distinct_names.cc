// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/distinct_names.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace fathom {
namespace {

std::string FolderOf(const Log& log) {
  const std::filesystem::path path = log.path.lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

// Adds `more` to each name that another one is equal to.
template <typename More>
void TellApart(std::vector<std::string>* names, const More& more) {
  const std::vector<std::string> before = *names;
  for (size_t i = 0; i < before.size(); ++i) {
    if (std::count(before.begin(), before.end(), before[i]) > 1) (*names)[i] = more(i);
  }
}

}  // namespace

std::vector<std::string> DistinctNames(std::span<const Log> logs) {
  std::vector<std::string> names;
  for (const Log& log : logs) names.push_back(log.name);
  TellApart(&names,
            [&](size_t i) { return fmt::format("{} ({})", logs[i].name, FolderOf(logs[i])); });
  TellApart(&names,
            [&](size_t i) { return fmt::format("{} ({})", logs[i].name, logs[i].path.string()); });
  const std::vector<std::string> before = names;
  for (size_t i = 0; i < names.size(); ++i) {
    const auto here = before.begin() + static_cast<std::ptrdiff_t>(i);
    const auto earlier = std::count(before.begin(), here, before[i]);
    if (earlier > 0) names[i] += fmt::format(" {}", earlier + 1);
  }
  return names;
}

}  // namespace fathom
