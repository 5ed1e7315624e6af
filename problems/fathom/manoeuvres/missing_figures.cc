// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/missing_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// How far the heading came to a side (1: starboard) [deg].
double FarthestTo(double side, const ManoeuvreTrack& track) {
  double farthest = 0.0;
  for (const double heading : track.heading) farthest = std::max(farthest, side * heading);
  return farthest / kDegree;
}

const char* NameOfSide(double side) { return side > 0.0 ? "starboard" : "port"; }

std::string HowFar(const Manoeuvre& manoeuvre, const ManoeuvreTrack& track) {
  const double side = manoeuvre.first_side;
  const double order = manoeuvre.heading / kDegree;
  const double first = FarthestTo(side, track), second = FarthestTo(-side, track);
  switch (manoeuvre.kind) {
    case Manoeuvre::Kind::kTurningCircle:
      return fmt::format(
          "the heading turned by {:.3g} deg; advance and transfer need 90 deg, the tactical "
          "diameter 180 deg, the steady turn 359 deg",
          first);
    case Manoeuvre::Kind::kZigzag:
      for (const auto& [to, reached] : {std::pair{side, first}, {-side, second}}) {
        if (reached >= order) continue;
        return fmt::format("the heading came {:.3g} deg to {}, short of the order of {:g} deg",
                           reached,
                           NameOfSide(to),
                           order);
      }
      return fmt::format(
          "the heading came {:.3g} deg to {} and {:.3g} deg to {}; an overshoot counts only where "
          "the heading then comes back by more than 0.5 deg",
          first,
          NameOfSide(side),
          second,
          NameOfSide(-side));
    case Manoeuvre::Kind::kStop:
      return fmt::format("the vehicle did not stop: its speed ahead is still {:.3g} m/s",
                         track.state.back().nu[0]);
    case Manoeuvre::Kind::kSpiral:
    case Manoeuvre::Kind::kPullOut:
      break;
  }
  return "";
}

}  // namespace

std::vector<std::string> MissingFigureSentences(const Manoeuvre& manoeuvre,
                                                const ManoeuvreTrack& track,
                                                const std::vector<ManoeuvreFigure>& figures) {
  const auto num_missing = std::ranges::count_if(
      figures, [](const ManoeuvreFigure& figure) { return !std::isfinite(figure.value); });
  if (num_missing == 0) return {};
  const std::string how_far = HowFar(manoeuvre, track);
  if (how_far.empty()) return {};
  return {fmt::format("{}: within the {:.4g} s of the run {}.",
                      num_missing == std::ssize(figures) ? "No figures" : "Not all figures",
                      track.time.back(),
                      how_far)};
}

}  // namespace fathom
