// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/shaft_yaml.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// `bollard: 0.36`, `linear: [0.36, -0.4]` of K_0 and K_1, or `table: [[0, 0.36], [0.8, 0.04]]`.
OpenWaterCurve ReadCurve(const YamlMap& map) {
  if (map.Has("bollard") + map.Has("linear") + map.Has("table") != 1) {
    map.Fail("expected one of 'bollard', 'linear' and 'table'.");
  }
  OpenWaterCurve curve;
  if (map.Has("bollard")) {
    curve = {{0.0}, {map.Number("bollard")}};
  } else if (map.Has("linear")) {
    const std::vector<double> line = map.Numbers("linear", 2);
    if (!(line[1] < 0.0)) map.Fail("linear", "expected [K_0, K_1] with K_1 below 0.");
    curve = {{0.0, 1.0}, {line[0], line[0] + line[1]}};
  } else {
    for (const std::vector<double>& row : map.NumberLists("table", 2)) {
      curve.advance.push_back(row[0]);
      curve.thrust.push_back(row[1]);
    }
    if (curve.advance.size() < 2 || curve.advance.front() != 0.0) {
      map.Fail("table", "expected two rows [J, K_T] at least, the first with J = 0.");
    }
    const bool rises =
        std::adjacent_find(curve.advance.begin(), curve.advance.end(), std::greater_equal<>()) ==
        curve.advance.end();
    if (!rises) map.Fail("table", "J does not increase from one row to the next.");
  }
  if (!(curve.thrust.front() > 0.0)) {
    map.Fail(fmt::format("K_T at rest is {}, expected a number above 0.", curve.thrust.front()));
  }
  return curve;
}

std::optional<double> ReadShareBelow1(const YamlMap& map, std::string_view key) {
  if (!map.Has(key)) return std::nullopt;
  const double share = map.Number(key);
  if (!(share < 1.0 && share > -1.0)) {
    map.Fail(key, fmt::format("is {}, expected a share between -1 and 1.", share));
  }
  return share;
}

Shaft ReadShaft(const YamlMap& map) {
  Shaft shaft;
  shaft.name = map.Name("name");
  const std::vector<double> position = map.Numbers("position", 3);
  shaft.position = {position[0], position[1], position[2]};
  shaft.diameter = map.Number("diameter");
  if (!(shaft.diameter > 0.0)) {
    map.Fail("diameter", fmt::format("is {}, expected a number above 0.", shaft.diameter));
  }
  if (const auto thrust = map.OptionalMap("thrust")) shaft.curve = ReadCurve(*thrust);
  shaft.wake = ReadShareBelow1(map, "wake");
  shaft.thrust_deduction = ReadShareBelow1(map, "thrust_deduction");
  return shaft;
}

}  // namespace

std::vector<Shaft> ReadShafts(const YamlMap& file, const std::vector<Thruster>& thrusters) {
  std::vector<Shaft> shafts;
  for (const YamlMap& map : file.OptionalMaps("shafts")) {
    Shaft shaft = ReadShaft(map);
    const auto has_name = [&](const auto& other) { return other.name == shaft.name; };
    if (std::ranges::any_of(shafts, has_name) || std::ranges::any_of(thrusters, has_name)) {
      map.Fail("name", "is that of another shaft or thruster, expected each name once.");
    }
    shafts.push_back(std::move(shaft));
  }
  return shafts;
}

}  // namespace fathom
