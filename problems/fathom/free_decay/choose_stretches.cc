// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/choose_stretches.h"

#include "fathom/base/median.h"
#include "fathom/base/robust_std.h"
#include "fathom/signal/signals.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

// A speed without most of its noise, and what noise may still move it by.
struct SmoothSpeed {
  std::vector<double> speed;  // signed
  std::size_t half_window = 1;
  double tolerance = 0.0;
};

SmoothSpeed SmoothSpeedOf(std::span<const double> time, std::span<const double> velocity) {
  constexpr double kWindow = 0.25;  // [s]: short against the period of a roll
  constexpr double kDeviations = 4.0, kShareOfPeak = 0.02;
  SmoothSpeed smooth;
  const double half = kWindow / 2.0 / MedianStep(time);
  smooth.half_window = std::clamp<std::size_t>(static_cast<std::size_t>(half), 1, 1000);
  std::vector<double> steps;
  double peak = 0.0;
  const std::size_t n = velocity.size(), w = smooth.half_window;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t begin = i > w ? i - w : 0, end = std::min(n, i + w + 1);
    double sum = 0.0;
    for (std::size_t k = begin; k < end; ++k) sum += velocity[k];
    smooth.speed.push_back(sum / static_cast<double>(end - begin));
    peak = std::max(peak, std::abs(smooth.speed.back()));
    // The second difference of a smooth motion is small: what is left is noise, sqrt(6) of it.
    if (i > 1) steps.push_back(std::abs(velocity[i] - 2.0 * velocity[i - 1] + velocity[i - 2]));
  }
  const double noise = steps.empty() ? 0.0 : RobustStd(std::move(steps)) / std::sqrt(6.0);
  const double left = noise / std::sqrt(static_cast<double>(2 * w + 1));
  smooth.tolerance = kDeviations * left + kShareOfPeak * peak;
  return smooth;
}

int SignOf(double speed, double tolerance) {
  if (speed > tolerance) return 1;
  return speed < -tolerance ? -1 : 0;
}

// How often the speed changes its sign, beyond noise.
int NumTurns(std::span<const double> time, std::span<const double> velocity) {
  if (velocity.size() < 3) return 0;
  const SmoothSpeed smooth = SmoothSpeedOf(time, velocity);
  int turns = 0, sign = 0;
  for (const double speed : smooth.speed) {
    const int now = SignOf(speed, smooth.tolerance);
    if (now == 0) continue;
    if (sign != 0 && now != sign) ++turns;
    sign = now;
  }
  return turns;
}

ChosenStretch StretchOf(std::span<const Segment> segments,
                        std::size_t segment,
                        std::size_t begin,
                        std::size_t end) {
  constexpr int kFewestTurns = 2;  // a current turns a vehicle round once
  const Segment& of = segments[segment];
  const auto count = end - begin;
  const std::span time = std::span(of.time).subspan(begin, count);
  const std::span velocity = std::span(of.velocity).subspan(begin, count);
  return {
      segment, begin, end, {time.front(), time.back()}, NumTurns(time, velocity) >= kFewestTurns};
}

bool IsZeroBetween(const HeldCommand& command, double from, double to) {
  return std::ranges::all_of(command.Between(from, to).value, [](double v) { return v == 0.0; });
}

// Where the decay ends that begins at the peak `start`: at a rise that no swing explains.
std::size_t EndOfDecay(const SmoothSpeed& smooth, std::size_t start) {
  const std::vector<double>& speed = smooth.speed;
  const double tolerance = smooth.tolerance;
  double ceiling = std::abs(speed[start]);  // of the swing before
  double low = ceiling, top = ceiling;
  bool is_falling = true;
  int sign = SignOf(speed[start], tolerance);
  std::size_t crossed = start;  // when the speed was last beyond noise
  for (std::size_t i = start + 1; i < speed.size(); ++i) {
    const double size = std::abs(speed[i]);
    const int now = SignOf(speed[i], tolerance);
    if (now != 0 && now != sign) {
      // Through 0 without a rest: the next swing.
      const std::size_t rest = i - crossed, swing = crossed - start;
      if (rest > std::max<std::size_t>(swing, 4 * smooth.half_window)) return crossed + 1;
      sign = now;
      ceiling = top;
      top = low = size;
      is_falling = false;
    }
    if (now != 0) crossed = i;
    if (size > ceiling + tolerance) return i;
    if (!is_falling) {
      top = std::max(top, size);
      low = size;
      if (size < top - tolerance) is_falling = true;
      continue;
    }
    if (size > low + 2.0 * tolerance) return i;
    low = std::min(low, size);
  }
  return speed.size();
}

}  // namespace

