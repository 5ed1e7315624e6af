// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_limits.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/files/yaml_numbers.h"
#include "fathom/base/input_error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLongestMinutes = 60.0;
constexpr double kLongestHold = 60.0;  // [s]
constexpr double kShortestHold = 0.02;

// A file for a model of several DOFs is easily taken for this one.
void RequireOneDof(const YamlMap& map) {
  for (const char* key : {"force", "speed"}) {
    if (!map.HoldsMap(key)) continue;
    map.Fail(
        key,
        "is a map, as for a model of several DOFs, expected one number: the model has one "
        "DOF. A limits file of one DOF holds force: 40, speed: 0.8, distance: {back: 8, ahead: "
        "8} (docs/file_formats.md).");
  }
}

// A limit that may be missing.
double LimitOf(const YamlMap& map, std::string_view key) {
  return map.Has(key) ? Positive(map, key) : PlanLimits::kNoLimit;
}

}  // namespace

PlanLimits LimitsOfLog(const DataRange& range) {
  const auto greatest = [](const ValueRange& values) {
    return std::max(std::abs(values.low), std::abs(values.high));
  };
  PlanLimits limits;
  limits.force = greatest(range.force);
  limits.speed = greatest(range.speed);
  return limits;
}

PlanLimits ParsePlanLimits(const std::string& name, const std::string& text) {
  const YamlMap file = ParseYaml(name, text);
  RequireOneDof(file);
  PlanLimits limits;
  limits.force = Positive(file, "force");
  limits.speed = LimitOf(file, "speed");
  limits.thruster_force = LimitOf(file, "thruster_force");
  if (file.Has("distance") && !file.HoldsMap("distance")) {
    file.Fail("distance", "is one value, expected one each way, in m: {back: 8, ahead: 8}.");
  }
  if (const auto distance = file.OptionalMap("distance")) {
    limits.distance = {-LimitOf(*distance, "back"), LimitOf(*distance, "ahead")};
  }
  limits.shortest_hold =
      NumberWithin(file, "shortest_hold", kShortestHold, kLongestHold, limits.shortest_hold);
  if (file.Has("minutes")) {
    limits.duration = 60.0 * NumberWithin(file, "minutes", 0.1, kLongestMinutes);
  }
  if (const auto velocity = file.OptionalMap("velocity")) {
    if (velocity->Has("rate"))
      limits.velocity.rate = NumberWithin(*velocity, "rate", 0.1, kGreatestRate);
    if (velocity->Has("noise")) limits.velocity.noise = Positive(*velocity, "noise");
  }
  if (const auto position = file.OptionalMap("position")) {
    if (position->Has("rate"))
      limits.position.rate = NumberWithin(*position, "rate", 0.1, kGreatestRate);
    limits.position.noise = Positive(*position, "noise");
  }
  file.Finish();
  return limits;
}

PlanLimits ReadPlanLimits(const std::filesystem::path& path) {
  return ParsePlanLimits(path.string(), ReadFile(path));
}

void RequireMeasured(const std::string& model,
                     double value,
                     double most,
                     const std::string& what,
                     const std::string& key) {
  if (std::isfinite(value) && value > 0.0 && value <= most) return;
  throw InputError(fmt::format(
      "{}: does not say {}, expected `velocity: {{{}}}` in the limits file.", model, what, key));
}

}  // namespace fathom
