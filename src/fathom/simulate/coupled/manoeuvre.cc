// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/manoeuvre.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"
#include "fathom/simulate/coupled/steering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kManoeuvreStep = 0.1;  // [s]
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kNeverReached = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void RefuseManoeuvre(std::string_view text) {
  throw InputError(fmt::format(
      "{} is no manoeuvre, expected turning_circle:35 (degrees of the rudder) or zigzag:10/10 "
      "(degrees of rudder and heading).",
      Quoted(std::string(text))));
}

double AngleIn(std::string_view text, std::string_view whole) {
  const auto degrees = ParseFiniteNumber(text);
  if (!degrees || !(*degrees > 0.0 && *degrees < 90.0)) RefuseManoeuvre(whole);
  return *degrees * kDegree;
}

double HeadingOf(const CoupledState& state) {
  const Eigen::Vector4d& q = state.attitude;
  return std::atan2(2.0 * (q[3] * q[2] + q[0] * q[1]), 1.0 - 2.0 * (q[1] * q[1] + q[2] * q[2]));
}

double Unwrapped(double heading, double before) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return heading - kTurn * std::round((heading - before) / kTurn);
}

// The order of the rudder, to starboard, and when the run is over.
class Helmsman {
 public:
  explicit Helmsman(const Manoeuvre& manoeuvre) : manoeuvre_(manoeuvre) {}

  double Order(double heading) {
    if (manoeuvre_.kind == Manoeuvre::Kind::kZigzag && side_ * heading >= manoeuvre_.heading) {
      side_ = -side_;
      ++num_turned_;
    }
    return side_ * manoeuvre_.angle;
  }

  bool IsDone(double heading) const {
    if (manoeuvre_.kind == Manoeuvre::Kind::kZigzag) return num_turned_ >= 4;
    return heading >= 2.0 * std::numbers::pi;
  }

 private:
  const Manoeuvre& manoeuvre_;
  double side_ = 1.0;
  int num_turned_ = 0;
};

// The first sample from `begin` on whose heading is at least (or for side -1 at most) `heading`.
std::size_t Reaching(const ManoeuvreTrack& track, std::size_t begin, double heading, double side) {
  std::size_t k = begin;
  while (k < track.time.size() && side * track.heading[k] < side * heading) ++k;
  return k;
}

// How far the heading goes beyond the one at which the rudder was turned, and the sample there.
std::pair<double, std::size_t> Overshoot(const ManoeuvreTrack& track,
                                         std::size_t begin,
                                         double heading,
                                         double side) {
  std::size_t k = Reaching(track, begin, side * heading, side);
  if (k == track.time.size()) return {kNeverReached, k};
  while (k + 1 < track.time.size() && side * track.heading[k + 1] >= side * track.heading[k]) ++k;
  if (k + 1 == track.time.size()) return {kNeverReached, k};
  return {side * track.heading[k] - heading, k};
}

std::vector<ManoeuvreFigure> FiguresOfZigzag(const Manoeuvre& manoeuvre,
                                             const ManoeuvreTrack& track) {
  const auto [first, at_first] = Overshoot(track, 0, manoeuvre.heading, 1.0);
  const auto [second, at_second] = Overshoot(track, at_first, manoeuvre.heading, -1.0);
  const auto [third, at_third] = Overshoot(track, at_second, manoeuvre.heading, 1.0);
  const double period =
      std::isfinite(third) ? track.time[at_third] - track.time[at_first] : kNeverReached;
  return {{"first_overshoot", first / kDegree, "deg"},
          {"second_overshoot", second / kDegree, "deg"},
          {"period", period, "s"}};
}

std::vector<ManoeuvreFigure> FiguresOfCircle(const ManoeuvreTrack& track) {
  const auto at = [&](double degrees) { return Reaching(track, 0, degrees * kDegree, 1.0); };
  const std::size_t quarter = at(90.0), half = at(180.0), end = track.time.size();
  const auto position = [&](std::size_t k, Eigen::Index axis) {
    return k < end ? track.state[k].position[axis] : kNeverReached;
  };
  const bool is_whole = at(359.0) < end;
  const CoupledState& last = track.state.back();
  const double speed = last.nu.head<2>().norm();
  return {{"advance", position(quarter, 0), "m"},
          {"transfer", position(quarter, 1), "m"},
          {"tactical_diameter", position(half, 1), "m"},
          {"steady_radius", is_whole ? speed / std::abs(last.nu[5]) : kNeverReached, "m"},
          {"steady_speed", is_whole ? speed : kNeverReached, "m/s"}};
}

}  // namespace

