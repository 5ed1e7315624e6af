// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/measured_segments.h"

#include "fathom/base/input_error.h"
#include "fathom/diagnosis/data/log_channels.h"
#include "fathom/diagnosis/data/uneven_noise.h"
#include "fathom/log/distinct_names.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/signal/split_at_gaps.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/run_start.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr size_t kFewestSamples = 20;  // of a segment's leading channel
constexpr double kStartWindow = 2.0;   // [s] of samples behind the guess of the start

// At the first sample, by a straight line over the first two seconds, five samples at least.
Line StartOf(std::span<const double> time, std::span<const double> value) {
  std::size_t count = 0;
  while (count < time.size() && (time[count] - time[0] <= kStartWindow || count < 5)) ++count;
  return LineThrough(time[0], time.first(count), value.first(count));
}

// The samples from `from` to `to` [s], both included.
SampledSignal Between(const SampledSignal& channel, double from, double to) {
  const auto begin = std::lower_bound(channel.time.begin(), channel.time.end(), from);
  const auto end = std::upper_bound(channel.time.begin(), channel.time.end(), to);
  const auto offset = begin - channel.time.begin();
  return {{begin, end},
          {channel.value.begin() + offset, channel.value.begin() + (end - channel.time.begin())}};
}

// A segment of what all logs measure, from `from` to `to` [s]. `position`: where it starts if
// nothing measures that.
MeasuredSegment SegmentBetween(double from,
                               double to,
                               double position,
                               const LogChannels& channels,
                               const MeasuredSegments& segments) {
  MeasuredSegment segment;
  segment.log = channels.name;
  segment.stamps.start = from;
  segment.initial.position = position;
  if (segments.has_velocity) {
    SampledSignal part = Between(*channels.velocity, from, to);
    segment.stamps.velocity = std::move(part.time);
    segment.velocity = std::move(part.value);
  }
  if (segments.has_displacement) {
    SampledSignal part = Between(*channels.displacement, from, to);
    segment.stamps.displacement = std::move(part.time);
    segment.displacement = std::move(part.value);
    segment.displacement_variance =
        VarianceOverUsual(segment.stamps.displacement, segment.displacement);
  }
  RestartAt(from, &segment);
  return segment;
}

// Adds the segments of one log, cut at silences and at the ends of held-out intervals.
void AddSegmentsOf(const LogChannels& channels, Dof dof, MeasuredSegments* segments) {
  auto inputs = std::make_shared<EffectInputs>(MeasuredInputsOf(*channels.log, dof));
  inputs->log = channels.name;
  const Tone command_tone = DominantTone(inputs->command);
  const SampledSignal& leading =
      segments->has_velocity ? *channels.velocity : *channels.displacement;
  const std::vector<double>& time = leading.time;
  const size_t first =
      std::lower_bound(time.begin(), time.end(), inputs->command.time.front()) - time.begin();
  if (first > 0) {
    segments->remarks.push_back(fmt::format(
        "{}: left out: {} motion samples before the first command.", channels.name, first));
  }
  if (const auto remark = RemarkOnEarlyEnd(inputs->command, time, kLongestGap); !remark.empty()) {
    segments->remarks.push_back(channels.name + ": " + remark);
  }
  const std::vector<double> way = segments->has_displacement
                                      ? std::vector<double>(time.size(), 0.0)
                                      : WayAlong(leading.time, leading.value, first);
  const LongRanges kept =
      WithoutShort(SplitAtGaps(time, channels.log->held_out, first), kFewestSamples);
  for (const SampleRange& range : kept.ranges) {
    MeasuredSegment segment = SegmentBetween(
        time[range.begin], time[range.end - 1], way[range.begin], channels, *segments);
    segment.is_held_out = range.is_held_out;
    segment.inputs = inputs;
    segment.command_tone = command_tone;
    segments->all.push_back(std::move(segment));
  }
  if (kept.num_short > 0) {
    segments->remarks.push_back(
        fmt::format("{}: left out: {} segments of fewer than {} samples ({} samples).",
                    channels.name,
                    kept.num_short,
                    kFewestSamples,
                    kept.num_samples_in_short));
  }
}

