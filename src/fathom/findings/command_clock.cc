// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/command_clock.h"

#include "fathom/base/median.h"
#include "fathom/signal/filters/integral.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kClockWindow = 1.0;  // [s]

// Which delays are tried: up to `longest` either way.
struct DelayGrid {
  double longest = 10.0;  // [s]
  double step = 0.05;     // [s]
};
// Clocks that have nothing to do with each other. Slower, and with fewer windows.
constexpr DelayGrid kWideGrid = {60.0, 0.25};

constexpr double kShortestSegment = 20.0;         // of a segment [s]
constexpr double kLeastCommandEvidence = 10.0;    // natural logarithm of the ratio of likelihoods
constexpr double kLeastShare = 0.25;              // of what the other terms leave, by the force
constexpr double kPeriodicCommandEvidence = 3.0;  // closer than that, two delays are as good

// What the motion did in one window.
struct Window {
  double from = 0.0, to = 0.0;
  double change = 0.0;                               // of the velocity
  Eigen::Vector3d others = Eigen::Vector3d::Zero();  // I_v, I_v|v|, W
};

// The mean of a few values about `i`: noise of single samples counts less.
double MeanAbout(const std::vector<double>& values, std::size_t i) {
  const std::size_t first = i == 0 ? 0 : i - 1, last = std::min(i + 1, values.size() - 1);
  double sum = 0.0;
  for (std::size_t k = first; k <= last; ++k) sum += values[k];
  return sum / static_cast<double>(last - first + 1);
}

void AddWindows(const Segment& segment, std::vector<Window>* windows) {
  std::vector<double> square(segment.velocity.size());
  for (std::size_t i = 0; i < square.size(); ++i) {
    square[i] = segment.velocity[i] * std::abs(segment.velocity[i]);
  }
  const std::vector<double> once = Integral(segment.time, segment.velocity);
  const std::vector<double> quadratic = Integral(segment.time, square);
  // In a gap and where a sensor is stuck the motion is not known.
  const double longest_window = kClockWindow + 3.0 * MedianStep(segment.time);
  std::size_t to = 0;
  for (std::size_t from = 0; from < segment.time.size();) {
    while (to < segment.time.size() && segment.time[to] - segment.time[from] < kClockWindow) ++to;
    if (to >= segment.time.size()) return;
    Window window = {segment.time[from], segment.time[to], 0.0, {}};
    window.change = MeanAbout(segment.velocity, to) - MeanAbout(segment.velocity, from);
    window.others = {
        once[to] - once[from], quadratic[to] - quadratic[from], window.to - window.from};
    const bool is_stuck =
        std::all_of(segment.velocity.begin() + static_cast<std::ptrdiff_t>(from),
                    segment.velocity.begin() + static_cast<std::ptrdiff_t>(to) + 1,
                    [&](double velocity) { return velocity == segment.velocity[from]; });
    if (window.to - window.from < longest_window && !is_stuck) windows->push_back(window);
    // Windows overlap by a half.
    const double next = window.from + 0.5 * kClockWindow;
    while (from < segment.time.size() && segment.time[from] < next) ++from;
  }
}

// The command's integral at any time, by a table of its own stamps.
class Impulse {
 public:
  explicit Impulse(const HeldCommand& command)
      : command_(command), sums_(IntegralsOf(command, command.time).once) {}

  double At(double t) const {
    const auto& time = command_.time;
    const auto next = std::upper_bound(time.begin(), time.end(), t);
    if (next == time.begin()) return 0.0;
    const auto i = static_cast<std::size_t>(next - time.begin() - 1);
    return sums_[i] + command_.value[i] * (t - time[i]);
  }

 private:
  const HeldCommand& command_;
  std::vector<double> sums_;
};

// What a delay leaves of the changes, squared and summed; and the same without the force.
struct Rest {
  double with_force = 0.0, without_force = 0.0;
  double slope = 0.0;  // of the change over the force

  double Correlation() const {
    const double explained = without_force > 0.0 ? 1.0 - with_force / without_force : 0.0;
    return std::copysign(std::sqrt(std::max(explained, 0.0)), slope);
  }
};

