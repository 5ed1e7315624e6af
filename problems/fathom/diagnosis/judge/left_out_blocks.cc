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

// The samples of a record within [from, to].
Record Between(const Record& record, double from, double to) {
  Record part = record;
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

// Where nothing measures the position: along the measured velocity, as RecordsOf() counts it.
double PositionAt(const Record& record, double time) {
  double position = record.initial.position;
  const std::vector<double>& t = record.stamps.velocity;
  for (size_t i = 1; i < t.size() && t[i] <= time; ++i) {
    position += 0.5 * (t[i] - t[i - 1]) * (record.velocity[i - 1] + record.velocity[i]);
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
  for (const Record& record : data.records()) {
    totals[is_by_log ? record.log : ""] += record.duration();
  }
  for (int fold = 0; fold < kNumFolds; ++fold) {
    std::vector<Record> kept, left_out;
    std::map<std::string, double> passed_of;
    for (const Record& record : data.records()) {
      const std::string of = is_by_log ? record.log : "";
      const double total = totals[of];
      double& passed = passed_of[of];
      const double from = total * fold / kNumFolds, to = total * (fold + 1) / kNumFolds;
      const double start = record.stamps.start, end = start + record.duration();
      const double low = std::clamp(start + from - passed, start, end);
      const double high = std::clamp(start + to - passed, start, end);
      passed += record.duration();
      const auto add = [&](Record part, std::vector<Record>* to_list) {
        const auto& time = part.velocity.empty() ? part.stamps.displacement : part.stamps.velocity;
        if (time.size() < 20) return;
        if (part.displacement.empty()) part.initial.position = PositionAt(record, time.front());
        RestartAt(time.front(), &part);
        to_list->push_back(std::move(part));
      };
      if (low > start) add(Between(record, start, low - 1e-9), &kept);
      if (high > low) add(Between(record, low, high), &left_out);
      if (high < end) add(Between(record, high + 1e-9, end), &kept);
    }
    if (kept.empty() || left_out.empty()) continue;
    std::vector<InitialState> initial;
    for (const Record& record : kept) initial.push_back(record.initial);
    const TrainingData rest(std::move(kept), baseline.baseline, data.least_inertia());
    const Whitener whitener(extended.noise, rest.samples());
    const auto before = FindRobustStart(rest.records());
    const StructureFit after = FitStructure(rest, extended.model, initial, whitener);
    Append(Score(left_out, before ? before->model : baseline, after.model), &scored);
  }
  return scored;
}

}  // namespace fathom
