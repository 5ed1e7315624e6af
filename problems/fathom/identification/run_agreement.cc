// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/run_agreement.h"

#include "fathom/base/chi_square.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace fathom {
namespace {

constexpr double kBroken = 0.01;        // p-value
constexpr double kFarApart = 4.0;       // standard deviations of what the others scatter by
constexpr std::size_t kFewestRuns = 4;  // of which one may stand apart

struct Value {
  double value = 0.0;
  double variance = 0.0;
  std::size_t run = 0;
};

std::vector<Value> ValuesOf(const std::vector<RunEstimate>& runs, int parameter) {
  std::vector<Value> values;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const double std = runs[k].std[parameter];
    if (!runs[k].is_usable || !(std > 0.0) || !std::isfinite(std)) continue;
    values.push_back({runs[k].value[parameter], std * std, k});
  }
  return values;
}

struct Pooled {
  double mean = 0.0, variance = 0.0, chi_squared = 0.0;
};

Pooled PoolOf(std::span<const Value> values) {
  double weights = 0.0, sum = 0.0;
  for (const Value& one : values) {
    weights += 1.0 / one.variance;
    sum += one.value / one.variance;
  }
  Pooled pooled = {.mean = sum / weights, .variance = 1.0 / weights};
  for (const Value& one : values) {
    const double apart = one.value - pooled.mean;
    pooled.chi_squared += apart * apart / one.variance;
  }
  return pooled;
}

Spread SpreadOf(std::span<const Value> values) {
  Spread spread;
  if (values.size() < 2) return spread;
  spread.freedom = static_cast<int>(values.size()) - 1;
  const Pooled pooled = PoolOf(values);
  spread.chi_squared = pooled.chi_squared;
  spread.mean_std = std::sqrt(pooled.variance);
  spread.p_value = ChiSquareTail(spread.chi_squared, spread.freedom);
  spread.widening = std::max(1.0, std::sqrt(spread.chi_squared / spread.freedom));
  return spread;
}

// How far each value is from the others, by what these scatter by.
double DistanceFromOthers(std::span<const Value> values, std::size_t index) {
  std::vector<Value> others(values.begin(), values.end());
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(index));
  const Pooled pooled = PoolOf(others);
  const double scatter = std::max(1.0, pooled.chi_squared / static_cast<double>(others.size() - 1));
  const double variance = scatter * (values[index].variance + pooled.variance);
  return std::abs(values[index].value - pooled.mean) / std::sqrt(variance);
}

}  // namespace

double Spread::WideningOf(double std) const {
  if (freedom == 0 || !(std > 0.0)) return 1.0;
  return std::clamp(widening * mean_std / std, 1.0, widening);
}

RunAgreement AgreementOf(std::vector<RunEstimate> runs) {
  RunAgreement agreement;
  agreement.runs = std::move(runs);
  double farthest = kFarApart;
  for (int parameter = 0; parameter < kNumParameters; ++parameter) {
    const std::vector<Value> values = ValuesOf(agreement.runs, parameter);
    Spread& spread = agreement.spreads[parameter];
    spread = SpreadOf(values);
    if (values.size() < kFewestRuns || spread.p_value >= kBroken) continue;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double distance = DistanceFromOthers(values, k);
      if (distance <= farthest) continue;
      farthest = distance;
      agreement.stands_apart = agreement.runs[values[k].run].log;
      agreement.parameter_apart = parameter;
    }
  }
  return agreement;
}

}  // namespace fathom
