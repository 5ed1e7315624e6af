// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/files/json_value.h"

#include <map>
#include <string>
#include <vector>

namespace fathom {

// An effect along `dof` with its setting, without its values; other keys may stand beside.
ActiveEffect ReadSetEffect(const JsonValue& json, Dof dof);

// The effects that a model file lists under structure.effects, without their values.
std::vector<ActiveEffect> ReadEffects(const JsonValue& structure, Dof dof);

// The effects that are the causes of a verdict, in the order in which they act. `values`: of their
// parameters, by KeyOf(). Refuses a unit that is not the parameter's.
std::vector<ActiveEffect> ReadCauses(const JsonValue& causes,
                                     Dof dof,
                                     const std::string& force_unit,
                                     std::map<std::string, double>* values);

// A number of a file with its standard deviation, NaN where it is not known.
struct ParameterEntry {
  double value = 0.0;
  double std = 0.0;
};

// {"value", "std", "unit"}, the latter two optional. Throws InputError for a negative deviation,
// and for another unit than this.
ParameterEntry ReadParameter(const JsonValue& json, const std::string& unit);

}  // namespace fathom
