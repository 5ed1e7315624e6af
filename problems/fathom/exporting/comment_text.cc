// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/comment_text.h"

#include "fathom/base/interval95.h"
#include "fathom/base/names_of_dofs.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

std::string IntervalText(double std, const Interval95& interval) {
  if (!std::isfinite(std)) return ", interval not known";
  return fmt::format(", 95 % interval {:.4g} to {:.4g}", interval.low, interval.high);
}

std::string LogText(const std::string& log) { return log.empty() ? "" : ", log " + log; }

}  // namespace

std::string CommentText(std::string_view text) {
  const std::string line = ShownOnOneLine(text);
  std::string safe;
  for (const char c : line) {
    const char last = safe.empty() ? ' ' : safe.back();
    // Comments of C, its trigraphs, comments of XML.
    const bool ends = (last == '*' && c == '/') || (last == '/' && c == '*') ||
                      (last == '?' && c == '?') || (last == '-' && c == '-');
    if (ends) safe += ' ';
    safe += c;
  }
  return safe;
}

std::string LiteralOf(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

Interval95 IntervalOf(const ExportNumber& number) {
  const double half = kStdsOf95 * number.std;
  const double low = number.value - half;
  return {std::max(low, LowerBoundOf(number.entry)), number.value + half};
}

Interval95 IntervalOf(const ExportEffectValue& value) {
  const double half = kStdsOf95 * value.std;
  return {value.value - half, value.value + half};
}

std::string CommentOn(const ExportNumber& number) {
  const std::string interval = IntervalText(number.std, IntervalOf(number));
  return CommentText(number.unit + (number.is_identified ? interval : ", held") +
                     LogText(number.log));
}

std::string CommentOn(const ExportEffectValue& value, const std::string& log) {
  return CommentText(value.unit + IntervalText(value.std, IntervalOf(value)) + LogText(log));
}

std::vector<std::string> HeadLines(const ExportModel& model,
                                   const ExportTarget& target,
                                   const std::vector<std::string>& remarks) {
  std::vector<std::string> lines = {
      fmt::format("{}: a motion model of {}.", target.name, NamesOf(model.model.dofs)),
      fmt::format("Made by {}. Make it anew from the model instead of editing it.", target.origin)};
  for (const std::string& source : model.sources) lines.push_back("From " + source);
  for (const std::string& caveat : model.caveats) {
    lines.push_back("Said when it was fitted: " + caveat);
  }
  for (const std::string& remark : remarks) lines.push_back("Note: " + remark);
  for (std::string& line : lines) line = CommentText(line);
  return lines;
}

}  // namespace fathom