// Other DOFs whose velocity is measured, and changes, in every segment.
std::vector<Dof> PartnersIn(std::span<const MeasuredSegment> segments, Dof dof) {
  std::vector<Dof> partners;
  for (const Dof other : kAllDofs) {
    const bool everywhere =
        other != dof &&
        std::all_of(segments.begin(), segments.end(), [&](const MeasuredSegment& segment) {
          const auto& signal = segment.inputs->velocity[Index(other)].value;
          if (signal.empty()) return false;
          const auto [least, most] = std::minmax_element(signal.begin(), signal.end());
          return *most > *least;
        });
    if (everywhere) partners.push_back(other);
  }
  return partners;
}

}  // namespace

MeasuredSegments MeasuredSegmentsOf(std::span<const Log> logs, Dof dof) {
  if (logs.empty()) throw InputError("A diagnosis needs at least one log.");
  MeasuredSegments segments;
  segments.logs = DistinctNames(logs);
  const std::vector<LogChannels> channels = ChannelsOf(logs, segments.logs, dof);
  segments.force_unit = CommandUnitOf(logs.front(), dof);
  segments.has_velocity = std::ranges::all_of(
      channels, [](const LogChannels& own) { return own.velocity.has_value(); });
  segments.has_displacement = std::ranges::all_of(
      channels, [](const LogChannels& own) { return own.displacement.has_value(); });
  for (const LogChannels& own : channels) {
    segments.poses_lose_motion = segments.poses_lose_motion || LosesMotion(own);
    segments.remarks.insert(segments.remarks.end(), own.remarks.begin(), own.remarks.end());
  }
  if (!segments.has_velocity && !segments.has_displacement) {
    throw InputError(
        "Some of the logs have velocities only and some have poses only: expected "
        "velocities in all of them or poses in all of them.");
  }
  if (segments.has_velocity && segments.has_displacement && segments.poses_lose_motion) {
    segments.remarks.push_back(
        "Not tried: pose_scale. The poses may lose motion, as their remark says. Several "
        "markers, or one seen at an angle, can show a wrong size.");
  }
  for (const LogChannels& own : channels) AddSegmentsOf(own, dof, &segments);
  const bool has_train = std::any_of(segments.all.begin(),
                                     segments.all.end(),
                                     [](const MeasuredSegment& r) { return !r.is_held_out; });
  if (!has_train) {
    throw InputError(
        fmt::format("{}: nothing is left to train on: expected a segment of at least "
                    "{} motion samples after the first command and outside held_out.",
                    logs.front().name,
                    kFewestSamples));
  }
  segments.partners = PartnersIn(segments.all, dof);
  return segments;
}

void RestartAt(double time, MeasuredSegment* segment) {
  segment->stamps.start = time;
  if (!segment->velocity.empty()) {
    segment->initial.velocity = StartOf(segment->stamps.velocity, segment->velocity).value;
  }
  if (segment->displacement.size() < 2) return;
  const auto [value, slope] = StartOf(segment->stamps.displacement, segment->displacement);
  segment->initial.position = value - slope * (segment->stamps.displacement.front() - time);
  if (segment->velocity.empty()) segment->initial.velocity = slope;
}

Segment PlainSegment(const MeasuredSegment& segment) {
  Segment plain;
  plain.command = segment.inputs->command.Between(segment.stamps.start,
                                                  segment.stamps.start + segment.duration());
  if (!segment.velocity.empty()) {
    plain.time = segment.stamps.velocity;
    plain.velocity = segment.velocity;
  } else {
    plain.time = segment.stamps.displacement;
    plain.position = segment.displacement;
    // A slope over a second: only the start of a search.
    const size_t n = plain.time.size();
    for (size_t i = 0; i < n; ++i) {
      size_t low = i, high = i;
      while (low > 0 && plain.time[i] - plain.time[low] < 0.5) --low;
      while (high + 1 < n && plain.time[high] - plain.time[i] < 0.5) ++high;
      plain.velocity.push_back((plain.position[high] - plain.position[low]) /
                               (plain.time[high] - plain.time[low]));
    }
  }
  plain.initial_velocity = segment.initial.velocity;
  return plain;
}

}  // namespace fathom
