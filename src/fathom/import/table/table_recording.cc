// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/table/table_recording.h"

#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/import/recording/channel_stamps.h"
#include "fathom/import/recording/find_channel.h"
#include "fathom/import/table/table_stamps.h"
#include "fathom/import/table/text_lines.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kRowsLookedAt = 20;

using TakeRow = std::function<void(std::int64_t line, const std::vector<std::string_view>& cells)>;

// What is not handed on, counted.
struct PassedOver {
  std::uint64_t rows = 0;  // with another number of cells
  std::int64_t first_row = 0;
  std::uint64_t cut_bytes = 0;  // of a last row that has no end
};

class TableRecording final : public Recording {
 public:
  TableRecording(const std::filesystem::path& path, const TableOptions& options);

  const Contents& contents() const override { return contents_; }

  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override;

 private:
  PassedOver ForEachRow(const TakeRow& take) const;
  void List();

  std::filesystem::path path_;
  TableLayout layout_;
  StampRule stamps_;
  Contents contents_;
};

// How often a column held a number, and another text.
struct ColumnTally {
  std::uint64_t numbers = 0;
  std::uint64_t texts = 0;
  std::int64_t first_text_line = 0;
  std::string first_text;
};

// The digits behind the point of the stamps, and how many stamps go back.
struct StampDigits {
  std::size_t fewest = 0;
  std::size_t most = 0;
  std::uint64_t num_stamps = 0;
  std::uint64_t num_back = 0;
  double latest = -INFINITY;

  void Take(double time, std::string_view cell) {
    const std::size_t point = cell.find_last_of(".,");
    std::size_t count = 0;
    while (point != std::string_view::npos && point + 1 + count < cell.size() &&
           std::isdigit(static_cast<unsigned char>(cell[point + 1 + count])) != 0) {
      ++count;
    }
    fewest = num_stamps == 0 ? count : std::min(fewest, count);
    most = std::max(most, count);
    ++num_stamps;
    if (time < latest) ++num_back;
    latest = std::max(latest, time);
  }
};

// Digits behind the point that miss their leading zeros: .02 s is written as ".20000000", and lies
// behind .11 s.
void TellUnpadded(const StampDigits& digits,
                  const std::optional<Field>& clock,
                  std::vector<std::string>* remarks) {
  constexpr double kShareOfAccidents = 0.01;
  if (!clock || digits.fewest == digits.most ||
      static_cast<double>(digits.num_back) <
          kShareOfAccidents * static_cast<double>(digits.num_stamps)) {
    return;
  }
  remarks->push_back(fmt::format(
      "column {}: {} of {} stamps lie before an earlier one, and have {} to {} digits behind the "
      "point: their leading zeros are missing. Where other columns hold whole seconds and "
      "nanoseconds, the map's streams take these: 'time: {{seconds: SECS, nanoseconds: NSECS}}'.",
      Quoted(clock->name),
      digits.num_back,
      digits.num_stamps,
      digits.fewest,
      digits.most));
}

TableRecording::TableRecording(const std::filesystem::path& path, const TableOptions& options)
    : path_(path) {
  ByteFile file(path);
  layout_ = FindTableLayout(&file, options);
  std::vector<std::vector<std::string>> rows;
  CellSplitter splitter(layout_.style.separator);
  TextLines lines(&file, layout_.first_row, layout_.first_row_line);
  lines.JoinQuoted();
  while (rows.size() < kRowsLookedAt && lines.Next()) {
    const auto& cells = splitter.Split(lines.text());
    if (cells.size() == layout_.columns.size() && lines.has_end()) {
      rows.emplace_back(cells.begin(), cells.end());
    }
  }
  stamps_ = FindStamps(path.string(), layout_, options, rows);
  List();
}

PassedOver TableRecording::ForEachRow(const TakeRow& take) const {
  PassedOver passed_over;
  ByteFile file(path_);
  CellSplitter splitter(layout_.style.separator);
  TextLines lines(&file, layout_.first_row, layout_.first_row_line);
  lines.JoinQuoted();
  while (lines.Next()) {
    const auto& cells = splitter.Split(lines.text());
    if (cells.size() == layout_.columns.size()) {
      take(lines.number(), cells);
    } else if (!lines.has_end()) {
      passed_over.cut_bytes = file.size() - lines.offset();
    } else if (cells.size() > 1 || !IsEmptyCell(cells.front())) {
      if (passed_over.rows++ == 0) passed_over.first_row = lines.number();
    }
  }
  return passed_over;
}

