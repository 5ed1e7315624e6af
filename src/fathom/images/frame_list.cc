// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/images/frame_list.h"

#include "fathom/base/files/leaves_its_folder.h"
#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/log/csv/csv_rows.h"
#include "fathom/log/csv/csv_table.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {

FrameList ParseFrameList(const std::string& name, const std::string& text) {
  // The stamps by the rules of every CSV file; the paths are text, which it does not know.
  CsvTable stamps = ParseCsvTable(name, text, {});
  FrameList list;
  std::size_t column = 0;
  std::map<std::string, int> line_of;
  ForEachCsvRow(name, text, [&](int line, const std::vector<std::string_view>& cells) {
    if (line == 1) {
      const auto found = std::find(cells.begin(), cells.end(), "file");
      if (found == cells.end()) {
        throw InputError(fmt::format("{}:1: column 'file' is missing, found {}; expected t, file.",
                                     name,
                                     Printable(fmt::format("{}", fmt::join(cells, ", ")))));
      }
      column = found - cells.begin();
      return;
    }
    const std::string file(cells[column]);
    if (file.empty() || LeavesItsFolder(file)) {
      throw InputError(
          fmt::format("{}:{}: column 'file' is {}, expected the path of an image from this "
                      "folder on.",
                      name,
                      line,
                      file.empty() ? "empty" : Quoted(file)));
    }
    const auto [first, is_new] =
        line_of.emplace(std::filesystem::path(file).lexically_normal().string(), line);
    if (!is_new) {
      throw InputError(
          fmt::format("{}:{}: column 'file' is {} as on line {}, expected each image once.",
                      name,
                      line,
                      Quoted(file),
                      first->second));
    }
    list.frames.push_back(
        {.time = stamps.stream.time[list.frames.size()], .file = file, .line = line});
  });
  std::erase(stamps.not_read, "file");
  list.remark = stamps.Remark();
  return list;
}

FrameTimes ParseFrameTimes(const std::string& name, const std::string& text) {
  CsvSpec spec;
  spec.required = {"frame"};
  const CsvTable table = ParseCsvTable(name, text, spec);
  const std::vector<double>& numbers = *table.stream.Find("frame");
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    if (numbers[row] == static_cast<double>(row)) continue;
    throw InputError(fmt::format(
        "{}:{}: column 'frame' is {}, expected {}: the frames of the video in order, from 0 on.",
        name,
        table.line_of_row[row],
        numbers[row],
        row));
  }
  return {.times = table.stream.time, .remark = table.Remark()};
}

}  // namespace fathom
