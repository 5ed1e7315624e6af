// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/training_data.h"
#include "fathom/vehicle/effect_parameter.h"

namespace fathom {

struct ParameterBounds {
  double lower, upper;
};

// Of a physical value of an effect's parameter that these data can tell: the parameter's own; a
// force that is there at rest within the greatest command, since otherwise nothing would ever have
// moved, or everything; and the offset of a clock within TrainingData::most_offset().
ParameterBounds BoundsOf(const EffectParameter& parameter, const TrainingData& data);

}  // namespace fathom
