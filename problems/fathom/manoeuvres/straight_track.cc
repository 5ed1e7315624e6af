// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/straight_track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kSameRate = 0.02;  // of what the turns differ by

double FigureNamed(const std::vector<ManoeuvreFigure>& figures, std::string_view name) {
  const auto found = std::ranges::find(figures, name, &ManoeuvreFigure::name);
  return found == figures.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

}  // namespace

bool HoldsStraightTrack(const std::vector<ManoeuvreFigure>& figures) {
  const auto figure = [&](std::string_view name) { return FigureNamed(figures, name); };
  const double left = figure("rate_after_starboard") - figure("rate_after_port");
  const double turns = figure("rate_to_starboard") - figure("rate_to_port");
  return std::abs(left) < kSameRate * std::abs(turns);
}

std::vector<std::string> StraightTrackSentences(const Manoeuvre& manoeuvre,
                                                const std::vector<ManoeuvreFigure>& figures,
                                                const std::vector<ManoeuvreFigures>& drawn) {
  const bool is_spiral = manoeuvre.kind == Manoeuvre::Kind::kSpiral;
  if (!is_spiral && manoeuvre.kind != Manoeuvre::Kind::kPullOut) return {};
  const bool holds = HoldsStraightTrack(figures);
  std::string text;
  if (holds) {
    text =
        "Stable: the rudder midships, the vehicle comes back to a straight track, whichever way it "
        "turned.";
  } else {
    text = fmt::format(
        "Not stable: the rudder midships, it goes on turning, at {:.2g} deg/s after a turn to "
        "starboard and {:.2g} deg/s after one to port.",
        FigureNamed(figures, "rate_after_starboard"),
        FigureNamed(figures, "rate_after_port"));
    const double width = FigureNamed(figures, "loop_width");
    if (is_spiral && std::isfinite(width)) {
      text += fmt::format(" Within {:.2g} degrees of the rudder it may turn either way.", width);
    }
  }
  const auto num = std::ranges::count_if(drawn, [](const auto& f) { return f.has_value(); });
  if (num == 0) return {text};
  const auto same = std::ranges::count_if(
      drawn, [&](const auto& f) { return f && HoldsStraightTrack(*f) == holds; });
  return {text + fmt::format(" {} of {} drawn models say the same.", same, num)};
}

}  // namespace fathom
