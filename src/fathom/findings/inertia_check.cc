// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/inertia_check.h"

#include "fathom/base/interval95.h"
#include "fathom/base/short_number.h"
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
constexpr double kWater = 1000.0;                       // [kg/m^3]
constexpr double kBoxOverPlate = 2.0;                   // see MostInertia()
constexpr double kLeastOfBox = 0.1, kMostOfBox = 30.0;  // see CheckInertia()
constexpr double kUsualMasses = 3.0;  // mass and added mass over mass, at most as a rule

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
  std::vector<std::string> texts, unusual;
  for (const UnitMistake& mistake : kUnitMistakes) {
    if (!IsPossible(mistake, body.logged)) continue;
    const double masses = inertia / mistake.factor / body.mass;
    if (masses < 1.0 || masses > kMostMasses) continue;
    (masses <= kUsualMasses ? texts : unusual).emplace_back(mistake.text);
  }
  texts.insert(texts.end(), unusual.begin(), unusual.end());
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

// The moment of inertia of a box of even density [kg m^2].
double BoxInertia(Dof dof, double mass, const std::array<double, 3>& size) {
  const int axis = Index(dof) - Index(Dof::kRoll);
  const double a = size[(axis + 1) % 3], b = size[(axis + 2) % 3];
  return mass * (a * a + b * b) / 12.0;
}

std::optional<Finding> CheckTurningInertia(Dof dof,
                                           double inertia,
                                           double reach,
                                           const Body& body) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const double box = BoxInertia(dof, body.mass, *body.size);
  const bool is_too_small = inertia + reach < kLeastOfBox * box;
  const bool is_too_large = inertia - reach > kMostOfBox * box;
  if (!is_too_small && !is_too_large) return std::nullopt;
  const double in_radians = inertia * kDegrees;
  const bool are_degrees = in_radians > kLeastOfBox * box && in_radians < kMostOfBox * box;
  return Finding{
      Severity::kWarning,
      "inertia",
      fmt::format("The inertia of {:.4g} kg m^2 (± {}) is {} of {:.3g} kg m^2 that a box of "
                  "the vehicle's size and mass has. {}",
                  inertia,
                  ShortNumber(reach, 2),
                  is_too_small ? fmt::format("under {:g} times that", kLeastOfBox)
                               : fmt::format("over {:g} times that", kMostOfBox),
                  box,
                  are_degrees ? "Would explain it: turns in deg/s, not rad/s (multiply them by "
                                "0.01745)."
                              : ToCheck(inertia, body))};
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
  if (!std::isfinite(inertia) || !(mass > 0.0)) return std::nullopt;
  const double reach = std::isfinite(std) ? kStdsOf95 * std : 0.0;
  if (IsAngular(dof)) {
    return body.size ? CheckTurningInertia(dof, inertia, reach, body) : std::nullopt;
  }
  const double most = MostInertia(dof, body);
  const bool is_too_small = inertia + reach < mass;
  const bool is_too_large = inertia - reach > most;
  if (!is_too_small && !is_too_large) return std::nullopt;
  return Finding{
      Severity::kWarning,
      "inertia",
      fmt::format("The inertia of {:.4g} kg (± {}) is {} the vehicle's dry mass of {:.4g} kg. {}",
                  inertia,
                  ShortNumber(reach, 2),
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
