// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/known_parameters.h"

#include "fathom/base/interval95.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

// How well the interval leaves a value known.
std::string_view HowWellKnown(double value, double std) {
  constexpr double kWell = 0.2, kRoughly = 1.0;
  const double share = kStdsOf95 * std / std::abs(value);
  if (share <= kWell) return "well";
  return share <= kRoughly ? "roughly" : "not";
}

}  // namespace

double StdOf(const FittedModel& model, int index) {
  return std::sqrt(model.covariance(index, index));
}

bool IsBiased(const LogCheckup& checkup, const DofCheckup& dof) {
  return HasRed(checkup) || Has(dof.findings, "other_axes");
}

std::string_view HowWellKnown(const LogCheckup& checkup, const DofCheckup& dof, int index) {
  const Identification& model = *dof.model;
  const double std = StdOf(model.fitted, index);
  const std::string_view known =
      HowWellKnown(ToVector(model.fitted.model)[index],
                   model.std_with_delay ? std::max(std, (*model.std_with_delay)[index]) : std);
  return known != "not" && IsBiased(checkup, dof) ? "in doubt" : known;
}

}  // namespace fathom
