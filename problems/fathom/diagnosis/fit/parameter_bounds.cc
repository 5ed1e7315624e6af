// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/parameter_bounds.h"

#include <algorithm>
#include <limits>

namespace fathom {
namespace {

bool IsForceAtRest(const EffectParameter& parameter) {
  const Quantity& quantity = parameter.quantity;
  return parameter.null == 0.0 && quantity.force == 1.0 && quantity.speed == 0.0 &&
         quantity.time == 0.0;
}

// A duration that may be negative.
bool IsOffset(const EffectParameter& parameter) {
  const Quantity& quantity = parameter.quantity;
  return quantity.time == 1.0 && quantity.force == 0.0 && quantity.speed == 0.0 &&
         parameter.lower < 0.0;
}

}  // namespace

ParameterBounds BoundsOf(const EffectParameter& parameter, const TrainingData& data) {
  const double most = IsForceAtRest(parameter) ? data.most_force()
                      : IsOffset(parameter)    ? data.most_offset()
                                               : std::numeric_limits<double>::infinity();
  return {std::max(parameter.lower, -most), std::min(parameter.upper, most)};
}

}  // namespace fathom
