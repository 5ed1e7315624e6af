// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/units/unit.h"

#include "fathom/base/quoted.h"

#include <cctype>
#include <cstddef>
#include <numbers>

namespace fathom {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kKilogramForce = 9.80665;       // [N], exact
constexpr double kPoundForce = 4.4482216152605;  // [N], exact
constexpr double kKnot = 1852.0 / 3600.0;        // [m/s], exact
constexpr double kFoot = 0.3048;                 // [m], exact

// In the order of Dimension.
struct NamedDimension {
  std::string_view name, si_unit;
};

constexpr NamedDimension kDimensions[] = {
    {"a time", "s"},
    {"a length", "m"},
    {"a speed", "m/s"},
    {"an angle", "rad"},
    {"an angular rate", "rad/s"},
    {"a force", "N"},
    {"a moment", "N m"},
    {"a propeller's speed", "Hz"},
    {"a pulse width", "us"},
    {"a share of full command", "1"},
    {"a voltage", "V"},
    {"a plain number", "1"},
};

struct NamedUnit {
  std::string_view name;  // without blanks, in lower case unless `has_case`
  Unit unit;
  bool has_case = false;
};

constexpr NamedUnit kUnits[] = {
    {"s", {Dimension::kTime, 1.0}},
    {"ms", {Dimension::kTime, 1e-3}},
    {"us", {Dimension::kTime, 1e-6}},
    {"ns", {Dimension::kTime, 1e-9}},
    {"min", {Dimension::kTime, 60.0}},
    {"h", {Dimension::kTime, 3600.0}},
    {"sec", {Dimension::kTime, 1.0}},
    {"secs", {Dimension::kTime, 1.0}},
    {"seconds", {Dimension::kTime, 1.0}},
    {"msec", {Dimension::kTime, 1e-3}},
    {"millis", {Dimension::kTime, 1e-3}},
    {"milliseconds", {Dimension::kTime, 1e-3}},
    {"usec", {Dimension::kTime, 1e-6}},
    {"micros", {Dimension::kTime, 1e-6}},
    {"microseconds", {Dimension::kTime, 1e-6}},
    {"\xc2\xb5s", {Dimension::kTime, 1e-6}},
    {"nanoseconds", {Dimension::kTime, 1e-9}},
    {"m", {Dimension::kLength, 1.0}},
    {"cm", {Dimension::kLength, 1e-2}},
    {"mm", {Dimension::kLength, 1e-3}},
    {"km", {Dimension::kLength, 1e3}},
    {"ft", {Dimension::kLength, kFoot}},
    {"m/s", {Dimension::kSpeed, 1.0}},
    {"cm/s", {Dimension::kSpeed, 1e-2}},
    {"mm/s", {Dimension::kSpeed, 1e-3}},
    {"km/h", {Dimension::kSpeed, 1.0 / 3.6}},
    {"kn", {Dimension::kSpeed, kKnot}, true},
    {"kt", {Dimension::kSpeed, kKnot}},
    {"kts", {Dimension::kSpeed, kKnot}},
    {"knots", {Dimension::kSpeed, kKnot}},
    {"ft/s", {Dimension::kSpeed, kFoot}},
    {"mps", {Dimension::kSpeed, 1.0}},
    {"ms-1", {Dimension::kSpeed, 1.0}},
    {"m/sec", {Dimension::kSpeed, 1.0}},
    {"rad", {Dimension::kAngle, 1.0}},
    {"deg", {Dimension::kAngle, kDegree}},
    {"degrees", {Dimension::kAngle, kDegree}},
    {"\xc2\xb0", {Dimension::kAngle, kDegree}},
    {"degheading", {Dimension::kAngle, kDegree}},  // ArduPilot
    {"cdeg", {Dimension::kAngle, 0.01 * kDegree}},
    {"rad/s", {Dimension::kAngularRate, 1.0}},
    {"deg/s", {Dimension::kAngularRate, kDegree}},
    {"\xc2\xb0/s", {Dimension::kAngularRate, kDegree}},
    {"dps", {Dimension::kAngularRate, kDegree}},
    {"rads-1", {Dimension::kAngularRate, 1.0}},
    {"rad/sec", {Dimension::kAngularRate, 1.0}},
    {"deg/sec", {Dimension::kAngularRate, kDegree}},
    {"rpm", {Dimension::kAngularRate, kTurn / 60.0}},
    {"N", {Dimension::kForce, 1.0}, true},
    {"kN", {Dimension::kForce, 1e3}, true},
    {"mN", {Dimension::kForce, 1e-3}, true},
    {"MN", {Dimension::kForce, 1e6}, true},
    {"kgf", {Dimension::kForce, kKilogramForce}},
    {"gf", {Dimension::kForce, 1e-3 * kKilogramForce}},
    {"lbf", {Dimension::kForce, kPoundForce}},
    {"newton", {Dimension::kForce, 1.0}},
    {"newtons", {Dimension::kForce, 1.0}},
    {"nm", {Dimension::kMoment, 1.0}},
    {"kNm", {Dimension::kMoment, 1e3}, true},
    {"mNm", {Dimension::kMoment, 1e-3}, true},
    {"ncm", {Dimension::kMoment, 1e-2}},
    {"kgfm", {Dimension::kMoment, kKilogramForce}},
    {"lbfft", {Dimension::kMoment, kPoundForce* kFoot}},
    {"hz", {Dimension::kRotation, 1.0}},
    {"rpm", {Dimension::kRotation, 1.0 / 60.0}},
    {"rps", {Dimension::kRotation, 1.0}},
    {"rev/s", {Dimension::kRotation, 1.0}},
    {"rad/s", {Dimension::kRotation, 1.0 / kTurn}},
    {"us", {Dimension::kPulse, 1.0}},
    {"\xc2\xb5s", {Dimension::kPulse, 1.0}},
    {"pwm", {Dimension::kPulse, 1.0}},
    {"ms", {Dimension::kPulse, 1e3}},
    {"1", {Dimension::kShare, 1.0}},
    {"%", {Dimension::kShare, 1e-2}},
    {"percent", {Dimension::kShare, 1e-2}},
    {"pct", {Dimension::kShare, 1e-2}},
    {"v", {Dimension::kVoltage, 1.0}},
    {"mV", {Dimension::kVoltage, 1e-3}, true},
    {"1", {Dimension::kPlain, 1.0}},
};

std::string Normalized(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (std::string_view(" *.^_").find(c) == std::string_view::npos) letters += c;
  }
  return letters;
}

