// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/signals.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/signal/log_column.h"
#include "fathom/signal/mean_attitude.h"
#include "fathom/signal/pose_velocity.h"
#include "fathom/signal/savitzky_golay.h"
#include "fathom/signal/segment_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// The default window lies between these, docs/signal.md (4).
constexpr double kShortestWindow = 1.0;  // [s]
constexpr double kFewestSteps = 10.5;    // 11 samples
constexpr double kLongestWindow = 20.0;  // [s]
constexpr double kLongestShare = 0.1;    // of the data's duration

// Samples begin to end - 1 of the motion stream.
struct Stretch {
  size_t begin = 0;
  size_t end = 0;
  bool held_out = false;

  size_t size() const { return end - begin; }
};

bool IsHeldOut(const Log& log, double t) {
  return std::any_of(log.held_out.begin(), log.held_out.end(), [t](const TimeInterval& interval) {
    return interval.Contains(t);
  });
}

size_t FewestSamples(const SignalsOptions& options) {
  return std::max<size_t>(10, options.order + 2);
}

std::vector<Stretch> Split(const Log& log,
                           const std::vector<double>& time,
                           size_t first,
                           const SignalsOptions& options,
                           std::vector<std::string>* remarks) {
  std::vector<Stretch> stretches;
  int num_silences = 0;
  for (size_t i = first; i < time.size(); ++i) {
    const bool held_out = options.split_held_out && IsHeldOut(log, time[i]);
    const bool silence = i > first && time[i] - time[i - 1] > options.longest_gap;
    if (silence) ++num_silences;
    if (stretches.empty() || silence || stretches.back().held_out != held_out) {
      stretches.push_back({i, i, held_out});
    }
    stretches.back().end = i + 1;
  }
  if (num_silences > 0) {
    remarks->push_back(
        fmt::format("The motion is silent for over {:g} s {} time{}: each starts a "
                    "new segment.",
                    options.longest_gap,
                    num_silences,
                    num_silences == 1 ? "" : "s"));
  }
  const size_t fewest = FewestSamples(options);
  size_t num_short = 0, num_samples = 0;
  std::erase_if(stretches, [&](const Stretch& stretch) {
    if (stretch.size() >= fewest) return false;
    ++num_short;
    num_samples += stretch.size();
    return true;
  });
  if (num_short > 0) {
    remarks->push_back(fmt::format("Left out: {} segment{} of fewer than {} samples ({} samples).",
                                   num_short,
                                   num_short == 1 ? "" : "s",
                                   fewest,
                                   num_samples));
  }
  return stretches;
}

// Why no stretch of the motion is long enough: too little of it, another clock, or all in pieces.
std::string WhyNoStretch(const Log& log,
                         const Stream& stream,
                         size_t first,
                         const SignalsOptions& options) {
  const bool is_camera = options.source == Source::kCamera;
  const std::string file = is_camera ? PoseFileOf(log) : FileOf(log, "velocity.csv");
  const size_t fewest = FewestSamples(options), num = stream.time.size();
  const std::string_view what = is_camera ? "frames with a pose" : "samples";
  if (num < fewest) {
    return fmt::format("{}: holds {} {}, expected at least {} in a row.", file, num, what, fewest);
  }
  if (num - first < fewest) {
    return fmt::format(
        "{}: {} of {} {} come after the first command, expected at least {} in a row. Check the "
        "clocks of command and motion.",
        file,
        num - first,
        num,
        what,
        fewest);
  }
  return fmt::format(
      "{}: no segment between silences of over {:g} s and the ends of held-out intervals has {} "
      "{}, expected at least one.",
      file,
      options.longest_gap,
      fewest,
      what);
}

// Chosen on the longest stretch to train on (or, without one, the longest there is).
double WindowFor(std::span<const double> time,
                 std::span<const double> values,
                 const std::vector<Stretch>& stretches,
                 const SignalsOptions& options) {
  const Stretch& longest =
      *std::max_element(stretches.begin(), stretches.end(), [](const auto& a, const auto& b) {
        if (a.held_out != b.held_out) return a.held_out;
        return a.size() < b.size();
      });
  time = time.subspan(longest.begin, longest.size());
  values = values.subspan(longest.begin, longest.size());
  const double shortest = std::max(kShortestWindow, kFewestSteps * MedianStep(time));
  const double most = std::min(kLongestWindow, kLongestShare * (time.back() - time.front()));
  return ChooseWindow(time, values, options.order, shortest, std::max(shortest, most));
}

void Require(bool holds, std::string_view what) {
  if (!holds) throw InputError(fmt::format("SignalsOptions: {}", what));
}

