// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/experiments.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

bool HasConfusion(const Suspect& suspect, const Confusion* confusion) {
  const auto& confusions = suspect.effect->info().confusions;
  return std::find(confusions.begin(), confusions.end(), confusion) != confusions.end();
}

}  // namespace

DecidingRun DecidingExperiment(const Suspect& cause, const std::vector<Suspect>& rivals) {
  std::vector<std::string_view> experiments;
  bool any_decides = true;  // as the first of them says
  for (const Confusion* confusion : cause.effect->info().confusions) {
    const bool decides = std::any_of(rivals.begin(), rivals.end(), [&](const Suspect& rival) {
      return HasConfusion(rival, confusion);
    });
    const bool is_new = std::find(experiments.begin(), experiments.end(), confusion->experiment) ==
                        experiments.end();
    if (!decides || !is_new) continue;
    if (experiments.empty()) any_decides = confusion->decides;
    experiments.push_back(confusion->experiment);
  }
  if (!experiments.empty()) {
    return {fmt::format("{}", fmt::join(experiments, " ")), any_decides};
  }
  const bool has_partner = cause.effect->info().has_partner() ||
                           std::any_of(rivals.begin(), rivals.end(), [](const Suspect& rival) {
                             return rival.effect->info().has_partner();
                           });
  if (has_partner) {
    return {
        "A run in which the other DOF moves without being commanded, and is commanded without "
        "this one."};
  }
  // Of a run and of the vehicle: the same run again tells. Among rivals of the vehicle it does not,
  // and any other run rids of those of this run too.
  const auto is_of_run = [](const Suspect& suspect) {
    return suspect.effect->info().scope == Scope::kRun;
  };
  if (is_of_run(cause) || std::all_of(rivals.begin(), rivals.end(), is_of_run)) {
    return {"The same experiment again: an effect of this run only will be gone."};
  }
  return {
      "A multisine from slow to fast with steps of several sizes both ways (10 s square wave, "
      "0.1 to 1.5 rad/s)."};
}

}  // namespace fathom
