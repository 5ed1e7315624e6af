// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/parameter_correlation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// "quadratic damping".
std::string PlainName(int index) {
  std::string name = kParameterInfo[static_cast<std::size_t>(index)].name;
  std::ranges::replace(name, '_', ' ');
  return name;
}

// Whether all four have a standard deviation.
bool HasCorrelations(const FittedModel& fitted) {
  const ParameterVector variances = fitted.covariance.diagonal().head<kNumParameters>();
  return variances.allFinite() && (variances.array() > 0.0).all();
}

double Correlation(const FittedModel& fitted, int one, int other) {
  const auto& covariance = fitted.covariance;
  return covariance(one, other) / std::sqrt(covariance(one, one) * covariance(other, other));
}

// "−0.97", and beyond 0.99 "−0.9971": never 1.
std::string Signed(double value) {
  const std::string digits =
      fmt::format("{:.{}f}", std::abs(value), std::abs(value) > 0.99 ? 4 : 2);
  return value < 0.0 && digits != "0.00" ? "−" + digits : digits;
}

}  // namespace

std::optional<Table> CorrelationTable(const FittedModel& fitted) {
  if (!HasCorrelations(fitted)) return std::nullopt;
  Table table;
  table.caption = "Correlation of the parameters";
  table.columns = {{"parameter"}};
  for (int i = 0; i + 1 < kNumParameters; ++i) table.columns.push_back({PlainName(i), true});
  for (int row = 1; row < kNumParameters; ++row) {
    std::vector<std::string> cells = {PlainName(row)};
    for (int column = 0; column + 1 < kNumParameters; ++column) {
      cells.push_back(column < row ? Signed(Correlation(fitted, row, column)) : "");
    }
    table.rows.push_back({std::move(cells)});
  }
  return table;
}

std::string CorrelationSentence(const FittedModel& fitted) {
  if (!HasCorrelations(fitted)) return "";
  std::vector<std::string> pairs;
  for (int one = 0; one < kNumParameters; ++one) {
    for (int other = one + 1; other < kNumParameters; ++other) {
      const double correlation = Correlation(fitted, one, other);
      if (std::abs(correlation) <= kHardlyToldApart) continue;
      pairs.push_back(
          fmt::format("{} and {} ({})", PlainName(one), PlainName(other), Signed(correlation)));
    }
  }
  if (pairs.empty()) {
    return fmt::format(
        "No two parameters are correlated by more than {:.2f}: this log tells them "
        "apart.",
        kHardlyToldApart);
  }
  return fmt::format(
      "This log hardly tells {} apart: what they do together is known better than either alone.",
      fmt::join(pairs, ", nor "));
}

}  // namespace fathom