void TableRecording::List() {
  ChannelStamps channel_stamps;
  StampReader stamp_reader(stamps_, layout_.style.decimal);
  std::vector<ColumnTally> tallies(layout_.columns.size());
  std::uint64_t without_stamp = 0;
  StampDigits digits;
  const PassedOver passed_over =
      ForEachRow([&](std::int64_t line, const std::vector<std::string_view>& cells) {
        const auto time = stamp_reader.Read(cells);
        if (!time && stamps_.column >= 0) {
          ++without_stamp;
          return;
        }
        channel_stamps.Add(time.value_or(NAN));
        if (time) digits.Take(*time, cells[stamps_.column]);
        for (std::size_t i = 0; i < cells.size(); ++i) {
          if (IsEmptyCell(cells[i])) continue;
          if (ParseCell(cells[i], layout_.style.decimal)) {
            ++tallies[i].numbers;
          } else if (tallies[i].texts++ == 0) {
            tallies[i].first_text_line = line;
            tallies[i].first_text = cells[i];
          }
        }
      });

  contents_.format = "csv";
  contents_.size_bytes = std::filesystem::file_size(path_);
  contents_.read_bytes = contents_.size_bytes - passed_over.cut_bytes;
  if (stamps_.is_utc) contents_.utc_of_zero = 0.0;
  Channel channel;
  channel.name = path_.stem().string();
  channel.type = "table";
  channel_stamps.WriteTo(&channel);
  if (stamps_.column >= 0) channel.clock = layout_.columns[stamps_.column];
  channel.clock_counts_rows = stamps_.counts_rows;
  if (!layout_.remark.empty()) contents_.remarks.push_back(layout_.remark);
  TellUnpadded(digits, channel.clock, &contents_.remarks);
  if (!stamps_.remark.empty()) contents_.remarks.push_back(stamps_.remark);
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const Field& field = layout_.columns[i];
    const ColumnTally& tally = tallies[i];
    if (tally.numbers <= tally.texts && tally.texts > 0) continue;  // of words
    channel.fields.push_back(field);
    if (tally.texts == 0) continue;
    contents_.remarks.push_back(
        fmt::format("line {}: column {} is {}: {} of the column hold no "
                    "number.",
                    tally.first_text_line,
                    Quoted(field.name),
                    Quoted(tally.first_text),
                    Plural(tally.texts, "cell")));
  }
  contents_.channels.push_back(std::move(channel));
  if (passed_over.rows > 0) {
    contents_.remarks.push_back(
        fmt::format("{} passed over, the first on line {}: expected {} "
                    "cells.",
                    Plural(passed_over.rows, "row"),
                    passed_over.first_row,
                    layout_.columns.size()));
  }
  if (without_stamp > 0) {
    contents_.remarks.push_back(
        fmt::format("{} without a stamp passed over.", Plural(without_stamp, "row")));
  }
  if (passed_over.cut_bytes > 0) {
    contents_.remarks.push_back(
        fmt::format("the file ends within a row: the {} from byte {} on are not read.",
                    Plural(passed_over.cut_bytes, "byte"),
                    contents_.read_bytes));
  }
}

std::vector<std::string> TableRecording::Read(std::span<const Selection> selections,
                                              const SampleSink& sink) const {
  std::map<std::string_view, std::size_t> column_of;
  for (std::size_t i = 0; i < layout_.columns.size(); ++i) {
    column_of.emplace(layout_.columns[i].name, i);
  }
  std::vector<std::vector<std::size_t>> columns;
  for (const Selection& selection : selections) {
    FindChannel(contents_, path_, selection);
    auto& indices = columns.emplace_back();
    for (const std::string& field : selection.fields) indices.push_back(column_of.at(field));
  }
  StampReader stamp_reader(stamps_, layout_.style.decimal);
  std::vector<double> values;
  ForEachRow([&](std::int64_t, const std::vector<std::string_view>& cells) {
    const auto time = stamp_reader.Read(cells);
    if (!time && stamps_.column >= 0) return;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      values.clear();
      for (const std::size_t column : columns[i]) {
        values.push_back(ParseCell(cells[column], layout_.style.decimal).value_or(NAN));
      }
      sink(i, time.value_or(NAN), values);
    }
  });
  return {};
}

}  // namespace

std::unique_ptr<Recording> OpenTable(const std::filesystem::path& path,
                                     const TableOptions& options) {
  return std::make_unique<TableRecording>(path, options);
}

}  // namespace fathom
