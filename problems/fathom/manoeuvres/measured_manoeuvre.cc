// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/measured_manoeuvre.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Geometry>

namespace fathom {
namespace {

constexpr double kOneDegree = std::numbers::pi / 180.0;
constexpr double kStraightShare = 0.05, kAppliedShare = 0.8;  // of the manoeuvre's angle

// From `begin` until `end`, counted from a course and from where the vehicle then is.
ManoeuvreTrack PartOf(const ManoeuvreTrack& logged,
                      std::size_t begin,
                      std::size_t end,
                      double course) {
  ManoeuvreTrack part;
  part.fin_sign = logged.fin_sign;
  const Eigen::AngleAxisd turn(-course, Eigen::Vector3d::UnitZ());
  const Eigen::Quaterniond turned(turn);
  for (std::size_t k = begin; k < end; ++k) {
    CoupledState state = logged.state[k];
    state.position = turned * (state.position - logged.state[begin].position);
    state.attitude = (turned * Eigen::Quaterniond(state.attitude)).coeffs();
    part.time.push_back(logged.time[k] - logged.time[begin]);
    part.angle.push_back(logged.angle[k]);
    part.heading.push_back(logged.heading[k] - course);
    part.state.push_back(state);
  }
  return part;
}

bool IsThisZigzag(const std::optional<MeasuredGear>& gear, const Manoeuvre& manoeuvre) {
  return gear && gear->IsZigzag() && std::abs(gear->angle - manoeuvre.angle) < 0.5 * kOneDegree &&
         std::abs(gear->heading - manoeuvre.heading) < 1e-6;
}

}  // namespace

std::optional<ManoeuvreTrack> MeasuredManoeuvre(const ManoeuvreTrack& logged,
                                                const std::optional<MeasuredGear>& gear,
                                                const Manoeuvre& manoeuvre) {
  const bool is_zigzag = manoeuvre.kind == Manoeuvre::Kind::kZigzag;
  if (!is_zigzag && manoeuvre.kind != Manoeuvre::Kind::kTurningCircle) return std::nullopt;
  if (is_zigzag && !IsThisZigzag(gear, manoeuvre)) return std::nullopt;
  const auto angle = [&](std::size_t k) {
    return manoeuvre.first_side * logged.fin_sign * logged.angle[k];
  };
  const std::size_t size = logged.time.size();
  std::size_t applied = 0, begin = size;
  for (; applied < size && std::abs(angle(applied)) < kAppliedShare * manoeuvre.angle; ++applied) {
    if (std::abs(angle(applied)) < kStraightShare * manoeuvre.angle) begin = applied;
  }
  if (begin == size || applied == size || angle(applied) < 0.0) return std::nullopt;
  if (is_zigzag) return PartOf(logged, begin, size, gear->course);
  std::size_t end = applied;
  bool has_arrived = false;
  for (; end < size; ++end) {
    const bool is_there = std::abs(angle(end) - manoeuvre.angle) < kOneDegree;
    if (has_arrived && !is_there) break;
    has_arrived = has_arrived || is_there;
  }
  const double turned = logged.heading[end - 1] - logged.heading[begin];
  if (!has_arrived || manoeuvre.first_side * turned < 0.5 * std::numbers::pi) return std::nullopt;
  return PartOf(logged, begin, end, logged.heading[begin]);
}

}  // namespace fathom
