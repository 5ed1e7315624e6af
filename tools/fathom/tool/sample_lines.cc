// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/sample_lines.h"

#include "fathom/base/input_error.h"
#include "fathom/base/not_finite.h"
#include "fathom/base/number.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/base/trimmed.h"
#include "fathom/log/csv/unit_suffix.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr std::array<std::string_view, 3> kSampleColumns = {"t", "tau", "v"};

void SplitSampleLine(std::string_view line, std::vector<std::string_view>* cells) {
  cells->clear();
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells->push_back(Trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
}

bool IsNumberCell(std::string_view cell) { return ParseFiniteNumber(cell).has_value(); }

// "t, u, tau", cut after ten names.
std::string NamesIn(const std::vector<std::string_view>& cells) {
  constexpr std::size_t kMostShown = 10;
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < std::min(cells.size(), kMostShown); ++i) {
    shown.push_back(Printable(cells[i]));
  }
  if (cells.size() > kMostShown) shown.push_back(fmt::format("... ({} in all)", cells.size()));
  return fmt::format("{}", fmt::join(shown, ", "));
}

}  // namespace

SampleLines::SampleLines(std::string name, std::istream* in) : name_(std::move(name)), in_(in) {}

void SampleLines::GoOnBehind(const SampleLine& last, const std::string& from) {
  behind_ = last;
  behind_from_ = from;
}

void SampleLines::Fail(const std::string& problem) const {
  throw InputError(fmt::format("{}:{}: {}", name_, line_, problem));
}

bool SampleLines::ReadLine() {
  ++line_;
  in_->getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  if (in_->bad()) Fail("the stream cannot be read any further.");
  auto length = static_cast<std::size_t>(in_->gcount());
  if (in_->eof() && length == 0) return false;
  if (in_->fail()) {
    Fail(fmt::format("the line has more than {} bytes, expected t,tau,v.", buffer_.size() - 1));
  }
  if (!in_->eof()) --length;  // the line feed, which is counted
  text_ = Trimmed(std::string_view(buffer_.data(), length));
  return true;
}

