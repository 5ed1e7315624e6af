// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/imo_limit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fathom {
namespace {

bool IsAngle(double angle, double degrees) {
  return std::abs(angle - degrees * std::numbers::pi / 180.0) < 1e-9;
}

std::optional<double> LimitOfZigzag(const Manoeuvre& manoeuvre,
                                    std::string_view figure,
                                    double length,
                                    double ahead) {
  const double lengths_time = std::clamp(length / ahead, 10.0, 30.0);  // [s]
  if (IsAngle(manoeuvre.angle, 10.0) && IsAngle(manoeuvre.heading, 10.0)) {
    if (figure == "first_overshoot") return 5.0 + 0.5 * lengths_time;
    if (figure == "second_overshoot") return 17.5 + 0.75 * lengths_time;
  }
  if (IsAngle(manoeuvre.angle, 20.0) && IsAngle(manoeuvre.heading, 20.0) &&
      figure == "first_overshoot") {
    return 25.0;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> ImoLimit(const Manoeuvre& manoeuvre,
                               std::string_view figure,
                               double length,
                               double ahead) {
  switch (manoeuvre.kind) {
    case Manoeuvre::Kind::kTurningCircle:
      if (!IsAngle(manoeuvre.angle, 35.0)) return std::nullopt;
      if (figure == "advance") return 4.5 * length;
      if (figure == "tactical_diameter") return 5.0 * length;
      return std::nullopt;
    case Manoeuvre::Kind::kZigzag:
      return LimitOfZigzag(manoeuvre, figure, length, ahead);
    case Manoeuvre::Kind::kStop:
      if (figure == "track_reach" && manoeuvre.astern == 1.0) return 15.0 * length;
      return std::nullopt;
    case Manoeuvre::Kind::kSpiral:
    case Manoeuvre::Kind::kPullOut:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace fathom
