// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/parameters.h"

namespace fathom {

ParameterVector ToVector(const UncoupledModel<double>& model) {
  return {model.inertia, model.quadratic_damping, model.linear_damping, model.buoyancy};
}

UncoupledModel<double> ModelFromVector(const ParameterVector& parameters) {
  return {parameters[kInertia],
          parameters[kQuadraticDamping],
          parameters[kLinearDamping],
          parameters[kBuoyancy]};
}

std::string ParameterUnit(int index, Dof dof, const std::string& force_unit) {
  constexpr std::array<const char*, kNumParameters> kLinear = {"kg", "kg/m", "kg/s", "N"};
  constexpr std::array<const char*, kNumParameters> kAngular = {
      "kg m^2", "kg m^2", "kg m^2/s", "N m"};
  if (force_unit == ForceUnit(dof)) return IsAngular(dof) ? kAngular[index] : kLinear[index];
  constexpr std::array<const char*, kNumParameters> kPerMetre = {" s^2/m", " s^2/m^2", " s/m", ""};
  constexpr std::array<const char*, kNumParameters> kPerRadian = {
      " s^2/rad", " s^2/rad^2", " s/rad", ""};
  return force_unit + (IsAngular(dof) ? kPerRadian[index] : kPerMetre[index]);
}

}  // namespace fathom
