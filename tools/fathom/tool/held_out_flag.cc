// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/held_out_flag.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"
#include "fathom/tool/flag_values.h"

#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(
    held_out,
    "",
    "Do not train on these seconds of the log, as 240:300 or 100:120,240:300; in place of "
    "log.yaml's held_out.");

namespace fathom {
namespace {

std::optional<TimeInterval> ParseInterval(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto from = ParseFiniteNumber(text.substr(0, colon));
  const auto to = ParseFiniteNumber(text.substr(colon + 1));
  if (!from || !to || !(*from < *to)) return std::nullopt;
  return TimeInterval{.from = *from, .to = *to};
}

}  // namespace

std::vector<TimeInterval> HeldOutFromFlag() {
  std::vector<TimeInterval> intervals;
  for (const std::string& text : SplitAtCommas(FLAGS_held_out)) {
    const std::optional<TimeInterval> interval = ParseInterval(text);
    if (!interval) {
      throw InputError(fmt::format(
          "--held_out: holds {}, expected from:to in seconds, from before to, as 240:300.",
          Quoted(text)));
    }
    intervals.push_back(*interval);
  }
  return intervals;
}

}  // namespace fathom
