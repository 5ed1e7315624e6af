// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/sample_lines.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"
#include "fathom/base/trimmed.h"

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

void SampleLines::TakeNames() {
  for (std::size_t role = 0; role < column_.size(); ++role) {
    const auto named = std::ranges::find(cells_, kSampleColumns[role]);
    if (named == cells_.end()) {
      Fail(fmt::format("column '{}' is missing, found {}; expected t, tau, v.",
                       kSampleColumns[role],
                       NamesIn(cells_)));
    }
    if (std::ranges::count(cells_, kSampleColumns[role]) > 1) {
      Fail(fmt::format("column '{}' stands twice, expected once.", kSampleColumns[role]));
    }
    column_[role] = static_cast<std::size_t>(named - cells_.begin());
  }
  num_cells_ = cells_.size();
  for (const std::string_view cell : cells_) {
    if (std::ranges::count(kSampleColumns, cell) == 0) not_read_.emplace_back(Printable(cell));
  }
}

double SampleLines::NumberIn(std::size_t role) const {
  const std::string_view cell = cells_[column_[role]];
  if (const auto number = ParseFiniteNumber(cell)) return *number;
  Fail(
      fmt::format("column '{}' is {}, expected a finite number. Remove the line or repair it "
                  "upstream; this reader does not guess.",
                  kSampleColumns[role],
                  cell.empty() ? "empty" : Quoted(cell)));
}

void SampleLines::RequireRising(double t) const {
  if (!last_stamp_ || t > *last_stamp_) return;
  Fail(fmt::format("column 't' {} from {} to {}, expected rising stamps.",
                   t < *last_stamp_ ? "goes back" : "does not rise",
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
    if (text_.ends_with('\r')) {
      Fail(
          "the line ends in a carriage return, expected a line feed only. Send the stream through "
          "tr -d '\\r'.");
    }
    if (text_.empty() || text_.starts_with('#')) continue;
    SplitSampleLine(text_, &cells_);
    if (!std::exchange(has_first_line_, true) && std::ranges::none_of(cells_, IsNumberCell)) {
      TakeNames();
      continue;
    }
    if (cells_.size() != num_cells_) {
      Fail(fmt::format("the line has {} cells, expected {}.", cells_.size(), num_cells_));
    }
    const SampleLine sample = {NumberIn(0), NumberIn(1), NumberIn(2)};
    RequireRising(sample.t);
    const bool is_passed_over = IsPassedOver(sample);
    last_stamp_ = sample.t;
    if (!is_passed_over) return sample;
  }
  return std::nullopt;
}

}  // namespace fathom
