// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/steering_table.h"

#include "fathom/base/input_error.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kFreshWater = 1000.0;  // [kg/m^3], as docs/fins.md (1)

}  // namespace

SteeringUnits ParseSteeringUnits(std::string_view text) {
  if (text == "si") return SteeringUnits::kSi;
  if (text == "prime") return SteeringUnits::kPrime;
  throw InputError(fmt::format("--table: is '{}', expected si or prime.", text));
}

std::vector<ManoeuvreFigure> DerivativesOf(const SteeringEquations& equations,
                                           double ahead,
                                           std::optional<double> length) {
  std::vector<ManoeuvreFigure> figures;
  const auto add = [&](std::string name,
                       double value,
                       std::string unit,
                       int power_of_length,
                       int power_of_speed,
                       double density = 0.5 * kFreshWater) {
    if (length) {
      value /= density * std::pow(*length, power_of_length) * std::pow(ahead, power_of_speed);
      name = name.find(' ') == std::string::npos ? name + "'" : "(" + name + ")'";
      unit = "-";
    }
    figures.push_back({std::move(name), value, std::move(unit)});
  };
  const Eigen::MatrixXd &M = equations.inertia, &F = equations.force;
  const Eigen::Index yaw = M.rows() - 1;
  if (equations.HasSway()) {
    add("Y_v", F(0, 0), "kg/s", 2, 1);
    add("Y_r - m u", F(0, yaw), "kg m/s", 3, 1);
    add("Y_delta", equations.rudder[0], "N/rad", 2, 2);
    add("N_v", F(yaw, 0), "kg m/s", 3, 1);
  }
  add("N_r - m x_G u", F(yaw, yaw), "kg m^2/s", 4, 1);
  add("N_delta", equations.rudder[yaw], "N m/rad", 3, 2);
  if (equations.HasSway()) {
    add("m - Y_vdot", M(0, 0), "kg", 3, 0);
    add("m x_G - Y_rdot", M(0, yaw), "kg m", 4, 0);
  }
  add("I_z - N_rdot", M(yaw, yaw), "kg m^2", 5, 0);
  const Nomoto nomoto = NomotoOf(equations);
  add("K", nomoto.K, "1/s", -1, 1, 1.0);
  add("T", nomoto.T, "s", 1, -1, 1.0);
  add("growth_rate", nomoto.growth_rate, "1/s", -1, 1, 1.0);
  return figures;
}

}  // namespace fathom
