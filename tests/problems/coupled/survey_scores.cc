// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The figures of docs/fins.md on drawn survey AUVs: survey_scores
// fits|none|dead|stuck|neutral|slow|limited|stalled 30.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "side_by_side.h"
#include "survey_auv.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr int kThreads = 2;

void PrintFits(std::size_t count) {
  std::vector<SurveyFit> fits(count);
  SideBySide(
      count, kThreads, [&](std::size_t k) { fits[k] = FitSurvey(static_cast<unsigned>(k + 1)); });
  int num_numbers = 0, num_covered = 0, num_near = 0;
  double worst = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    if (!fits[k].is_usable) fmt::print("fit {}: {}\n", k + 1, fits[k].message);
    num_numbers += fits[k].num_numbers;
    num_covered += fits[k].num_covered;
    if (fits[k].is_usable && fits[k].miss_ratio < 1.1) ++num_near;
    worst = std::max(worst, fits[k].miss_ratio);
  }
  fmt::print("intervals of 95 %: {} of {} numbers covered\n", num_covered, num_numbers);
  fmt::print("unseen manoeuvres: {} of {} within 1.1 of the true model, at most {:.3f}\n",
             num_near,
             count,
             worst);
}

void PrintNamings(FinFault fault, const char* name, std::size_t count) {
  std::vector<SurveyNaming> namings(count);
  SideBySide(count, kThreads, [&](std::size_t k) {
    namings[k] = NameFault(static_cast<unsigned>(k + 1), fault);
    fmt::print("  {} {}: {} (or {}), {:.4g} +- {:.2g}\n",
               name,
               k + 1,
               fmt::join(namings[k].named, ", "),
               fmt::join(namings[k].not_told_apart, ", "),
               namings[k].value,
               namings[k].std);
    std::fflush(stdout);
  });
  int num_right = 0, num_false = 0;
  for (const SurveyNaming& naming : namings) {
    if (naming.is_right) ++num_right;
    if (naming.num_false > 0) ++num_false;
  }
  fmt::print("{}: named in {} of {}, something false in {}\n", name, num_right, count, num_false);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  using namespace fathom;
  const std::string what = argc > 1 ? argv[1] : "fits";
  const std::size_t count = argc > 2 ? static_cast<std::size_t>(std::atoi(argv[2])) : 30;
  if (what == "fits") PrintFits(count);
  for (const auto& [fault, name] : {std::pair{FinFault::kNone, "none"},
                                    {FinFault::kDead, "dead"},
                                    {FinFault::kStuck, "stuck"},
                                    {FinFault::kNeutral, "neutral"},
                                    {FinFault::kSlow, "slow"},
                                    {FinFault::kLimited, "limited"},
                                    {FinFault::kStalled, "stalled"}}) {
    if (what == name) PrintNamings(fault, name, count);
  }
  return 0;
}