Manoeuvre ParseManoeuvre(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) RefuseManoeuvre(text);
  const std::string_view name = text.substr(0, colon), rest = text.substr(colon + 1);
  Manoeuvre manoeuvre;
  if (name == "turning_circle") {
    manoeuvre.angle = AngleIn(rest, text);
    return manoeuvre;
  }
  const std::size_t slash = rest.find('/');
  if (name != "zigzag" || slash == std::string_view::npos) RefuseManoeuvre(text);
  manoeuvre.kind = Manoeuvre::Kind::kZigzag;
  manoeuvre.angle = AngleIn(rest.substr(0, slash), text);
  manoeuvre.heading = AngleIn(rest.substr(slash + 1), text);
  return manoeuvre;
}

std::optional<ManoeuvreTrack> RunManoeuvre(const CoupledModel& model,
                                           const std::vector<CommandedFin>& fins,
                                           const Manoeuvre& manoeuvre,
                                           const ManoeuvreOptions& options) {
  const auto rudder = RudderOf(fins);
  if (!rudder) return std::nullopt;
  // A positive angle turns to the side that the arm says.
  const double to_starboard = fins[*rudder].arms.across[Index(Dof::kYaw)] > 0.0 ? 1.0 : -1.0;
  CoupledInputs inputs;
  CoupledCommand& command = inputs.command;
  command.time = {0.0};
  Vector6 wrench = options.force;
  wrench[0] -= options.thrust;
  command.force = {wrench};
  // All that makes a race, as one thruster of that name.
  command.thrusters = {{"race", Vector6::Unit(0), {options.thrust}}};
  command.fins = fins;
  for (CommandedFin& fin : command.fins) {
    fin.angle = {0.0};
    if (!fin.behind.empty()) fin.behind = "race";
  }
  const bool has_surge = std::ranges::find(model.dofs, Dof::kSurge) != model.dofs.end();
  if (!has_surge) inputs.measured[0] = {{0.0}, {options.ahead}};
  CoupledModel driven = model;
  driven.thrust_gain.clear();  // in options.force
  CoupledState state;
  state.nu[0] = options.ahead;
  ManoeuvreTrack track;
  Helmsman helmsman(manoeuvre);
  double angle = 0.0, heading = 0.0;
  CoupledStamps stamps;
  stamps.pose = {kManoeuvreStep};
  CoupledOutputs outputs;
  for (int k = 0;; ++k) {
    track.time.push_back(kManoeuvreStep * k);
    track.angle.push_back(angle);
    track.heading.push_back(heading);
    track.state.push_back(state);
    if (helmsman.IsDone(heading) || track.time.back() >= options.longest) return track;
    const double most = options.rudder_rate * kManoeuvreStep;
    angle += std::clamp(to_starboard * helmsman.Order(heading) - angle, -most, most);
    command.fins[*rudder].angle = {angle};
    if (!RunCoupled(driven, inputs, state, stamps, &outputs)) return std::nullopt;
    state = outputs.pose.front();
    heading = Unwrapped(HeadingOf(state), heading);
  }
}

std::vector<ManoeuvreFigure> FiguresOf(const Manoeuvre& manoeuvre, const ManoeuvreTrack& track) {
  return manoeuvre.kind == Manoeuvre::Kind::kZigzag ? FiguresOfZigzag(manoeuvre, track)
                                                    : FiguresOfCircle(track);
}

std::optional<double> ImoLimit(const Manoeuvre& manoeuvre,
                               std::string_view figure,
                               double length,
                               double ahead) {
  const auto is = [](double angle, double degrees) {
    return std::abs(angle - degrees * std::numbers::pi / 180.0) < 1e-9;
  };
  if (manoeuvre.kind == Manoeuvre::Kind::kTurningCircle) {
    if (!is(manoeuvre.angle, 35.0)) return std::nullopt;
    if (figure == "advance") return 4.5 * length;
    if (figure == "tactical_diameter") return 5.0 * length;
    return std::nullopt;
  }
  const double lengths_time = std::clamp(length / ahead, 10.0, 30.0);  // [s]
  if (is(manoeuvre.angle, 10.0) && is(manoeuvre.heading, 10.0)) {
    if (figure == "first_overshoot") return 5.0 + 0.5 * lengths_time;
    if (figure == "second_overshoot") return 17.5 + 0.75 * lengths_time;
  }
  if (is(manoeuvre.angle, 20.0) && is(manoeuvre.heading, 20.0) && figure == "first_overshoot") {
    return 25.0;
  }
  return std::nullopt;
}

}  // namespace fathom
