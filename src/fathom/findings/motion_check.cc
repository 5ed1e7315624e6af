// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/motion_check.h"

#include "fathom/base/plural.h"
#include "fathom/base/short_number.h"
#include "fathom/findings/values/held_samples.h"
#include "fathom/findings/values/lost_values.h"
#include "fathom/findings/values/repeated_block.h"
#include "fathom/findings/values/sentinel.h"
#include "fathom/findings/values/stuck_values.h"
#include "fathom/signal/sources/log_column.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kShortHold = 0.3;  // [s]; a delay of half of that is no worse than a filter's

struct Column {
  std::string file, axis;
  std::span<const double> time, values;

  std::string Name() const { return fmt::format("{}: {}", file, axis); }

  double Share(std::size_t num_rows) const {
    return 100.0 * static_cast<double>(num_rows) / static_cast<double>(values.size());
  }
  FindingPlace Place(std::size_t first, std::size_t last) const {
    return {file, axis, {time[first], time[last]}};
  }
  // Of the rows from `first` on that hold one value.
  FindingPlace PlaceOfValue(std::size_t first) const {
    std::size_t last = first;
    while (last + 1 < values.size() && values[last + 1] == values[first]) ++last;
    return Place(first, last);
  }
};

// What is left of a column without its lost values.
struct Rows {
  std::vector<double> time, values;
};
Rows RowsOtherThan0(const Column& column) {
  Rows rows;
  for (std::size_t row = 0; row < column.values.size(); ++row) {
    if (column.values[row] == 0.0) continue;
    rows.time.push_back(column.time[row]);
    rows.values.push_back(column.values[row]);
  }
  return rows;
}

// Without the folder: a log may be moved, and what is wrong with it stays the same.
std::string NameOf(const std::filesystem::path& file) { return file.filename().string(); }

Finding Warning(const char* code, std::string sentence, FindingPlace where) {
  return {Severity::kWarning, code, std::move(sentence), std::move(where)};
}

// Ten held values about the largest change, where they show best.
FindingPlace PlaceOf(const Column& column, const HeldSamples& held) {
  constexpr double kNumOnEitherSide = 5.0;
  std::size_t row = 1;
  for (std::size_t i = 1; i < column.values.size(); ++i) {
    const auto change = [&](std::size_t k) {
      return std::abs(column.values[k] - column.values[k - 1]);
    };
    if (change(i) > change(row)) row = i;
  }
  const double side = kNumOnEitherSide * held.interval;
  return {column.file,
          column.axis,
          {std::max(column.time[row] - side, column.time.front()),
           std::min(column.time[row] + side, column.time.back())}};
}

Finding FindingOf(const Column& column, const Sentinel& sentinel) {
  return Warning("sentinel",
                 fmt::format("{} is exactly {} in {}, first at t = {:.6g} s, far from all "
                             "other values. Such a number stands for \"no reading\". Take these "
                             "rows out.",
                             column.Name(),
                             sentinel.value,
                             Plural(static_cast<std::size_t>(sentinel.num_rows), "row"),
                             column.time[sentinel.first]),
                 column.PlaceOfValue(sentinel.first));
}

Finding FindingOf(const Column& column, const LostValues& lost) {
  return Warning("lost_values",
                 fmt::format("{} is exactly 0 in {} rows ({} %) while the rows before and "
                             "after them are far from 0, first at t = {:.6g} s. The sensor had no "
                             "reading. Take these rows out.",
                             column.Name(),
                             lost.num_rows,
                             ShortNumber(column.Share(lost.num_rows), 2),
                             column.time[lost.first]),
                 column.PlaceOfValue(lost.first));
}

