// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/inertia_check.h"

#include "fathom/base/interval95.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kMostMasses = 5.0;
constexpr double kWater = 1000.0;      // [kg/m^3]
constexpr double kBoxOverPlate = 2.0;  // see MostInertia()
constexpr double kUsualMasses = 3.0;   // mass and added mass over mass, at most as a rule

// A number read in the wrong unit makes the inertia this many times too large.
struct UnitMistake {
  double factor;
  bool LoggedQuantities::*quantity;  // it can only be made of this; null: of any log
  const char* text;
};

constexpr std::array<UnitMistake, 11> kUnitMistakes = {{
    {1e-3, &LoggedQuantities::force, "forces in kN, not N (multiply them by 1000)"},
    {1.0 / 9.80665, &LoggedQuantities::force, "forces in kgf, not N (multiply them by 9.807)"},
    {1.0 / 4.44822, &LoggedQuantities::force, "forces in lbf, not N (multiply them by 4.448)"},
    {3600.0,
     &LoggedQuantities::thruster_speed,
     "thruster speeds in rpm, not Hz (divide them by 60)"},
    {39.4784,
     &LoggedQuantities::thruster_speed,
     "thruster speeds in rad/s, not Hz (divide them by 6.283)"},
    {1e-3, nullptr, "motion in mm and mm/s (multiply it by 0.001)"},
    {1e-2, nullptr, "motion in cm and cm/s (multiply it by 0.01)"},
    {1.0 / 1.94384,
     &LoggedQuantities::velocity,
     "speeds in knots, not m/s (multiply them by 0.5144)"},
    {1.0 / 3.6, &LoggedQuantities::velocity, "speeds in km/h, not m/s (multiply them by 0.2778)"},
    {1.0 / 3.28084, nullptr, "motion in feet (multiply it by 0.3048)"},
    {1e3, nullptr, "the mass of the vehicle in t, not kg"},
}};

constexpr const char* kWrongMass = "a wrong `mass` in log.yaml or the vehicle file";

bool IsPossible(const UnitMistake& mistake, const LoggedQuantities& logged) {
  return mistake.quantity == nullptr || logged.*mistake.quantity;
}

// Where no unit explains it.
std::string ToCheck(double inertia, const Body& body) {
  std::vector<std::string> units;
  if (body.logged.force) units.emplace_back("force");
  if (body.logged.thruster_speed) units.emplace_back("thruster speed");
  units.emplace_back("motion");
  const char* const thrusters =
      body.logged.thruster_speed ? "the coefficients of the thrusters, " : "";
  const char* const flat =
      inertia > body.mass && !body.size
          ? " A flat vehicle moved across its plane may reach six times its mass: a vehicle file "
            "tells its size."
          : "";
  return fmt::format(
      "Check `mass` in log.yaml or the vehicle file, the units of {}, {}and the clocks.{}",
      fmt::join(units, " and "),
      thrusters,
      flat);
}

std::string ExplainedBy(double inertia, const Body& body) {
  std::vector<std::string> texts;
  for (const UnitMistake& mistake : kUnitMistakes) {
    if (!IsPossible(mistake, body.logged)) continue;
    const double masses = inertia / mistake.factor / body.mass;
    if (masses >= 1.0 && masses <= kUsualMasses) texts.emplace_back(mistake.text);
  }
  if (texts.empty()) return ToCheck(inertia, body);
  texts.emplace_back(kWrongMass);
  return fmt::format("Would explain it: {}.", fmt::join(texts, "; or "));
}

// The added mass of a plate as large as the face across the motion; 0 where that is not known.
double PlateMass(Dof dof, const Body& body) {
  if (!body.size) return 0.0;
  std::vector<double> face;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != Index(dof)) face.push_back((*body.size)[axis]);
  }
  const auto [shorter, longer] = std::minmax(face[0], face[1]);
  return kWater * std::numbers::pi / 4.0 * shorter * shorter * longer;
}

}  // namespace

double MostInertia(Dof dof, const Body& body) {
  return std::max(kMostMasses * body.mass, kBoxOverPlate * (body.mass + PlateMass(dof, body)));
}

double UsualInertia(Dof dof, const Body& body) {
  return std::max(kUsualMasses * body.mass, body.mass + PlateMass(dof, body));
}

std::optional<Finding> CheckInertia(Dof dof, double inertia, double std, const Body& body) {
  const double mass = body.mass;
  if (IsAngular(dof) || !std::isfinite(inertia) || !(mass > 0.0)) return std::nullopt;
  const double reach = std::isfinite(std) ? kStdsOf95 * std : 0.0;
  const double most = MostInertia(dof, body);
  const bool is_too_small = inertia + reach < mass;
  const bool is_too_large = inertia - reach > most;
  if (!is_too_small && !is_too_large) return std::nullopt;
  return Finding{
      Severity::kWarning,
      "inertia",
      fmt::format(
          "The inertia of {:.4g} kg (± {:.2g}) is {} the vehicle's dry mass of {:.4g} kg. {}",
          inertia,
          reach,
          is_too_small ? "below" : fmt::format("over {:.2g} times", most / mass),
          mass,
          ExplainedBy(inertia, body))};
}

std::optional<Finding> CheckInertia(const FittedModel& model, const std::optional<Body>& body) {
  if (!body || model.force_unit != ForceUnit(model.dof)) return std::nullopt;
  const double std = std::sqrt(model.covariance(kInertia, kInertia));
  return CheckInertia(model.dof, model.model.inertia, std, *body);
}

}  // namespace fathom
