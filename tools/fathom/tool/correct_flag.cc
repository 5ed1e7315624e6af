// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/correct_flag.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"
#include "fathom/tool/flag_values.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(correct,
              "",
              "Put columns of velocity.csv right: multiply them, as p:-1, or read them off later, "
              "as u:0.25s where they come 0.25 s late; in place of log.yaml's correct and late of "
              "the same column.");

namespace fathom {
namespace {

// Takes "p:-1" or "u:0.25s" in. False if the text is neither.
bool TakeIn(std::string_view text, std::vector<Correction>* corrections) {
  const std::size_t colon = text.find(':');
  if (colon == 0 || colon == std::string_view::npos) return false;
  const std::string column(text.substr(0, colon));
  std::string_view amount = text.substr(colon + 1);
  const bool is_time = amount.ends_with('s');
  if (is_time) amount.remove_suffix(1);
  const auto number = ParseFiniteNumber(amount);
  if (!number || *number == 0.0) return false;
  auto correction = std::ranges::find(*corrections, column, &Correction::column);
  if (correction == corrections->end()) {
    correction = corrections->insert(corrections->end(), Correction{column});
  }
  double& value = is_time ? correction->late : correction->factor;
  if (value != (is_time ? 0.0 : 1.0)) {
    throw InputError(
        fmt::format("--correct: names {} twice, expected each column once.", Quoted(column)));
  }
  value = *number;
  return true;
}

}  // namespace

std::vector<Correction> CorrectionsFromFlag() {
  std::vector<Correction> corrections;
  for (const std::string& text : SplitAtCommas(FLAGS_correct)) {
    if (TakeIn(text, &corrections)) continue;
    throw InputError(
        fmt::format("--correct: holds {}, expected column:factor, a factor that is finite and not "
                    "0, as p:-1, or column:seconds, as u:0.25s.",
                    Quoted(text)));
  }
  return corrections;
}

}  // namespace fathom
