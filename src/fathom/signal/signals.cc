// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/signals.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/base/plural.h"
#include "fathom/signal/filter_window.h"
#include "fathom/signal/filters/mean_attitude.h"
#include "fathom/signal/filters/savitzky_golay.h"
#include "fathom/signal/pose_velocity.h"
#include "fathom/signal/segment_motion.h"
#include "fathom/signal/sources/log_column.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

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

size_t FewestSamples(const SignalsOptions& options) {
  return std::max<size_t>(kFewestOfSegment, options.order + 2);
}

// Why no range of the motion is long enough: too little of it, another clock, or all in pieces.
std::string WhyNoRange(const Log& log,
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
      "{}: no segment between gaps of over {:g} s and the ends of held-out intervals has {} {}, "
      "expected at least one.",
      file,
      options.longest_gap,
      fewest,
      what);
}

// Ranges of the motion stream, and what is to be said of the cutting.
struct Cut {
  std::vector<SampleRange> ranges;
  std::vector<std::string> remarks;
};

// From the first command on. Throws InputError if no range is long enough.
Cut CutMotion(const Log& log,
              const Stream& stream,
              const HeldCommand& command,
              const SignalsOptions& options) {
  const std::vector<double>& time = stream.time;
  const size_t first =
      std::lower_bound(time.begin(), time.end(), command.time.front()) - time.begin();
  Cut cut;
  if (first > 0) {
    cut.remarks.push_back(
        fmt::format("Left out: {} before the first command.", Plural(first, "motion sample")));
  }
  if (const auto remark = RemarkOnEarlyEnd(command, time, options.longest_gap); !remark.empty()) {
    cut.remarks.push_back(remark);
  }
  const auto held_out = options.split_held_out ? log.held_out : std::vector<TimeInterval>();
  const auto ranges = SplitAtGaps(time, held_out, first, options.longest_gap);
  const auto num_silences = std::count_if(
      ranges.begin(), ranges.end(), [](const SampleRange& range) { return range.is_after_gap; });
  if (num_silences > 0) {
    cut.remarks.push_back(
        fmt::format("The motion has gaps of over {:g} s, {}. Each gap starts a new "
                    "segment.",
                    options.longest_gap,
                    Plural(static_cast<size_t>(num_silences), "time")));
  }
  const size_t fewest = FewestSamples(options);
  LongRanges kept = WithoutShort(ranges, fewest);
  if (kept.num_short > 0) {
    cut.remarks.push_back(fmt::format("Left out: {} of fewer than {} samples ({} samples).",
                                      Plural(kept.num_short, "segment"),
                                      fewest,
                                      kept.num_samples_in_short));
  }
  if (kept.ranges.empty()) throw InputError(WhyNoRange(log, stream, first, options));
  cut.ranges = std::move(kept.ranges);
  return cut;
}

// What a source measures along one DOF, and what is to be said of it.
struct Measured {
  Poses poses;                    // of the source camera only
  std::vector<double> observed;   // its displacement; of the other source the velocity
  bool has_displacement = false;  // false where the axis turns: `observed` is then no way made good
  std::vector<std::string> remarks;
};

Measured MeasuredAlong(Dof dof, const Stream& stream, Source source) {
  Measured measured;
  if (source == Source::kPoseEstimator) {
    measured.observed = *stream.Find(VelocityColumn(dof));
    return measured;
  }
  measured.poses = PosesOf(stream);
  if (dof == Dof::kHeave && stream.Find("x") == nullptr) {
    measured.remarks.push_back(
        fmt::format("The poses hold {}: heave is taken for the vertical motion{}.",
                    stream.Find("qw") == nullptr ? "z alone" : "no x and y",
                    stream.Find("qw") == nullptr ? " of a vehicle that stays level" : ""));
  }
  measured.observed = DisplacementAlong(dof, measured.poses);
  const double turn = IsAngular(dof) ? 0.0 : AxisTurn(dof, measured.poses.world_from_body);
  measured.has_displacement = turn <= kLargestAxisTurn;
  if (!measured.has_displacement) {
    measured.remarks.push_back(
        fmt::format("The {} axis turns by {:.2f} rad RMS, so the positions are no displacement "
                    "along it. Output "
                    "error is fitted to the body velocity from the poses.",
                    Name(dof),
                    turn));
  }
  if (const int flips = CountRotationFlips(measured.poses); flips > 0) {
    measured.remarks.push_back(
        fmt::format("{} that the neighbouring poses do not confirm. A single square has two "
                    "solutions, and the pose may have flipped between them.",
                    Plural(static_cast<size_t>(flips), "rotation step")));
  }
  return measured;
}

