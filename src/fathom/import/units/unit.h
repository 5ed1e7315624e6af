// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fathom {

// What a number of a log measures.
enum class Dimension {
  kTime,
  kLength,
  kSpeed,
  kAngle,
  kAngularRate,
  kForce,
  kMoment,
  kRotation,  // of a propeller
  kPulse,     // of a pulse width that commands a motor
  kShare,     // of full command
  kVoltage,
  kPlain,  // without a unit: a part of a quaternion
};

// "a time", "a force".
std::string_view Name(Dimension dimension);

// The unit in which Fathom holds it: "s", "m", "m/s", "rad", "rad/s", "N", "N m", "Hz", "us", "1",
// "V", "1".
std::string_view SiUnit(Dimension dimension);

// Number in this unit times the factor: number in the unit above.
struct Unit {
  Dimension dimension = Dimension::kPlain;
  double factor = 1.0;
};

// The unit that a text names as one of a dimension: "cm/s", "deg", "kN", "knots", "us". Blanks,
// dots and stars do not count, capitals only where they decide (mN, MN, kN, kn). Nothing if it is
// none.
std::optional<Unit> FindUnit(std::string_view text, Dimension dimension);

// Of any dimension, the first that has a unit of this name.
std::optional<Unit> FindUnit(std::string_view text);

// The unit of stamps that state none, by their size: "ns", "us" or "ms" since 1970, else "s".
// Nobody dives before 1973.
std::string_view UnitOfStamp(double stamp);

// "'m', 'cm', 'mm', ...": the names of the units of a dimension.
std::string UnitsOf(Dimension dimension);

}  // namespace fathom
