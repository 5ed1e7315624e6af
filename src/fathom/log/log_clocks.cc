// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_clocks.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kShortestStep = 1e-5;  // [s]
constexpr double kLongestStep = 10.0;   // [s]

double Duration(const CsvTable& table) {
  return table.stream.time.back() - table.stream.time.front();
}

void RefuseStep(const CsvTable& table, double step) {
  throw InputError(fmt::format(
      "{}: the median step of column 't' is {:.6g}, expected between 1e-5 and 10 seconds. {} "
      "Convert t to seconds.",
      table.name,
      step,
      step > kLongestStep ? "Is it in ms, us or ns?" : "Is it in hours or days?"));
}

}  // namespace

void RefuseStampsThatAreNotSeconds(const CsvTable& command, const CsvTable& motion) {
  const double motion_step = MedianStep(motion.stream.time);
  if (motion_step < kShortestStep || motion_step > kLongestStep) RefuseStep(motion, motion_step);
  const double command_step = MedianStep(command.stream.time);
  const bool is_longer = Duration(command) > 10.0 * Duration(motion);
  if (command_step < kShortestStep || (command_step > kLongestStep && is_longer)) {
    RefuseStep(command, command_step);
  }
}

void RefuseDisjointClocks(const CsvTable& command, const CsvTable& motion) {
  const auto& a = command.stream.time;
  const auto& b = motion.stream.time;
  if (a.front() <= b.back() && b.front() <= a.back()) return;
  throw InputError(fmt::format(
      "{}: column 't' runs from {} to {}, but that of {} from {} to {}, expected some time "
      "in common. Put both on one clock.",
      command.name,
      a.front(),
      a.back(),
      motion.name,
      b.front(),
      b.back()));
}

}  // namespace fathom
