// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/fitted_coupled_model.h"
#include "fathom/vehicle/fitted_model.h"

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

namespace fathom {

// A number that was identified, as Python sees it: fathom.Parameter.
struct IdentifiedNumber {
  std::string name;
  double value = std::numeric_limits<double>::quiet_NaN();
  double std = std::numeric_limits<double>::quiet_NaN();
  std::string unit;
  double lower = -std::numeric_limits<double>::infinity();  // bounds of a physical value
  double upper = std::numeric_limits<double>::infinity();

  // 95 %; does not pass the bounds unless the value itself does. NaN where the deviation is not
  // known.
  std::pair<double, double> Interval() const;

  // "inertia = 890.3 ± 4.2 kg"
  std::string Text() const;
};

// Of the baseline, then of the effects, by the names of model files.
std::vector<IdentifiedNumber> NumbersOf(const FittedModel& model);
std::vector<IdentifiedNumber> NumbersOf(const FittedCoupledModel& model);

// Of the effect `index` of a model.
std::vector<IdentifiedNumber> NumbersOfEffect(const FittedModel& model, std::size_t index);

// By name, in their order.
pybind11::dict DictOf(const std::vector<IdentifiedNumber>& numbers);

}  // namespace fathom