std::vector<ChosenStretch> WhereCommandIsZero(std::span<const Segment> segments,
                                              const HeldCommand& command,
                                              std::optional<double> from) {
  std::vector<ChosenStretch> stretches;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::vector<double>& time = segments[s].time;
    std::size_t begin = 0;
    const auto end_run = [&](std::size_t end) {
      if (end >= begin + kFewestOfSegment) {
        stretches.push_back(StretchOf(segments, s, begin, end));
      }
    };
    for (std::size_t i = 0; i < time.size(); ++i) {
      const bool is_early = from && time[i] < *from;
      const bool is_driven = !IsZeroBetween(command, i > 0 ? time[i - 1] : time[i], time[i]);
      // A sample at which the drive has just ended is a start, but belongs to no run before.
      if (is_early || is_driven) {
        end_run(i);
        begin = !is_early && command.At(time[i]) == 0.0 ? i : i + 1;
      }
    }
    end_run(time.size());
  }
  return stretches;
}

std::vector<ChosenStretch> FromThenOn(std::span<const Segment> segments, double from) {
  std::vector<ChosenStretch> stretches;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::vector<double>& time = segments[s].time;
    const auto begin =
        static_cast<std::size_t>(std::ranges::lower_bound(time, from) - time.begin());
    if (begin + kFewestOfSegment > time.size()) continue;
    stretches.push_back(StretchOf(segments, s, begin, time.size()));
  }
  return stretches;
}

std::vector<ChosenStretch> WhereSpeedDecays(std::span<const Segment> segments) {
  constexpr double kOfGreatest = 1.0 / 3.0, kFall = 0.8, kBegin = 0.95;
  std::vector<SmoothSpeed> smooth;
  double greatest = 0.0;
  for (const Segment& segment : segments) {
    smooth.push_back(SmoothSpeedOf(segment.time, segment.velocity));
    for (const double speed : smooth.back().speed) greatest = std::max(greatest, std::abs(speed));
  }
  std::vector<ChosenStretch> stretches;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::vector<double>& speed = smooth[s].speed;
    std::size_t next = 0;
    while (next < speed.size()) {
      // The peak of what rises from here, up to where it has fallen beyond noise.
      std::size_t peak = next, i = next;
      while (i < speed.size() &&
             std::abs(speed[i]) >= std::abs(speed[peak]) - smooth[s].tolerance) {
        if (std::abs(speed[i]) > std::abs(speed[peak])) peak = i;
        ++i;
      }
      const double height = std::abs(speed[peak]);
      const std::size_t end = EndOfDecay(smooth[s], peak);
      std::size_t begin = peak;
      while (begin < end && std::abs(speed[begin]) >= kBegin * height) ++begin;
      begin += smooth[s].half_window;
      double low = height;
      for (std::size_t k = peak; k < end; ++k) low = std::min(low, std::abs(speed[k]));
      if (height >= kOfGreatest * greatest && height > 2.0 * smooth[s].tolerance &&
          low <= kFall * height && begin + kFewestOfSegment <= end) {
        stretches.push_back(StretchOf(segments, s, begin, end));
      }
      next = std::max(end, i) + (end == peak ? 1 : 0);
    }
  }
  std::ranges::stable_sort(stretches, [](const ChosenStretch& a, const ChosenStretch& b) {
    return a.time.to - a.time.from > b.time.to - b.time.from;
  });
  return stretches;
}

}  // namespace fathom
