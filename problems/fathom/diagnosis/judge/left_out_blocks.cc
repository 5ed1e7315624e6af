// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/left_out_blocks.h"

#include "fathom/diagnosis/fit/robust_start.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr int kNumFolds = 4;

// The samples of a segment within [from, to].
MeasuredSegment Between(const MeasuredSegment& segment, double from, double to) {
  MeasuredSegment part = segment;
  const auto cut = [&](std::vector<double>* time,
                       std::initializer_list<std::vector<double>*> values) {
    const auto begin = std::lower_bound(time->begin(), time->end(), from) - time->begin();
    const auto end = std::upper_bound(time->begin(), time->end(), to) - time->begin();
    for (std::vector<double>* value : values) {
      if (!value->empty()) *value = {value->begin() + begin, value->begin() + end};
    }
    *time = {time->begin() + begin, time->begin() + end};
  };
  cut(&part.stamps.velocity, {&part.velocity});
  cut(&part.stamps.displacement, {&part.displacement, &part.displacement_variance});
  return part;
}

// Where nothing measures the position: along the measured velocity, as MeasuredSegmentsOf() counts
// it.
double PositionAt(const MeasuredSegment& segment, double time) {
  double position = segment.initial.position;
  const std::vector<double>& t = segment.stamps.velocity;
  for (size_t i = 1; i < t.size() && t[i] <= time; ++i) {
    position += 0.5 * (t[i] - t[i - 1]) * (segment.velocity[i - 1] + segment.velocity[i]);
  }
  return position;
}

void Append(Scored part, Scored* all) {
  for (const auto runs :
       {&Scored::before, &Scored::after, &Scored::poses_before, &Scored::poses_after}) {
    std::move((part.*runs).begin(), (part.*runs).end(), std::back_inserter(all->*runs));
  }
}

}  // namespace

Scored LeaveBlocksOut(const TrainingData& data,
                      const ExtendedModel& baseline,
                      const StructureFit& extended) {
  Scored scored;
  // What belongs to one log alone is known from its other blocks only: then each log leaves out its
  // own.
  const auto& effects = extended.model.effects;
  const bool is_by_log = std::any_of(effects.begin(), effects.end(), [](const auto& active) {
    return !active.setting.log.empty();
  });
  std::map<std::string, double> totals;
  for (const MeasuredSegment& segment : data.segments()) {
    totals[is_by_log ? segment.log : ""] += segment.duration();
  }
  for (int fold = 0; fold < kNumFolds; ++fold) {
    std::vector<MeasuredSegment> kept, left_out;
    std::map<std::string, double> passed_of;
    for (const MeasuredSegment& segment : data.segments()) {
      const std::string of = is_by_log ? segment.log : "";
      const double total = totals[of];
      double& passed = passed_of[of];
      const double from = total * fold / kNumFolds, to = total * (fold + 1) / kNumFolds;
      const double start = segment.stamps.start, end = start + segment.duration();
      const double low = std::clamp(start + from - passed, start, end);
      const double high = std::clamp(start + to - passed, start, end);
      passed += segment.duration();
      const auto add = [&](MeasuredSegment part, std::vector<MeasuredSegment>* to_list) {
        const auto& time = part.velocity.empty() ? part.stamps.displacement : part.stamps.velocity;
        if (time.size() < 20) return;
        if (part.displacement.empty()) part.initial.position = PositionAt(segment, time.front());
        RestartAt(time.front(), &part);
        to_list->push_back(std::move(part));
      };
      if (low > start) add(Between(segment, start, low - 1e-9), &kept);
      if (high > low) add(Between(segment, low, high), &left_out);
      if (high < end) add(Between(segment, high + 1e-9, end), &kept);
    }
    if (kept.empty() || left_out.empty()) continue;
    std::vector<InitialState> initial;
    for (const MeasuredSegment& segment : kept) initial.push_back(segment.initial);
    const TrainingData rest(std::move(kept), baseline.baseline, data.least_inertia());
    const Whitener whitener(extended.noise, rest.samples());
    const auto before = FindRobustStart(rest.segments());
    const StructureFit after = FitStructure(rest, extended.model, initial, whitener);
    Append(Score(left_out, before ? before->model : baseline, after.model), &scored);
  }
  return scored;
}

}  // namespace fathom
