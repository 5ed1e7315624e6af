// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/legend.h"

#include "fathom/diagnosis/report/verdict_sentence.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kWords = {{
    {"score", "twice the log-likelihood that the effect gains alone, by a quick estimate"},
    {"p-value", "how often noise alone would score as well if nothing were missing"},
    {"gain, refitted", "the same, fitted in full"},
    {"evidence (BIC)", "what the fit gains, less a price for each parameter; above 10 is strong"},
}};

}  // namespace

std::string LegendOf(std::string_view tables) {
  std::string legend;
  for (const auto& [heading, words] : kWords) {
    if (tables.find(heading) == std::string_view::npos) continue;
    legend += fmt::format("{}: {}\n", heading, words);
  }
  return legend;
}

std::string NoiseFloorText(const Diagnosis& diagnosis) {
  if (!std::isfinite(diagnosis.noise_nmae)) return "";
  return fmt::format(
      "noise alone (the scatter from sample to sample) gives a {} NMAE of about {:.2g}\n",
      FittedQuantity(diagnosis),
      diagnosis.noise_nmae);
}

}  // namespace fathom