Finding FindingOf(const Column& column, const StuckValues& stuck) {
  const double from = column.time[stuck.longest.first], to = column.time[stuck.longest.last];
  return Warning("stuck_values",
                 fmt::format("{} stands still in {} rows ({} %), the longest time at {:.6g} "
                             "for {:.3g} s from t = {:.6g} s. The sensor wrote no new value. Take "
                             "these rows out.",
                             column.Name(),
                             stuck.num_rows,
                             ShortNumber(column.Share(stuck.num_rows), 2),
                             column.values[stuck.longest.first],
                             to - from,
                             from),
                 column.Place(stuck.longest.first, stuck.longest.last));
}

Finding FindingOf(const Column& column, const HeldSamples& held) {
  return {
      held.interval < kShortHold ? Severity::kNote : Severity::kWarning,
      "held_samples",
      fmt::format("{} has a new value only every {:.3g} s, though a row comes every {:.3g} s: a "
                  "slow sensor was written at a higher rate. Keep only the rows in which the "
                  "value is new.",
                  column.Name(),
                  held.interval,
                  held.row_step),
      PlaceOf(column, held)};
}

Finding FindingOf(const Column& column, const RepeatedBlock& block) {
  return Warning("repeated_block",
                 fmt::format("{} holds the same {} rows twice, from t = {:.6g} s and from t = "
                             "{:.6g} s. Data with noise never repeat to the last digit. Take one "
                             "of the blocks out.",
                             column.Name(),
                             block.num_rows,
                             column.time[block.first],
                             column.time[block.second]),
                 column.Place(block.second, block.second + block.num_rows - 1));
}

void CheckColumn(const Column& column, std::vector<Finding>* findings) {
  const auto add = [&](const Column& in, const auto& found) {
    if (found && !Has(*findings, FindingOf(in, *found).code)) {
      findings->push_back(FindingOf(in, *found));
    }
  };
  add(column, FindSentinel(column.values));
  const auto lost = FindLostValues(column.values);
  add(column, lost);
  const auto held = FindHeldSamples(column.time, column.values);
  add(column, held);
  if (!held) {
    const Rows rows = lost ? RowsOtherThan0(column) : Rows();
    const Column rest = lost ? Column{column.file, column.axis, rows.time, rows.values} : column;
    add(rest, FindStuckValues(rest.time, rest.values));
  }
  add(column, FindRepeatedBlock(column.values));
}

void CheckColumns(const Stream& stream,
                  std::span<const std::string_view> names,
                  const std::string& file,
                  std::vector<Finding>* findings) {
  for (const std::string_view name : names) {
    const std::vector<double>* values = stream.Find(name);
    if (values == nullptr) continue;
    CheckColumn({file, std::string(name), stream.time, *values}, findings);
  }
}

}  // namespace

std::vector<Finding> CheckMotion(const Log& log, Dof dof, Source source) {
  std::vector<Finding> findings;
  if (source == Source::kPoseEstimator) {
    if (!log.velocity) return findings;
    const std::array names = {VelocityColumn(dof)};
    CheckColumns(*log.velocity, names, NameOf(FileOf(log, "velocity.csv")), &findings);
    return findings;
  }
  if (!log.pose) return findings;
  constexpr std::array<std::string_view, 3> kPosition = {"x", "y", "z"};
  constexpr std::array<std::string_view, 4> kQuaternion = {"qx", "qy", "qz", "qw"};
  const auto names = IsAngular(dof) ? std::span<const std::string_view>(kQuaternion)
                                    : std::span<const std::string_view>(kPosition);
  CheckColumns(*log.pose, names, NameOf(PoseFileOf(log)), &findings);
  return findings;
}

std::vector<Finding> CheckOtherMotion(const Log& log, Dof dof) {
  std::vector<Finding> findings;
  if (!log.velocity) return findings;
  for (const Dof other : kAllDofs) {
    if (other == dof) continue;
    std::vector<Finding> own;
    const std::array names = {VelocityColumn(other)};
    CheckColumns(*log.velocity, names, NameOf(FileOf(log, "velocity.csv")), &own);
    for (Finding& finding : own) findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace fathom
