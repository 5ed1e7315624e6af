// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <array>
#include <limits>
#include <string>

#include <Eigen/Core>

namespace fathom {

// What every other part needs to know about one identified number of the uncoupled model. Bounds,
// reports and file formats are built from this table.
struct ParameterInfo {
  const char* name;     // as in files and reports: "linear_damping"
  const char* meaning;  // one line for the reader of a report
  double lower_bound = -std::numeric_limits<double>::infinity();
};

inline constexpr int kNumParameters = 4;
inline constexpr int kInertia = 0;
inline constexpr int kQuadraticDamping = 1;
inline constexpr int kLinearDamping = 2;
inline constexpr int kBuoyancy = 3;

inline constexpr std::array<ParameterInfo, kNumParameters> kParameterInfo = {{
    {"inertia", "mass plus added mass, or moment of inertia plus added moment", 0.0},
    {"quadratic_damping", "drag that grows with speed squared", 0.0},
    {"linear_damping", "drag that grows with speed", 0.0},
    {"buoyancy", "buoyancy less weight, or an offset of the thrust"},
}};

using ParameterVector = Eigen::Vector4d;  // in the order of kParameterInfo
using ParameterCovariance = Eigen::Matrix4d;

ParameterVector ToVector(const UncoupledModel<double>& model);
UncoupledModel<double> ModelFromVector(const ParameterVector& parameters);

// Unit of parameter `index` for a DOF whose force is given in `force_unit`: SI names where that is
// "N" or "N m" ("kg/m"), otherwise a product of the force's unit ("A s^2/m^2").
std::string ParameterUnit(int index, Dof dof, const std::string& force_unit);

}  // namespace fathom
