// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/measured_gear.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace fathom {
namespace {

constexpr double kRightAngleDegrees = 90.0;
constexpr double kOver = 0.8;   // of the largest angle: the rudder is over
constexpr double kSlope = 0.6;  // of it: between these on either side the slope is taken
constexpr std::array kUsualOrders = {
    1.0, 2.0, 3.0, 5.0, 7.5, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 60.0};  // [deg]
constexpr double kHeadingNoise = 0.25;                  // of a measured heading, at most [deg]
constexpr double kWildShare = 0.5, kWildDegrees = 1.0;  // beyond the order, at most, of a zigzag

// From one side to the other, side 1 being starboard.
struct Stroke {
  double from_side = 1.0;
  double zero = 0.0;      // when the rudder is midships [s]
  double duration = 0.0;  // between kSlope of the angle on either side [s]
};

// When a line between samples reaches a value, the last time before `end`.
double LastReaching(const std::vector<double>& time,
                    const std::vector<double>& values,
                    std::size_t end,
                    double value) {
  for (std::size_t k = end; k > 0; --k) {
    const double a = values[k - 1] - value, b = values[k] - value;
    if (a * b > 0.0 || a == b) continue;
    return time[k - 1] + (time[k] - time[k - 1]) * a / (a - b);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<Stroke> StrokesOf(const ManoeuvreTrack& logged,
                              const std::vector<double>& angle,
                              double largest) {
  std::vector<Stroke> strokes;
  double side = 0.0;
  for (std::size_t k = 0; k < angle.size(); ++k) {
    if (std::abs(angle[k]) < kOver * largest) continue;
    const double now = angle[k] > 0.0 ? 1.0 : -1.0;
    if (side != 0.0 && now != side) {
      const auto reaching = [&](double share) {
        return LastReaching(logged.time, angle, k, share * side * largest);
      };
      strokes.push_back({side, reaching(0.0), reaching(-kSlope) - reaching(kSlope)});
    }
    side = now;
  }
  return strokes;
}

// From one to the next [s].
double SampleOf(const ManoeuvreTrack& logged) {
  return (logged.time.back() - logged.time.front()) / static_cast<double>(logged.time.size());
}

double HeadingAt(const ManoeuvreTrack& logged, double t) {
  const auto next = std::ranges::lower_bound(logged.time, t);
  if (next == logged.time.begin()) return logged.heading.front();
  if (next == logged.time.end()) return logged.heading.back();
  const auto k = static_cast<std::size_t>(next - logged.time.begin());
  const double share = (t - logged.time[k - 1]) / (logged.time[k] - logged.time[k - 1]);
  return (1.0 - share) * logged.heading[k - 1] + share * logged.heading[k];
}

// The course midway between the headings at which strokes to either side begin.
double CourseOf(const std::vector<Stroke>& strokes, const std::vector<double>& headings) {
  std::vector<double> from_starboard, from_port;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    (strokes[k].from_side > 0.0 ? from_starboard : from_port).push_back(headings[k]);
  }
  if (from_starboard.empty() || from_port.empty()) return std::numeric_limits<double>::quiet_NaN();
  return 0.5 * (Median(from_starboard) + Median(from_port));
}

// Adds what is known of a zigzag, if it is one.
void AddZigzag(const ManoeuvreTrack& logged,
               const std::vector<Stroke>& strokes,
               MeasuredGear* gear) {
  constexpr double kInDegrees = std::numbers::pi / 180.0;
  std::vector<double> begins, headings;
  for (const Stroke& stroke : strokes) {
    begins.push_back(stroke.zero - gear->angle / gear->rate);
    headings.push_back(HeadingAt(logged, begins.back()));
  }
  const double course = CourseOf(strokes, headings);
  if (!std::isfinite(course)) return;
  const double sample = SampleOf(logged);
  double least = kRightAngleDegrees, most = 0.0;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    const auto beyond = [&](double heading) {
      return strokes[k].from_side * (heading - course) / kInDegrees;
    };
    // A rudder that goes over from one sample to the next seems to begin between them: by the later
    // one its order was reached.
    least = std::min(least, beyond(HeadingAt(logged, begins[k] + sample)) + kHeadingNoise);
    most = std::max(most, beyond(headings[k]));
  }
  const auto above = std::ranges::upper_bound(kUsualOrders, least);
  if (above == kUsualOrders.begin()) return;
  const double order = *(above - 1);
  if (most > (1.0 + kWildShare) * order + kWildDegrees) return;
  std::vector<double> delays;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    const auto end =
        std::ranges::lower_bound(logged.time, begins[k] + sample) - logged.time.begin();
    const double reached =
        LastReaching(logged.time,
                     logged.heading,
                     std::min(static_cast<std::size_t>(end), logged.time.size() - 1),
                     course + strokes[k].from_side * order * kInDegrees);
    if (std::isfinite(reached)) delays.push_back(std::max(begins[k] - reached, 0.0));
  }
  if (delays.empty()) return;
  gear->heading = order * kInDegrees;
  gear->course = course;
  gear->delay = Median(delays);
  gear->least_delay = std::ranges::min(delays);
  gear->most_delay = std::ranges::max(delays);
}

}  // namespace

std::optional<MeasuredGear> GearOf(const ManoeuvreTrack& logged) {
  std::vector<double> angle = logged.angle;
  double largest = 0.0;
  for (double& value : angle) {
    value *= logged.fin_sign;
    largest = std::max(largest, std::abs(value));
  }
  const std::vector<Stroke> strokes = StrokesOf(logged, angle, largest);
  if (strokes.empty()) return std::nullopt;
  std::vector<double> stands, durations;
  for (const double value : angle) {
    if (std::abs(value) >= kOver * largest) stands.push_back(std::abs(value));
  }
  for (const Stroke& stroke : strokes) durations.push_back(stroke.duration);
  MeasuredGear gear;
  gear.num_strokes = static_cast<int>(strokes.size());
  gear.angle = Median(stands);
  const double duration = Median(durations);
  if (duration > SampleOf(logged)) gear.rate = 2.0 * kSlope * largest / duration;
  AddZigzag(logged, strokes, &gear);
  return gear;
}

}  // namespace fathom
