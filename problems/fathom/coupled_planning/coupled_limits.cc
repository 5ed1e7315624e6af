// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/coupled_limits.h"

#include "fathom/base/files/yaml_file.h"
#include "fathom/base/files/yaml_numbers.h"
#include "fathom/planning/plan_limits.h"
#include "fathom/simulate/coupled/attitude_angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kMostMinutes = 60.0;
constexpr double kGreatestHold = 60.0;  // [s]
constexpr double kLeastHold = 0.02;

// A number for each DOF that is named: {surge: 40, yaw: 8}.
void ReadByName(const YamlMap& file, std::string_view key, std::array<double, 6>* by_dof) {
  if (!file.Has(key)) return;
  if (!file.HoldsMap(key)) {
    file.Fail(
        key,
        "is no map, expected a number for each DOF, {surge: 40, yaw: 8}: the model has several.");
  }
  const YamlMap map = file.Map(key);
  for (const Dof dof : kAllDofs) {
    if (map.Has(Name(dof)))
      (*by_dof)[static_cast<std::size_t>(Index(dof))] = Positive(map, Name(dof));
  }
}

double DistanceOf(const YamlMap& map, std::string_view key) {
  return map.Has(key) ? Positive(map, key) : CoupledLimits::kNoLimit;
}

bool IsWithin(double value, const ValueRange& range) {
  return range.low <= value && value <= range.high;
}

}  // namespace

bool KeepsLimits(std::span<const CoupledState> run, const CoupledLimits& limits) {
  return std::all_of(run.begin(), run.end(), [&](const CoupledState& state) {
    for (std::size_t i = 0; i < 6; ++i) {
      if (!(std::abs(state.nu[static_cast<Eigen::Index>(i)]) <= limits.speed[i])) return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (!IsWithin(state.position[static_cast<Eigen::Index>(i)], limits.room[i])) return false;
    }
    return TiltOf(state) <= limits.tilt && std::abs(UnwrappedHeading(state, 0.0)) <= limits.heading;
  });
}

CoupledLimits ParseCoupledLimits(const std::string& name, const std::string& text) {
  const YamlMap file = ParseYaml(name, text);
  CoupledLimits limits;
  ReadByName(file, "force", &limits.force);
  if (!file.Has("force")) file.Fail("needs the key 'force': a number for each DOF to command.");
  ReadByName(file, "speed", &limits.speed);
  if (const auto distance = file.OptionalMap("distance")) {
    limits.room = {ValueRange{-DistanceOf(*distance, "back"), DistanceOf(*distance, "ahead")},
                   ValueRange{-DistanceOf(*distance, "port"), DistanceOf(*distance, "starboard")},
                   ValueRange{-DistanceOf(*distance, "up"), DistanceOf(*distance, "down")}};
  }
  if (file.Has("tilt")) limits.tilt = NumberWithin(file, "tilt", 1e-3, std::numbers::pi);
  if (file.Has("heading")) limits.heading = NumberWithin(file, "heading", 1e-3, std::numbers::pi);
  if (file.Has("thruster_force")) limits.thruster_force = Positive(file, "thruster_force");
  limits.shortest_hold =
      NumberWithin(file, "shortest_hold", kLeastHold, kGreatestHold, limits.shortest_hold);
  if (file.Has("minutes"))
    limits.duration = 60.0 * NumberWithin(file, "minutes", 0.1, kMostMinutes);
  if (const auto velocity = file.OptionalMap("velocity")) {
    if (velocity->Has("rate")) limits.rate = NumberWithin(*velocity, "rate", 0.1, kGreatestRate);
    ReadByName(*velocity, "noise", &limits.noise);
  }
  file.Finish();
  return limits;
}

}  // namespace fathom
