// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/moved_parameter.h"

#include "fathom/base/interval95.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace fathom {
namespace {

// RMS of what each parameter of the baseline multiplies, over the extended model's free runs (which
// hold no noise): acceleration, v|v|, v, 1.
std::array<double, kNumParameters> Loads(const Diagnosis& diagnosis) {
  std::array<double, kNumParameters> sums = {};
  double count = 0.0;
  for (const ResidualTrace& trace : diagnosis.traces) {
    std::vector<double> v = trace.after;
    std::vector<double> time = trace.time;
    const auto differentiate = [&](const std::vector<double>& values) {
      std::vector<double> slopes;
      for (std::size_t i = 1; i < values.size(); ++i) {
        slopes.push_back((values[i] - values[i - 1]) / (time[i] - time[i - 1]));
      }
      return slopes;
    };
    if (!diagnosis.has_velocity) v = differentiate(v);
    if (v.size() < time.size()) time.erase(time.begin());
    const std::vector<double> slopes = differentiate(v);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      const std::array<double, kNumParameters> loads = {slopes[i], v[i] * v[i], v[i], 1.0};
      for (int k = 0; k < kNumParameters; ++k) sums[k] += loads[k] * loads[k];
      count += 1.0;
    }
  }
  for (double& sum : sums) sum = count > 0.0 ? std::sqrt(sum / count) : 0.0;
  return sums;
}

}  // namespace

std::string WhatMoves(const Diagnosis& diagnosis) {
  const ParameterVector before = ToVector(diagnosis.baseline.model.baseline);
  const ParameterVector after = ToVector(diagnosis.extended.model.baseline);
  const std::array<double, kNumParameters> loads = Loads(diagnosis);
  const auto std_of = [](const DiagnosedModel& model, int i) {
    return i < model.covariance.rows() ? std::sqrt(model.covariance(i, i))
                                       : std::numeric_limits<double>::quiet_NaN();
  };
  int most = -1;
  double most_force = 0.0;
  for (int i = 0; i < kNumParameters; ++i) {
    const double way = std::abs(after[i] - before[i]);
    if (!(way > kStdsOf95 * std_of(diagnosis.extended, i))) continue;
    if (way * loads[i] > most_force) {
      most = i;
      most_force = way * loads[i];
    }
  }
  if (most < 0) return "";
  // No finer than a thousandth: what counts is how far it moves.
  const double finest = 1e-3 * std::max(std::abs(before[most]), std::abs(after[most]));
  const int decimals = DecimalsFor(std::max(kStdsOf95 * std_of(diagnosis.extended, most), finest));
  std::string name(kParameterInfo[most].name);
  std::replace(name.begin(), name.end(), '_', ' ');
  return fmt::format("the {} changes from {} to {} {}",
                     name,
                     RoundedAt(before[most], decimals),
                     RoundedAt(after[most], decimals),
                     UnitText(ParameterUnit(most, diagnosis.dof, diagnosis.force_unit)));
}

}  // namespace fathom