void RequireUsable(const SignalsOptions& options) {
  Require(options.longest_gap > 0.0,
          fmt::format("longest_gap is {} s, expected more than 0.", options.longest_gap));
  Require(
      options.window >= 0.0 && std::isfinite(options.window),
      fmt::format("window is {} s, expected 0 (chosen from the data) or more.", options.window));
  Require(options.order >= 1 && options.order <= 9,
          fmt::format("order is {}, expected 1 to 9.", options.order));
}

std::string WindowRemark(double window, const SignalsOptions& options, double step) {
  return fmt::format("Savitzky-Golay: window {:.3g} s (about {:.0f} samples), order {}, {}.",
                     window,
                     std::floor(window / step) + 1,
                     options.order,
                     options.window > 0.0 ? "as given" : "chosen by cross-validation");
}

}  // namespace

Signals SignalsOf(const Log& log, Dof dof, const SignalsOptions& options) {
  RequireUsable(options);
  const bool camera = options.source == Source::kCamera;
  const Stream& stream = MotionStream(log, dof, options.source);
  const HeldCommand command = CommandOf(log, dof);
  Signals signals;
  signals.dof = dof;
  signals.source = options.source;
  signals.force_unit = log.command_unit.empty() ? std::string(ForceUnit(dof)) : log.command_unit;

  const std::vector<double>& time = stream.time;
  const size_t first =
      std::lower_bound(time.begin(), time.end(), command.time.front()) - time.begin();
  if (first > 0) {
    signals.remarks.push_back(fmt::format(
        "Left out: {} motion sample{} before the first command.", first, first == 1 ? "" : "s"));
  }
  if (const auto remark = RemarkOnEarlyEnd(command, time, options.longest_gap); !remark.empty()) {
    signals.remarks.push_back(remark);
  }
  const std::vector<Stretch> stretches = Split(log, time, first, options, &signals.remarks);
  if (stretches.empty()) throw InputError(WhyNoStretch(log, stream, first, options));

  Poses poses;
  std::vector<double> displacement;
  if (camera) {
    poses = PosesOf(stream);
    displacement = DisplacementAlong(dof, poses);
    const double turn = IsAngular(dof) ? 0.0 : AxisTurn(dof, poses.world_from_body);
    if (turn > kLargestAxisTurn) {
      signals.remarks.push_back(fmt::format(
          "The {} axis turns by {:.2f} rad RMS: the position is taken along its mean, which is "
          "short of the way.",
          Name(dof),
          turn));
    }
    if (const int flips = CountRotationFlips(poses); flips > 0) {
      signals.remarks.push_back(fmt::format(
          "{} rotation step{} that the neighbours do not support: a single square has two "
          "solutions, and the pose may have flipped between them.",
          flips,
          flips == 1 ? "" : "s"));
    }
  }
  const std::vector<double>& observed = camera ? displacement : *stream.Find(VelocityColumn(dof));
  const double window =
      options.window > 0.0 ? options.window : WindowFor(time, observed, stretches, options);
  const SavitzkyGolayOptions filter = {.window = window, .order = options.order};
  signals.remarks.push_back(WindowRemark(window, options, MedianStep(time)));

  size_t num_dropped = 0;
  for (const Stretch& stretch : stretches) {
    HeldCommand own = command.Between(time[stretch.begin], time[stretch.end - 1]);
    Motion motion;
    if (camera) {
      const std::vector<double> position(
          observed.begin() + static_cast<std::ptrdiff_t>(stretch.begin),
          observed.begin() + static_cast<std::ptrdiff_t>(stretch.end));
      motion =
          MotionFromPoses(poses.Between(stretch.begin, stretch.end), dof, position, own, filter);
      num_dropped += stretch.size() - motion.time.size();
      if (motion.time.size() < 2) continue;
    } else {
      motion = MotionFromVelocity(stream, dof, stretch.begin, stretch.end);
    }
    auto& to = stretch.held_out ? signals.held_out : signals.train;
    to.push_back(SegmentOf(std::move(motion), std::move(own), filter));
  }
  if (num_dropped > 0) {
    signals.remarks.push_back(
        fmt::format("Left out: {} pose{} with too few others within the window to tell a velocity.",
                    num_dropped,
                    num_dropped == 1 ? "" : "s"));
  }
  if (signals.train.empty()) signals.remarks.push_back("Nothing is left to train on.");
  return signals;
}

bool IsAllHeldOut(const Signals& signals) {
  return signals.train.empty() && !signals.held_out.empty();
}

void Append(const Signals& more, Signals* signals) {
  const auto append = [](auto* to, const auto& from) {
    to->insert(to->end(), from.begin(), from.end());
  };
  append(&signals->train, more.train);
  append(&signals->held_out, more.held_out);
  append(&signals->remarks, more.remarks);
}

}  // namespace fathom