// The motion within a range, under its command.
Motion MotionIn(const SampleRange& range,
                Dof dof,
                const Stream& stream,
                const Measured& measured,
                const HeldCommand& command,
                const SavitzkyGolayOptions& filter) {
  if (measured.poses.size() == 0) return MotionFromVelocity(stream, dof, range.begin, range.end);
  std::vector<double> position;
  if (measured.has_displacement) {
    const auto observed = measured.observed.begin();
    position.assign(observed + static_cast<std::ptrdiff_t>(range.begin),
                    observed + static_cast<std::ptrdiff_t>(range.end));
  }
  return MotionFromPoses(
      measured.poses.Between(range.begin, range.end), dof, position, command, filter);
}

// What the filter is for, and its window.
std::string WindowRemark(double window, const SignalsOptions& options, double step) {
  return fmt::format(
      "{}: window {:.3g} s (about {:.0f} samples), order {}, {}.",
      options.source == Source::kPoseEstimator
          ? "A Savitzky-Golay filter gives least squares, where fits begin, its accelerations"
          : "A Savitzky-Golay filter makes velocities of the poses",
      window,
      std::floor(window / step) + 1,
      options.order,
      options.window > 0.0 ? "as given" : "chosen by cross-validation");
}

void AddTo(std::vector<std::string>* remarks, const std::vector<std::string>& more) {
  remarks->insert(remarks->end(), more.begin(), more.end());
}

}  // namespace

Signals SignalsOf(const Log& log, Dof dof, const SignalsOptions& options) {
  RequireUsable(options);
  const Stream& stream = MotionStream(log, dof, options.source);
  const std::vector<double>& time = stream.time;
  HeldCommand command = CommandOf(log, dof);
  const Cut cut = CutMotion(log, stream, command, options);
  const Measured measured = MeasuredAlong(dof, stream, options.source);
  const double window = options.window > 0.0
                            ? options.window
                            : FilterWindowFor(time, measured.observed, cut.ranges, options.order);
  const SavitzkyGolayOptions filter = {.window = window, .order = options.order};
  Signals signals;
  signals.dof = dof;
  signals.source = options.source;
  signals.force_unit = CommandUnitOf(log, dof);
  AddTo(&signals.remarks, cut.remarks);
  AddTo(&signals.remarks, measured.remarks);
  signals.remarks.push_back(WindowRemark(window, options, MedianStep(time)));

  std::vector<HeldCommand> commands;
  for (const SampleRange& range : cut.ranges) {
    commands.push_back(command.Between(time[range.begin], time[range.end - 1]));
  }
  command = {};  // a long log's takes as much memory as its motion
  size_t num_dropped = 0;
  for (size_t k = 0; k < cut.ranges.size(); ++k) {
    const SampleRange& range = cut.ranges[k];
    Motion motion = MotionIn(range, dof, stream, measured, commands[k], filter);
    num_dropped += range.size() - motion.time.size();
    if (motion.time.size() < 2) continue;
    auto& to = range.is_held_out ? signals.held_out : signals.train;
    to.push_back(SegmentOf(std::move(motion), std::move(commands[k]), filter));
  }
  if (num_dropped > 0) {
    signals.remarks.push_back(
        fmt::format("Left out: {} with too few others within the window to compute a "
                    "velocity.",
                    Plural(num_dropped, "pose")));
  }
  if (signals.train.empty()) signals.remarks.push_back("No training data are left.");
  return signals;
}

bool IsAllHeldOut(const Signals& signals) {
  return signals.train.empty() && !signals.held_out.empty();
}

}  // namespace fathom
