// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/limit_text.h"

#include "fathom/diagnosis/report/candidate_text.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

bool RulesOutNoEffect(const ExclusionLimit& limit) {
  const double null = limit.effect->info().parameters.front().null;
  return limit.is_told && (limit.low > null || limit.high < null);
}

// "time_offset (refused: gain 54, but free runs do not improve by it)".
std::string WithReason(const Diagnosis& diagnosis, const std::string& label) {
  const auto candidate = std::ranges::find(diagnosis.candidates, label, &Candidate::label);
  if (candidate == diagnosis.candidates.end()) return label;
  return fmt::format("{} ({})", label, WhyText(*candidate));
}

}  // namespace

std::string HowToReadLimits(const Diagnosis& diagnosis) {
  std::string text =
      "The values of effects that are not named and that these logs rule out, 95 % each. Any other "
      "value may be there: a weaker effect, such as a shorter lag or a higher saturation. Effects "
      "of "
      "several parameters are not listed.";
  std::vector<std::string> without_null;
  for (const ExclusionLimit& limit : diagnosis.limits) {
    if (RulesOutNoEffect(limit)) without_null.push_back(WithReason(diagnosis, limit.label));
  }
  if (without_null.empty()) return text;
  return text + fmt::format(
                    " Some rows rule out 'no effect' as well: taken alone, the effect fits better "
                    "than none. One row in twenty does so by chance, and more do where the model "
                    "lacks something else. None of them is named: {}.",
                    fmt::join(without_null, "; "));
}

}  // namespace fathom
