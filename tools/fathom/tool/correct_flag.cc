// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/correct_flag.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"
#include "fathom/tool/flag_values.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(correct,
              "",
              "Multiply columns of velocity.csv, as p:-1 or p:-1,u:0.5; in place of log.yaml's "
              "correct of the same column.");

namespace fathom {
namespace {

std::optional<Correction> ParseCorrection(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == 0 || colon == std::string_view::npos) return std::nullopt;
  const auto factor = ParseFiniteNumber(text.substr(colon + 1));
  if (!factor || *factor == 0.0) return std::nullopt;
  return Correction{std::string(text.substr(0, colon)), *factor};
}

}  // namespace

std::vector<Correction> CorrectionsFromFlag() {
  std::vector<Correction> corrections;
  for (const std::string& text : SplitAtCommas(FLAGS_correct)) {
    const std::optional<Correction> correction = ParseCorrection(text);
    if (!correction) {
      throw InputError(
          fmt::format("--correct: holds {}, expected column:factor, a factor that is finite and "
                      "not 0, as p:-1.",
                      Quoted(text)));
    }
    if (std::ranges::find(corrections, correction->column, &Correction::column) !=
        corrections.end()) {
      throw InputError(fmt::format("--correct: names {} twice, expected each column once.",
                                   Quoted(correction->column)));
    }
    corrections.push_back(*correction);
  }
  return corrections;
}

}  // namespace fathom
