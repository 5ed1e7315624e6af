// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/known_parameters.h"

#include "fathom/base/interval95.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

// What the interval of a parameter is held against. A buoyancy may well be 0: its size is the
// greatest force of the command, as docs/plan.md has it.
double SizeOf(const FittedModel& model, int index) {
  const double value = std::abs(ToVector(model.model)[index]);
  if (index != kBuoyancy || !model.range) return value;
  const ValueRange& force = model.range->force;
  return std::max({value, std::abs(force.low), std::abs(force.high)});
}

// How well the interval leaves a parameter of this size known.
std::string_view HowWellKnown(double size, double std) {
  constexpr double kWell = 0.2, kRoughly = 1.0;
  const double share = kStdsOf95 * std / size;
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
      HowWellKnown(SizeOf(model.fitted, index),
                   model.std_with_delay ? std::max(std, (*model.std_with_delay)[index]) : std);
  return known != "not" && IsBiased(checkup, dof) ? "in doubt" : known;
}

}  // namespace fathom
