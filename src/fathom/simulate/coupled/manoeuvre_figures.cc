// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/manoeuvre_figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

namespace fathom {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kNeverReached = std::numeric_limits<double>::quiet_NaN();

// The first sample from `begin` on whose heading is at least (or for side -1 at most) `heading`.
std::size_t Reaching(const ManoeuvreTrack& track, std::size_t begin, double heading, double side) {
  std::size_t k = begin;
  while (k < track.time.size() && side * track.heading[k] < side * heading) ++k;
  return k;
}

// How far the heading goes beyond the one at which the rudder was turned, and the sample there. It
// may waver by a sensor's noise.
std::pair<double, std::size_t> Overshoot(const ManoeuvreTrack& track,
                                         std::size_t begin,
                                         double heading,
                                         double side) {
  constexpr double kWaver = 0.5 * kDegree;
  std::size_t k = Reaching(track, begin, side * heading, side), farthest = k;
  for (; k < track.time.size(); ++k) {
    if (side * track.heading[k] > side * track.heading[farthest]) farthest = k;
    if (side * track.heading[k] < side * track.heading[farthest] - kWaver) {
      return {side * track.heading[farthest] - heading, farthest};
    }
  }
  return {kNeverReached, track.time.size()};
}

std::vector<ManoeuvreFigure> FiguresOfZigzag(const Manoeuvre& manoeuvre,
                                             const ManoeuvreTrack& track) {
  const double side = manoeuvre.first_side;
  const auto [first, at_first] = Overshoot(track, 0, manoeuvre.heading, side);
  const auto [second, at_second] = Overshoot(track, at_first, manoeuvre.heading, -side);
  const auto [third, at_third] = Overshoot(track, at_second, manoeuvre.heading, side);
  const double period =
      std::isfinite(third) ? track.time[at_third] - track.time[at_first] : kNeverReached;
  return {{"first_overshoot", first / kDegree, "deg"},
          {"second_overshoot", second / kDegree, "deg"},
          {"period", period, "s"}};
}

std::vector<ManoeuvreFigure> FiguresOfCircle(const Manoeuvre& manoeuvre,
                                             const ManoeuvreTrack& track) {
  const double side = manoeuvre.first_side;
  const auto at = [&](double degrees) {
    return Reaching(track, 0, side * degrees * kDegree, side);
  };
  const std::size_t quarter = at(90.0), half = at(180.0), end = track.time.size();
  const auto position = [&](std::size_t k, Eigen::Index axis) {
    return k < end ? track.state[k].position[axis] : kNeverReached;
  };
  const bool is_whole = at(359.0) < end;
  const CoupledState& last = track.state.back();
  const double speed = last.nu.head<2>().norm();
  return {{"advance", position(quarter, 0), "m"},
          {"transfer", side * position(quarter, 1), "m"},
          {"tactical_diameter", side * position(half, 1), "m"},
          {"steady_radius", is_whole ? speed / std::abs(last.nu[5]) : kNeverReached, "m"},
          {"steady_speed", is_whole ? speed : kNeverReached, "m/s"}};
}

std::vector<ManoeuvreFigure> FiguresOfStop(const Manoeuvre& manoeuvre,
                                           const ManoeuvreTrack& track) {
  const CoupledState &first = track.state.front(), &last = track.state.back();
  const bool has_stopped = HasStopped(manoeuvre, first.nu[0], last.nu[0]);
  double reach = 0.0;
  for (std::size_t k = 1; k < track.state.size(); ++k) {
    reach += (track.state[k].position - track.state[k - 1].position).head<2>().norm();
  }
  const auto known = [&](double value) { return has_stopped ? value : kNeverReached; };
  return {{"track_reach", known(reach), "m"},
          {"head_reach", known(last.position[0]), "m"},
          {"lateral_deviation", known(last.position[1]), "m"},
          {"stop_time", known(track.time.back()), "s"}};
}

// The rudder's angle at which the yaw rate changes its sign, on a straight line between two turns.
double AngleOfNoTurn(std::span<const SteadyTurn> turns) {
  for (std::size_t k = 1; k < turns.size(); ++k) {
    const SteadyTurn &a = turns[k - 1], &b = turns[k];
    if (a.rate * b.rate > 0.0 || a.rate == b.rate) continue;
    return a.angle + (b.angle - a.angle) * a.rate / (a.rate - b.rate);
  }
  return kNeverReached;
}

double RateAtMidships(std::span<const SteadyTurn> turns) {
  const auto midships = std::ranges::find(turns, 0.0, &SteadyTurn::angle);
  return midships == turns.end() ? kNeverReached : midships->rate / kDegree;
}

std::vector<ManoeuvreFigure> FiguresOfSpiral(const ManoeuvreTrack& track) {
  const std::span<const SteadyTurn> turns = track.steady;
  const std::size_t most_to_port = turns.size() / 2;
  const auto to_port = turns.first(most_to_port + 1), back = turns.subspan(most_to_port);
  const double width = AngleOfNoTurn(back) - AngleOfNoTurn(to_port);
  return {{"loop_width", std::max(width, 0.0) / kDegree, "deg"},
          {"rate_after_starboard", RateAtMidships(to_port), "deg/s"},
          {"rate_after_port", RateAtMidships(back), "deg/s"},
          {"rate_to_starboard", turns.front().rate / kDegree, "deg/s"},
          {"rate_to_port", turns[most_to_port].rate / kDegree, "deg/s"}};
}

std::vector<ManoeuvreFigure> FiguresOfPullOut(const ManoeuvreTrack& track) {
  const std::vector<SteadyTurn>& turns = track.steady;
  return {{"rate_to_starboard", turns.at(0).rate / kDegree, "deg/s"},
          {"rate_after_starboard", turns.at(1).rate / kDegree, "deg/s"},
          {"rate_to_port", turns.at(2).rate / kDegree, "deg/s"},
          {"rate_after_port", turns.at(3).rate / kDegree, "deg/s"}};
}

}  // namespace

std::vector<ManoeuvreFigure> FiguresOf(const Manoeuvre& manoeuvre, const ManoeuvreTrack& track) {
  switch (manoeuvre.kind) {
    case Manoeuvre::Kind::kTurningCircle:
      return FiguresOfCircle(manoeuvre, track);
    case Manoeuvre::Kind::kZigzag:
      return FiguresOfZigzag(manoeuvre, track);
    case Manoeuvre::Kind::kStop:
      return FiguresOfStop(manoeuvre, track);
    case Manoeuvre::Kind::kSpiral:
      return FiguresOfSpiral(track);
    case Manoeuvre::Kind::kPullOut:
      return FiguresOfPullOut(track);
  }
  return {};
}

}  // namespace fathom
