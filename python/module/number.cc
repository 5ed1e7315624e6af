// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "module/number.h"

#include "fathom/base/interval95.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {

namespace {

double DeviationAt(const Eigen::MatrixXd& covariance, Eigen::Index i) {
  return i < covariance.rows() ? std::sqrt(covariance(i, i))
                               : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::pair<double, double> IdentifiedNumber::Interval() const {
  const double half_width = kStdsOf95 * std;
  if (std::isnan(half_width)) return {half_width, half_width};
  return {std::max(value - half_width, std::min(value, lower)),
          std::min(value + half_width, std::max(value, upper))};
}

std::string IdentifiedNumber::Text() const {
  const std::string shown = unit == "-" ? "" : UnitText(unit);
  return fmt::format("{} = {}{}{}", name, FormatValue(value, std), shown.empty() ? "" : " ", shown);
}

std::vector<IdentifiedNumber> NumbersOf(const FittedModel& model) {
  std::vector<IdentifiedNumber> numbers;
  const ParameterVector values = ToVector(model.model);
  for (int i = 0; i < kNumParameters; ++i) {
    numbers.push_back({kParameterInfo[i].name,
                       values[i],
                       DeviationAt(model.covariance, i),
                       ParameterUnit(i, model.dof, model.force_unit),
                       kParameterInfo[i].lower_bound});
  }
  for (std::size_t k = 0; k < model.effects.size(); ++k) {
    for (IdentifiedNumber& number : NumbersOfEffect(model, k)) numbers.push_back(std::move(number));
  }
  return numbers;
}

std::vector<IdentifiedNumber> NumbersOfEffect(const FittedModel& model, std::size_t index) {
  Eigen::Index at = kNumParameters;
  for (std::size_t k = 0; k < index; ++k) {
    at += static_cast<Eigen::Index>(model.effects[k].values.size());
  }
  const ActiveEffect& active = model.effects[index];
  std::vector<IdentifiedNumber> numbers;
  for (std::size_t k = 0; k < active.values.size(); ++k) {
    const EffectParameter& parameter = active.effect->info().parameters[k];
    numbers.push_back({KeyOf(active, parameter),
                       active.values[k],
                       DeviationAt(model.covariance, at + static_cast<Eigen::Index>(k)),
                       UnitOf(parameter.quantity, model.dof, model.force_unit),
                       parameter.lower,
                       parameter.upper});
  }
  return numbers;
}

std::vector<IdentifiedNumber> NumbersOf(const FittedCoupledModel& model) {
  std::vector<IdentifiedNumber> numbers;
  for (std::size_t k = 0; k < model.entries.size(); ++k) {
    const FreeEntry& entry = model.entries[k];
    numbers.push_back({NameOf(entry),
                       ValueIn(model.model, entry),
                       DeviationAt(model.covariance, static_cast<Eigen::Index>(k)),
                       UnitOf(entry, model.force_unit),
                       LowerBoundOf(entry)});
  }
  return numbers;
}

pybind11::dict DictOf(const std::vector<IdentifiedNumber>& numbers) {
  pybind11::dict dict;
  for (const IdentifiedNumber& number : numbers) dict[pybind11::str(number.name)] = number;
  return dict;
}

}  // namespace fathom
