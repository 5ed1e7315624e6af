// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dives/nearly_log.h"

#include "fathom/archive/dives/named_few.h"
#include "fathom/base/plural.h"
#include "fathom/log/single_csv.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr std::array<std::string_view, 3> kStreams = {"command.csv", "velocity.csv", "pose.csv"};

std::string Lower(std::string text) {
  std::ranges::transform(
      text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// The separator in whose place commas would make a single CSV of it, units aside; 0: there is none.
char OtherSeparatorOfLog(std::string_view text) {
  std::string first_line(text.substr(0, text.find_first_of("\r\n")));
  for (const char separator : {';', '\t'}) {
    if (first_line.find(separator) == std::string::npos) continue;
    std::ranges::replace(first_line, separator, ',');
    if (IsSingleCsvLog(first_line) || IsMeantAsSingleCsvLog(first_line)) return separator;
  }
  return 0;
}

}  // namespace

std::optional<std::string> WhyFolderIsNearlyLog(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::string lower = Lower(name);
    if (lower == "log.yml" || lower == "log.yaml") {
      return fmt::format("holds {}, expected log.yaml", name);
    }
  }
  std::vector<std::string_view> streams;
  for (const std::string_view stream : kStreams) {
    if (std::ranges::count(names, stream) > 0) streams.push_back(stream);
  }
  if (streams.size() < 2) return std::nullopt;
  return fmt::format("holds {} and no log.yaml", fmt::join(streams, ", "));
}

std::optional<std::string> WhyFileIsNearlyLog(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (Lower(ending) != ".csv") return std::nullopt;
  if (std::ranges::count(kStreams, file.filename().string()) > 0) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::array<char, 4096> begin = {};
  in.read(begin.data(), begin.size());
  const std::string_view text(begin.data(), static_cast<std::size_t>(in.gcount()));
  if (IsSingleCsvLog(text)) {
    if (ending == ".csv") return std::nullopt;
    return fmt::format("ends in {}, expected .csv", ending);
  }
  if (const char separator = OtherSeparatorOfLog(text); separator != 0) {
    return fmt::format("its columns are separated by {}, expected commas and decimal points",
                       separator == '\t' ? "tabs" : "semicolons");
  }
  if (!IsMeantAsSingleCsvLog(text)) return std::nullopt;
  return "its first line does not name t, tau and v";
}

std::string NearlyLogsSentence(const std::vector<NearlyLog>& nearly_logs) {
  if (nearly_logs.empty()) return "";
  std::vector<std::string> each;
  for (const NearlyLog& one : nearly_logs) {
    each.push_back(fmt::format("{} ({})", one.path, one.why));
  }
  return fmt::format("{} nearly {}: {}.",
                     each.size() == 1 ? "1 place is" : Plural(each.size(), "place") + " are",
                     each.size() == 1 ? "a log" : "logs",
                     NamedFew(each));
}

}  // namespace fathom
