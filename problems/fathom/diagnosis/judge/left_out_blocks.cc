// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/left_out_blocks.h"

#include "fathom/diagnosis/data/part_of_segment.h"
#include "fathom/diagnosis/fit/robust_start.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr int kNumFolds = 4;

void Append(Scored part, Scored* all) {
  for (const auto runs :
       {&Scored::before, &Scored::after, &Scored::poses_before, &Scored::poses_after}) {
    std::move((part.*runs).begin(), (part.*runs).end(), std::back_inserter(all->*runs));
  }
}

}  // namespace

std::vector<LeftOut> LeaveBlocksOut(const Prepared& prepared, LeavingOut leaving_out) {
  const TrainingData& data = prepared.data;
  const bool is_by_log = leaving_out == LeavingOut::kOfEachLog;
  std::map<std::string, double> totals;
  for (const MeasuredSegment& segment : data.segments()) {
    totals[is_by_log ? segment.log : ""] += segment.duration();
  }
  std::vector<LeftOut> parts;
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
      const auto add = [&](std::optional<MeasuredSegment> part,
                           std::vector<MeasuredSegment>* list) {
        if (part) list->push_back(*std::move(part));
      };
      if (low > start) add(PartOf(segment, start, low - 1e-9), &kept);
      if (high > low) add(PartOf(segment, low, high), &left_out);
      if (high < end) add(PartOf(segment, high + 1e-9, end), &kept);
    }
    if (kept.empty() || left_out.empty()) continue;
    const ExtendedModel& users = prepared.users.model;
    TrainingData rest(std::move(kept), users.baseline, data.least_inertia());
    const auto anew = FindRobustStart(rest.segments());
    parts.push_back({std::move(left_out), std::move(rest), anew ? anew->model : users});
  }
  return parts;
}

Scored Score(const std::vector<LeftOut>& parts, const StructureFit& extended, Criterion criterion) {
  Scored scored;
  for (const auto& [left_out, rest, users] : parts) {
    std::vector<InitialState> initial;
    for (const MeasuredSegment& segment : rest.segments()) initial.push_back(segment.initial);
    const StructureFit anew =
        criterion == Criterion::kFreeRun
            ? FitBy(criterion, rest, extended.model, initial, extended.noise)
            : FitStructure(rest, extended.model, initial, Whitener(extended.noise, rest.samples()));
    Append(Score(left_out, users, anew.model), &scored);
  }
  return scored;
}

}  // namespace fathom
