// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/legend.h"

#include "fathom/diagnosis/report/verdict_sentence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kWords = {{
    {"score", "twice the log-likelihood that the effect gains alone, by a quick estimate"},
    {"p-value",
     "how often noise alone would gain as much if nothing were missing (the refitted gain; "
     "the score where there is none)"},
    {"gain, refitted", "the same, fitted in full"},
    {"evidence (BIC)", "what the fit gains, less a price for each parameter; above 10 is strong"},
}};

bool Has(const Table& table, std::string_view heading) {
  return std::ranges::any_of(table.columns,
                             [&](const TableColumn& column) { return column.heading == heading; });
}

bool NamesFreeRuns(const Table& table) {
  return std::ranges::any_of(table.rows, [](const TableRow& row) {
    return std::ranges::any_of(row.cells, [](const std::string& cell) {
      return cell.find("free runs") != std::string::npos;
    });
  });
}

}  // namespace

std::string LegendOf(std::span<const Table> tables) {
  std::string legend;
  for (const auto& [heading, words] : kWords) {
    if (!std::ranges::any_of(tables, [&](const Table& table) { return Has(table, heading); })) {
      continue;
    }
    legend += fmt::format("{}: {}\n", heading, words);
  }
  if (std::ranges::any_of(tables, NamesFreeRuns)) {
    legend += "free run: the model simulated from the command alone\n";
  }
  return legend;
}

std::string NoiseFloorText(const Diagnosis& diagnosis) {
  if (!std::isfinite(diagnosis.noise_nmae)) return "";
  return fmt::format(
      "noise alone (the scatter from sample to sample) gives a {} NMAE of about {:.2g}{}\n",
      FittedQuantity(diagnosis),
      diagnosis.noise_nmae,
      diagnosis.extended.held_out.nmae <= diagnosis.noise_nmae
          ? ": the error of this model is no more than noise"
          : "");
}

}  // namespace fathom