Rest RestAt(double delay, const std::vector<Window>& windows, const Impulse& impulse) {
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  Eigen::Vector3d with_change = Eigen::Vector3d::Zero(), with_force = Eigen::Vector3d::Zero();
  double change_force = 0.0, force_force = 0.0, change_change = 0.0;
  for (const Window& window : windows) {
    const double force = impulse.At(window.to - delay) - impulse.At(window.from - delay);
    gram += window.others * window.others.transpose();
    with_change += window.change * window.others;
    with_force += force * window.others;
    change_force += window.change * force;
    force_force += force * force;
    change_change += window.change * window.change;
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(gram);
  const double cross = change_force - with_change.dot(solver.solve(with_force));
  const double force_rest = force_force - with_force.dot(solver.solve(with_force));
  Rest rest;
  rest.without_force = change_change - with_change.dot(solver.solve(with_change));
  rest.slope = force_rest > 0.0 ? cross / force_rest : 0.0;
  rest.with_force = rest.without_force - rest.slope * cross;
  return rest;
}

// What each delay leaves; empty where too little is known to tell them apart.
struct Rests {
  std::vector<Rest> of_step;  // from the earliest to the latest
  int num_steps = 0;          // on either side of none
  std::size_t num_windows = 0;
};

Rests RestsOf(const HeldCommand& command,
              std::span<const Segment> segments,
              const DelayGrid& grid) {
  if (command.time.size() < 2) return {};
  std::vector<Window> windows;
  double longest = 0.0;
  for (const Segment& segment : segments) {
    const double duration = segment.time.back() - segment.time.front();
    if (duration < kShortestSegment) continue;
    longest = std::max(longest, duration);
    AddWindows(segment, &windows);
  }
  // Every delay is judged by the same windows: those whose command is known at all of them.
  const double most = std::floor(std::min(grid.longest, 0.2 * longest) / grid.step) * grid.step;
  std::erase_if(windows, [&](const Window& window) {
    return window.from - most < command.time.front() || window.to + most > command.time.back();
  });
  constexpr std::size_t kFewestWindows = 30;
  if (windows.size() < kFewestWindows) return {};
  const Impulse impulse(command);
  Rests rests = {{}, static_cast<int>(std::lround(most / grid.step)), windows.size()};
  for (int k = -rests.num_steps; k <= rests.num_steps; ++k) {
    rests.of_step.push_back(RestAt(k * grid.step, windows, impulse));
  }
  return rests;
}

// Whether the force of a delay explains a share of what the other terms leave.
bool ExplainsAShare(const Rest& rest) {
  return rest.slope > 0.0 && rest.with_force <= (1.0 - kLeastShare) * rest.without_force;
}

// The best delay of a grid, if it is better than none by far and better than all others.
std::optional<CommandDelay> BestDelay(const Rests& all, double step_of_grid) {
  const auto& [rests, num_steps, num_windows] = all;
  // Halves of the windows overlap.
  const double count = 0.25 * static_cast<double>(num_windows);
  const auto evidence = [&](const Rest& a, const Rest& b) {
    return count * std::log(std::max(b.with_force, 1e-300) / std::max(a.with_force, 1e-300));
  };
  const auto best = std::min_element(rests.begin(), rests.end(), [](const Rest& a, const Rest& b) {
    return a.with_force < b.with_force;
  });
  const int at = static_cast<int>(best - rests.begin());
  const Rest& none = rests[static_cast<std::size_t>(num_steps)];
  const CommandDelay found = {(at - num_steps) * step_of_grid, evidence(*best, none)};
  if (found.evidence < kLeastCommandEvidence || !ExplainsAShare(*best)) return std::nullopt;
  if (at == 0 || at == 2 * num_steps) return std::nullopt;  // it may be longer still
  // Another delay that is as good, beyond the valley of this one.
  for (int step : {-1, 1}) {
    int k = at;
    double highest = best->with_force;
    while (k + step >= 0 && k + step <= 2 * num_steps) {
      k += step;
      const Rest& rest = rests[static_cast<std::size_t>(k)];
      highest = std::max(highest, rest.with_force);
      const bool is_behind_a_ridge = rest.with_force < 0.8 * highest;
      if (is_behind_a_ridge && evidence(*best, rest) < kPeriodicCommandEvidence)
        return std::nullopt;
    }
  }
  return found;
}

}  // namespace

DelayCurve CommandDelayCurve(const HeldCommand& command, std::span<const Segment> segments) {
  const DelayGrid grid;
  const auto [rests, num_steps, num_windows] = RestsOf(command, segments, grid);
  DelayCurve curve;
  for (int k = 0; k < std::ssize(rests); ++k) {
    curve.delay.push_back((k - num_steps) * grid.step);
    curve.correlation.push_back(rests[static_cast<std::size_t>(k)].Correlation());
  }
  return curve;
}

std::optional<CommandDelay> FindCommandDelay(const HeldCommand& command,
                                             std::span<const Segment> segments) {
  const DelayGrid near;
  const Rests rests = RestsOf(command, segments, near);
  if (rests.of_step.empty()) return std::nullopt;
  if (const auto found = BestDelay(rests, near.step)) return found;
  // Where the force acts as it is told, the clocks are not far apart.
  if (ExplainsAShare(rests.of_step[static_cast<std::size_t>(rests.num_steps)])) return std::nullopt;
  const Rests wide = RestsOf(command, segments, kWideGrid);
  if (wide.of_step.empty()) return std::nullopt;
  return BestDelay(wide, kWideGrid.step);
}

std::optional<Finding> CheckCommandClock(const HeldCommand& command,
                                         std::span<const Segment> segments) {
  constexpr double kEarliest = -0.2, kLate = 0.3, kTooLate = 1.0;  // [s]
  const auto found = FindCommandDelay(command, segments);
  if (!found || (found->delay > kEarliest && found->delay < kLate)) return std::nullopt;
  const bool is_early = found->delay < 0.0;
  const bool is_warning = is_early || found->delay > kTooLate;
  return Finding{
      is_warning ? Severity::kWarning : Severity::kNote,
      "command_delay",
      fmt::format("The motion comes {:.2f} s {} the command. {}",
                  std::abs(found->delay),
                  is_early ? "before" : "after",
                  is_early ? "The clocks of command.csv and of the motion differ."
                  : is_warning
                      ? "The clocks of command.csv and of the motion differ, or the motion "
                        "was written down late."
                      : "Thrusters and filters may explain that, or the clocks differ.")};
}

}  // namespace fathom
