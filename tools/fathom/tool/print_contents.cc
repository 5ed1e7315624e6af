// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/print_contents.h"

#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/report/table.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/wide_flag.h"

#include <cmath>
#include <cstddef>
#include <cstdio>

#include <fmt/format.h>
#include <gflags/gflags.h>

DECLARE_bool(wide);

namespace fathom {
namespace {

// "Roll [deg], Pitch [deg], ..."; with --wide all of them.
std::string FieldsText(const Channel& channel) {
  constexpr std::size_t kMostCharacters = 45;
  std::string text;
  for (const Field& field : channel.fields) {
    const std::string unit = field.unit.empty() ? "" : fmt::format(" [{}]", field.unit);
    const std::string entry = (text.empty() ? "" : ", ") + ShownOnOneLine(field.name + unit);
    if (!FLAGS_wide && text.size() + entry.size() > kMostCharacters) return text + ", ...";
    text += entry;
  }
  return text;
}

}  // namespace

std::string Heading(const std::filesystem::path& file, const Contents& contents) {
  const double kilobytes = static_cast<double>(contents.size_bytes) / 1e3;
  std::size_t num_fields = 0;
  for (const Channel& channel : contents.channels) num_fields += channel.fields.size();
  std::string text = fmt::format("{}: {}, {:.0f} kB, {}, {}",
                                 ShownOnOneLine(file.string()),
                                 contents.format,
                                 kilobytes,
                                 Plural(contents.channels.size(), "channel"),
                                 Plural(num_fields, "field"));
  if (contents.IsComplete()) return text;
  // Rounded down: what is not whole is not 100 %.
  const double tenths = std::floor(1000.0 * static_cast<double>(contents.read_bytes) /
                                   static_cast<double>(contents.size_bytes));
  return text + fmt::format("; incomplete: {} of {} bytes are sound ({:.1f} %)",
                            contents.read_bytes,
                            contents.size_bytes,
                            0.1 * tenths);
}

void PrintContents(const std::filesystem::path& file, const Contents& contents) {
  fmt::print("{}\n\n", Heading(file, contents));
  Table table;
  table.columns = {{"channel"},
                   {"type", false, 3},
                   {"count", true, 1},
                   {"first [s]", true, 2},
                   {"last [s]", true, 2},
                   {"rate [Hz]", true},
                   {"fields"}};
  for (const Channel& channel : contents.channels) {
    // A rate of two or three messages says nothing.
    const bool has_span = channel.count > 3 && channel.first && *channel.last > *channel.first;
    const double span = has_span ? *channel.last - *channel.first : 0.0;
    table.rows.push_back(
        {{ShownOnOneLine(channel.name),
          ShownOnOneLine(channel.type),
          std::to_string(channel.count),
          channel.first ? fmt::format("{:.3f}", *channel.first) : "-",
          channel.last ? fmt::format("{:.3f}", *channel.last) : "-",
          has_span ? fmt::format("{:.1f}", static_cast<double>(channel.count - 1) / span) : "-",
          FieldsText(channel)}});
  }
  fmt::print("{}", TableForTerminal(table));
  for (const std::string& remark : contents.remarks) PrintText(stdout, "note: " + remark + "\n");
}

}  // namespace fathom
