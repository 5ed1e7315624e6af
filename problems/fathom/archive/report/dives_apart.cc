// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/dives_apart.h"

#include "fathom/archive/store/compared_dofs.h"
#include "fathom/base/interval95.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// Root mean square of the distances from the mean in standard deviations, from which on it is no
// matter of wrong intervals. Dives that agree have 1; at 12 dives 1.5 is rare.
constexpr double kFarApart = 3.0;

constexpr std::size_t kMostGroups = 6;  // told one by one

using Fits = std::vector<const DiveFitRow*>;

double WeightedMean(const Fits& fits) {
  double weights = 0.0, sum = 0.0;
  for (const DiveFitRow* fit : fits) {
    const double weight = 1.0 / (fit->std * fit->std);
    weights += weight;
    sum += weight * fit->value;
  }
  return sum / weights;
}

// Birge's ratio: 1 where the scatter is that of the intervals.
double RatioOfScatter(const Fits& fits) {
  const double mean = WeightedMean(fits);
  double sum = 0.0;
  for (const DiveFitRow* fit : fits) sum += std::pow((fit->value - mean) / fit->std, 2);
  return std::sqrt(sum / static_cast<double>(fits.size() - 1));
}

// By value; a new group begins where a value is off the one before for certain (95 %).
std::vector<Fits> Groups(Fits fits) {
  std::stable_sort(fits.begin(), fits.end(), [](const DiveFitRow* a, const DiveFitRow* b) {
    return a->value < b->value;
  });
  std::vector<Fits> groups;
  for (const DiveFitRow* fit : fits) {
    const DiveFitRow* before = groups.empty() ? nullptr : groups.back().back();
    if (before == nullptr ||
        fit->value - before->value > kStdsOf95 * std::hypot(fit->std, before->std)) {
      groups.emplace_back();
    }
    groups.back().push_back(fit);
  }
  return groups;
}

std::string GroupText(Fits group) {
  std::vector<std::string> dives;
  for (const DiveFitRow* fit : group) dives.push_back(fit->dive);
  std::ranges::sort(dives);
  return fmt::format("{:.3g} in {}", WeightedMean(group), fmt::join(dives, ", "));
}

std::string SentenceOf(const Fits& fits) {
  const auto [low, high] = std::minmax_element(
      fits.begin(), fits.end(), [](const auto* a, const auto* b) { return a->value < b->value; });
  const auto [sure, unsure] = std::minmax_element(
      fits.begin(), fits.end(), [](const auto* a, const auto* b) { return a->std < b->std; });
  std::string name = fits.front()->parameter;
  std::ranges::replace(name, '_', ' ');
  std::string text = fmt::format(
      "The dives differ by far more than their intervals: {} in {} lies between {:.3g} and {:.3g} "
      "{}, "
      "at ± {:.2g} to {:.2g}.",
      name,
      fits.front()->dof,
      (*low)->value,
      (*high)->value,
      UnitText(fits.front()->unit),
      kStdsOf95 * (*sure)->std,
      kStdsOf95 * (*unsure)->std);
  const std::vector<Fits> groups = Groups(fits);
  if (groups.size() > 1 && groups.size() <= kMostGroups) {
    std::vector<std::string> parts;
    for (const Fits& group : groups) parts.push_back(GroupText(group));
    text += fmt::format(" Together stand: {}.", fmt::join(parts, "; "));
  }
  return text + " One model for all of them is wrong for most.";
}

}  // namespace

std::string DivesApartSentence(const Tables& tables, const std::string& vehicle) {
  std::map<std::pair<std::string, std::string>, Fits> by_parameter;
  const std::string coupled = CoupledDofsCompared(tables.dive_fits, vehicle);
  for (const DiveFitRow& row : tables.dive_fits) {
    if (!AreCompared(row.dof, coupled)) continue;
    if (row.vehicle != vehicle || !row.usable || !(row.std > 0.0) || !std::isfinite(row.value)) {
      continue;
    }
    by_parameter[{row.dof, row.parameter}].push_back(&row);
  }
  for (const ChangeRow& change : tables.changes) {
    if (change.vehicle == vehicle) by_parameter.erase({change.dof, change.parameter});
  }
  const Fits* farthest = nullptr;
  double ratio = kFarApart;
  for (const auto& [key, fits] : by_parameter) {
    if (fits.size() < kFewestDivesForChange) continue;
    const double own = RatioOfScatter(fits);
    if (own > ratio) {
      ratio = own;
      farthest = &fits;
    }
  }
  return farthest == nullptr ? "" : SentenceOf(*farthest);
}

}  // namespace fathom
