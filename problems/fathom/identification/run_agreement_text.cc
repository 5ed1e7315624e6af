// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/run_agreement_text.h"

#include "fathom/report/format_value.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kWorthTelling = 1.2;  // of a widening
constexpr double kDisagree = 0.0025;   // p-value: of four parameters one in a hundred

std::string NameOf(int parameter) {
  std::string name(kParameterInfo[parameter].name);
  std::ranges::replace(name, '_', ' ');
  return name;
}

}  // namespace

Table RunTable(const RunAgreement& agreement, Dof dof, const std::string& force_unit) {
  Table table;
  table.columns = {{"run alone"}};
  for (int i = 0; i < kNumParameters; ++i) {
    table.columns.push_back(
        {fmt::format("{} [{}]", NameOf(i), UnitText(ParameterUnit(i, dof, force_unit))), true, i});
  }
  for (const RunEstimate& run : agreement.runs) {
    TableRow row;
    row.cells = {run.log};
    for (int i = 0; i < kNumParameters; ++i) {
      row.cells.push_back(run.is_usable ? FormatValue(run.value[i], run.std[i]) : "-");
    }
    table.rows.push_back(std::move(row));
  }
  TableRow last;
  last.cells = {"chi-square / degrees of freedom"};
  for (const Spread& spread : agreement.spreads) {
    last.cells.push_back(
        spread.freedom > 0 ? fmt::format("{:.3g} / {}", spread.chi_squared, spread.freedom) : "-");
  }
  table.rows.push_back(std::move(last));
  return table;
}

std::vector<std::string> RemarksOn(const RunAgreement& agreement, const ParameterVector& widening) {
  std::vector<std::string> remarks;
  std::vector<std::string> widened;
  for (int i = 0; i < kNumParameters; ++i) {
    if (widening[i] >= kWorthTelling) {
      const int decimals = widening[i] < 9.95 ? 1 : 0;
      widened.push_back(fmt::format("{} by a factor of {:.{}f}", NameOf(i), widening[i], decimals));
    }
  }
  if (!widened.empty()) {
    remarks.push_back(
        fmt::format("The runs differ by more than their own intervals say. The intervals of all "
                    "runs together are widened: {}.",
                    fmt::join(widened, ", ")));
  }
  std::vector<std::string> disagreeing;
  for (int i = 0; i < kNumParameters; ++i) {
    const Spread& spread = agreement.spreads[i];
    if (spread.freedom > 0 && spread.p_value < kDisagree) disagreeing.push_back(NameOf(i));
  }
  if (widened.empty() && !disagreeing.empty()) {
    remarks.push_back(
        fmt::format("The runs disagree on the {}, each by itself: one vehicle would give such "
                    "values less than once in 400. Look at what was different.",
                    fmt::join(disagreeing, " and the ")));
  }
  if (!agreement.stands_apart.empty()) {
    remarks.push_back(
        fmt::format("{} stands apart from the others in its {}: look at what was "
                    "different, or leave it out.",
                    agreement.stands_apart,
                    NameOf(agreement.parameter_apart)));
  }
  return remarks;
}

}  // namespace fathom
