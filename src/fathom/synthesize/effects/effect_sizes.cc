// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/effects/effect_sizes.h"

#include <cmath>
#include <limits>

namespace fathom {
namespace {

constexpr double kNotDrawn = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<double> DrawSizes(const Effect& effect,
                              Dof dof,
                              Dof partner,
                              const std::array<Scales, 6>& scales,
                              RandomStream& random) {
  const NaturalScales natural = {
      scales[Index(dof)], scales[Index(partner)], scales[Index(Dof::kYaw)]};
  std::vector<double> values;
  for (const EffectParameter& parameter : effect.info().parameters) {
    const SizeRange& range = parameter.drawn;
    const double size = range.smallest * std::pow(range.largest / range.smallest, random.Uniform());
    const double sign = random.Uniform() < 0.5 && range.either_sign ? -1.0 : 1.0;
    values.push_back(range.unit ? sign * size * range.unit(natural) : kNotDrawn);
  }
  return values;
}

}  // namespace fathom