std::string LowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// `exact`: as written, `lower`: in lower case. A unit whose capitals decide goes before all others:
// "kN" is no knot.
template <typename Predicate>
std::optional<Unit> Search(std::string_view text, const Predicate& is_wanted) {
  const std::string exact = Normalized(text);
  for (const NamedUnit& unit : kUnits) {
    if (unit.has_case && unit.name == exact && is_wanted(unit)) return unit.unit;
  }
  const std::string lower = LowerCase(exact);
  for (const NamedUnit& unit : kUnits) {
    if (!unit.has_case && unit.name == lower && is_wanted(unit)) return unit.unit;
  }
  return std::nullopt;
}

}  // namespace

std::string_view Name(Dimension dimension) {
  return kDimensions[static_cast<std::size_t>(dimension)].name;
}

std::string_view SiUnit(Dimension dimension) {
  return kDimensions[static_cast<std::size_t>(dimension)].si_unit;
}

std::optional<Unit> FindUnit(std::string_view text, Dimension dimension) {
  return Search(text, [&](const NamedUnit& named) { return named.unit.dimension == dimension; });
}

std::optional<Unit> FindUnit(std::string_view text) {
  return Search(text, [](const NamedUnit&) { return true; });
}

std::string_view UnitOfStamp(double stamp) {
  return stamp > 1e17 ? "ns" : stamp > 1e14 ? "us" : stamp > 1e11 ? "ms" : "s";
}

std::string UnitsOf(Dimension dimension) {
  std::string text;
  for (const NamedUnit& named : kUnits) {
    if (named.unit.dimension != dimension) continue;
    text += (text.empty() ? "" : ", ") + Quoted(named.name);
  }
  return text;
}

}  // namespace fathom
