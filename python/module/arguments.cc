// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "module/arguments.h"

#include "fathom/base/quoted.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace fathom {

std::vector<TimeInterval> HeldOutOf(const Pairs& pairs) {
  std::vector<TimeInterval> intervals;
  for (const auto& [from, to] : pairs) {
    if (!std::isfinite(from) || !std::isfinite(to) || !(from < to)) {
      throw InputError(fmt::format(
          "held_out: holds ({}, {}), expected (from, to) in seconds, from before to.", from, to));
    }
    intervals.push_back({.from = from, .to = to});
  }
  return intervals;
}

std::vector<Correction> CorrectionsOf(const NumberByColumn& correct, const NumberByColumn& late) {
  std::map<std::string, Correction> corrections;
  for (const auto& [column, factor] : correct) {
    if (!std::isfinite(factor) || factor == 0.0) {
      throw InputError(fmt::format(
          "correct: {} by {}, expected a finite factor other than 0.", Quoted(column), factor));
    }
    corrections[column].factor = factor;
  }
  for (const auto& [column, seconds] : late) {
    if (!std::isfinite(seconds)) {
      throw InputError(fmt::format("late: {} by {}, expected seconds.", Quoted(column), seconds));
    }
    corrections[column].late = seconds;
  }
  std::vector<Correction> all;
  for (auto& [column, correction] : corrections) {
    correction.column = column;
    all.push_back(correction);
  }
  return all;
}

std::string HeldOutText(const Pairs& pairs) {
  std::string text;
  for (const auto& [from, to] : pairs) {
    text += fmt::format("{}{}:{}", text.empty() ? "" : ",", from, to);
  }
  return text;
}

double InfiniteIfZero(const std::string& argument, double value) {
  if (!(value >= 0.0)) {
    throw InputError(
        fmt::format("{}: is {}, expected 0 (never) or a number above.", argument, value));
  }
  return value == 0.0 ? std::numeric_limits<double>::infinity() : value;
}

}  // namespace fathom