// What no line of a stream may hold, however its cells are separated.
void SampleLines::RefuseWhatIsNoPlainText() const {
  if (line_ == 1 && text_.starts_with("\xef\xbb\xbf")) {
    Fail(
        "starts with a UTF-8 byte order mark, expected t,tau,v. Send the stream through "
        "sed '1s/^\\xEF\\xBB\\xBF//'.");
  }
  if (line_ == 1 && (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff"))) {
    Fail("is UTF-16, expected plain text. Send the stream through iconv -f UTF-16 -t ASCII.");
  }
  if (text_.find('\0') != std::string_view::npos) {
    Fail("a NUL byte amid the text, expected t,tau,v. What writes the stream is no text.");
  }
  if (text_.ends_with('\r')) {
    Fail(
        "the line ends in a carriage return, expected a line feed only. Send the stream through "
        "tr -d '\\r'.");
  }
}

// Of cells that commas do not separate, what does.
void SampleLines::RefuseOtherSeparators() const {
  if (cells_.size() != 1) return;
  for (const auto& [separator, name] : {std::pair{';', "';'"}, {'\t', "tabs"}, {' ', "spaces"}}) {
    if (text_.find(separator) == std::string_view::npos) continue;
    Fail(fmt::format("the cells are separated by {}, expected commas: t,tau,v.", name));
  }
}

void SampleLines::RefuseUnits() const {
  for (const std::string_view cell : cells_) {
    const auto name = NameWithoutUnit(cell, {kSampleColumns.begin(), kSampleColumns.end()});
    if (!name || std::ranges::count(cells_, *name) > 0) continue;
    Fail(
        fmt::format("column {} is {} with a unit, expected SI units and plain names. Convert to SI "
                    "and name the column '{}'.",
                    Quoted(cell),
                    *name == "t" ? "the time" : Quoted(*name),
                    *name));
  }
}

void SampleLines::TakeNames() {
  RefuseUnits();
  for (std::size_t role = 0; role < column_.size(); ++role) {
    const auto named = std::ranges::find(cells_, kSampleColumns[role]);
    if (named == cells_.end()) {
      Fail(fmt::format("column '{}' is missing, found {}; expected t, tau, v.",
                       kSampleColumns[role],
                       NamesIn(cells_)));
    }
    const auto again = std::find(named + 1, cells_.end(), kSampleColumns[role]);
    if (again != cells_.end()) {
      Fail(fmt::format("column '{}' stands twice, as column {} and {}. Remove or rename one.",
                       kSampleColumns[role],
                       named - cells_.begin() + 1,
                       again - cells_.begin() + 1));
    }
    column_[role] = static_cast<std::size_t>(named - cells_.begin());
  }
  num_cells_ = cells_.size();
  line_of_names_ = line_;
  for (const std::string_view cell : cells_) {
    if (std::ranges::count(kSampleColumns, cell) == 0) not_read_.emplace_back(Printable(cell));
  }
}

double SampleLines::NumberIn(std::size_t role) const {
  const std::string_view cell = cells_[column_[role]];
  if (const auto number = ParseFiniteNumber(cell)) return *number;
  Fail(fmt::format(
      "column '{}' is {}, expected a {}. Remove the line or repair it upstream; this "
      "reader does not guess.",
      kSampleColumns[role],
      cell.empty() ? "empty" : Quoted(cell),
      cell.empty() || MeansNoFiniteNumber(cell) ? "finite number" : "number such as -0.25"));
}

void SampleLines::RequireRising(double t) const {
  if (!last_stamp_ || t > *last_stamp_) return;
  if (t == *last_stamp_) {
    Fail(
        fmt::format("column 't' is {} as on line {}, expected rising stamps. Leave out one of the "
                    "two lines, or print t with more digits.",
                    t,
                    line_of_last_stamp_));
  }
  Fail(
      fmt::format("column 't' goes back from {} to {}, expected rising stamps. Sort the lines, or "
                  "begin anew, with another --state, where the clock was reset.",
                  *last_stamp_,
                  t));
}

bool SampleLines::IsPassedOver(const SampleLine& sample) {
  if (!behind_) return false;
  if (sample.t <= behind_->t) {
    holds_behind_ = sample == *behind_;
    ++num_passed_over_;
    return true;
  }
  if (num_passed_over_ > 0 && !holds_behind_) {
    Fail(
        fmt::format("t = {} comes without a line {},{},{} before it, the last sample of {}. "
                    "Expected the same stream again, or one that begins behind it.",
                    sample.t,
                    behind_->t,
                    behind_->force,
                    behind_->velocity,
                    behind_from_));
  }
  behind_.reset();
  return false;
}

std::optional<SampleLine> SampleLines::Next() {
  while (ReadLine()) {
    RefuseWhatIsNoPlainText();
    if (text_.empty() || text_.starts_with('#')) continue;
    SplitSampleLine(text_, &cells_);
    RefuseOtherSeparators();
    if (!std::exchange(has_first_line_, true) && std::ranges::none_of(cells_, IsNumberCell)) {
      TakeNames();
      continue;
    }
    if (cells_.size() != num_cells_) {
      const std::string expected = line_of_names_ > 0
                                       ? fmt::format("{} as on line {}", num_cells_, line_of_names_)
                                       : fmt::format("{}: t,tau,v", num_cells_);
      Fail(fmt::format("the line has {}, {}, expected {}.",
                       Plural(cells_.size(), "cell"),
                       Quoted(text_),
                       expected));
    }
    const SampleLine sample = {NumberIn(0), NumberIn(1), NumberIn(2)};
    RequireRising(sample.t);
    const bool is_passed_over = IsPassedOver(sample);
    last_stamp_ = sample.t;
    line_of_last_stamp_ = line_;
    if (!is_passed_over) return sample;
  }
  return std::nullopt;
}

}  // namespace fathom
