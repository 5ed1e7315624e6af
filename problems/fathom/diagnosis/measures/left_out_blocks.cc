// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/left_out_blocks.h"

#include "fathom/base/parallel_for.h"
#include "fathom/diagnosis/data/part_of_segment.h"
#include "fathom/diagnosis/fit/started_model.h"

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

// Of refits that only have to predict.
constexpr FitPrecision kToPredict = {.gain = 0.1, .share = 1e-4, .turn = 0.5};
constexpr FitPrecision kToPredictFreely = {.gain = 0.1, .share = kRoughShareOfFreeRun, .turn = 0.5};

constexpr std::size_t kMostLogFolds = 8;  // with more logs, several are left out together

void Append(Scored part, Scored* all) {
  for (const auto runs :
       {&Scored::before, &Scored::after, &Scored::poses_before, &Scored::poses_after}) {
    std::move((part.*runs).begin(), (part.*runs).end(), std::back_inserter(all->*runs));
  }
}

std::vector<std::string> LogsOf(const TrainingData& data) {
  std::vector<std::string> logs;
  for (const MeasuredSegment& segment : data.segments()) {
    if (std::find(logs.begin(), logs.end(), segment.log) == logs.end()) logs.push_back(segment.log);
  }
  return logs;
}

struct Cut {
  std::vector<MeasuredSegment> left_out, kept;
};

std::vector<LeftOut> PartsOf(const Prepared& prepared, std::vector<Cut> cuts) {
  std::erase_if(cuts, [](const Cut& cut) { return cut.kept.empty() || cut.left_out.empty(); });
  const ExtendedModel& users = prepared.users.model;
  std::vector<std::optional<LeftOut>> parts(cuts.size());
  ParallelFor(static_cast<int>(cuts.size()), [&](int i) {
    TrainingData rest(std::move(cuts[i].kept), users.baseline, prepared.data.least_inertia());
    const auto anew = FindRobustStart(rest.segments());
    parts[i] = LeftOut{std::move(cuts[i].left_out), std::move(rest), anew ? anew->model : users};
  });
  std::vector<LeftOut> of_all;
  for (auto& part : parts) of_all.push_back(*std::move(part));
  return of_all;
}

// A quarter at a time, of all data or of each log.
std::vector<LeftOut> LeaveQuartersOut(const Prepared& prepared, bool is_by_log) {
  const TrainingData& data = prepared.data;
  std::map<std::string, double> totals;
  for (const MeasuredSegment& segment : data.segments()) {
    totals[is_by_log ? segment.log : ""] += segment.duration();
  }
  std::vector<Cut> cuts(kNumFolds);
  for (int fold = 0; fold < kNumFolds; ++fold) {
    auto& [left_out, kept] = cuts[fold];
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
  }
  return PartsOf(prepared, std::move(cuts));
}

std::vector<LeftOut> LeaveLogsOut(const Prepared& prepared) {
  const std::vector<std::string> logs = LogsOf(prepared.data);
  const std::size_t num_folds = std::min(logs.size(), kMostLogFolds);
  std::vector<Cut> cuts(num_folds);
  for (std::size_t fold = 0; fold < num_folds; ++fold) {
    auto& [left_out, kept] = cuts[fold];
    for (const MeasuredSegment& segment : prepared.data.segments()) {
      const auto log = std::find(logs.begin(), logs.end(), segment.log) - logs.begin();
      (log % num_folds == fold ? left_out : kept).push_back(segment);
    }
  }
  return PartsOf(prepared, std::move(cuts));
}

// A structure less the effects of logs that these data do not hold.
ExtendedModel KnownFrom(const TrainingData& data, ExtendedModel model) {
  const std::vector<std::string> logs = LogsOf(data);
  std::erase_if(model.effects, [&](const ActiveEffect& active) {
    const std::string& log = active.setting.log;
    return !log.empty() && std::find(logs.begin(), logs.end(), log) == logs.end();
  });
  return model;
}

}  // namespace

LeavingOut HowToLeaveOut(const TrainingData& data, const ExtendedModel& model) {
  const auto& effects = model.effects;
  const auto is_of_a_log = [](const ActiveEffect& active) { return !active.setting.log.empty(); };
  if (!effects.empty() && std::all_of(effects.begin(), effects.end(), is_of_a_log)) {
    return LeavingOut::kOfEachLog;
  }
  return LogsOf(data).size() > 1 ? LeavingOut::kLogs : LeavingOut::kOfAll;
}

LeftOutParts LeaveOut(const Prepared& prepared, LeavingOut how) {
  if (!prepared.held_out.empty()) return {.how = how, .parts = {}};
  if (how == LeavingOut::kLogs) return {.how = how, .parts = LeaveLogsOut(prepared)};
  return {.how = how, .parts = LeaveQuartersOut(prepared, how == LeavingOut::kOfEachLog)};
}

Scored Score(const LeftOutParts& parts, const StructureFit& extended, Criterion criterion) {
  Scored scored;
  scored.by_log = parts.how == LeavingOut::kLogs;
  std::vector<Scored> of_parts(parts.parts.size());
  ParallelFor(static_cast<int>(of_parts.size()), [&](int i) {
    const auto& [left_out, rest, users] = parts.parts[i];
    std::vector<InitialState> initial;
    for (const MeasuredSegment& segment : rest.segments()) initial.push_back(segment.initial);
    const ExtendedModel known = KnownFrom(rest, extended.model);
    const StructureFit anew =
        criterion == Criterion::kFreeRun
            ? FitBy(criterion, rest, known, initial, extended.noise, kToPredictFreely)
            : FitStructure(
                  rest, known, initial, Whitener(extended.noise, rest.samples()), kToPredict);
    of_parts[i] = Score(left_out, users, anew.model);
  });
  for (Scored& part : of_parts) Append(std::move(part), &scored);
  return scored;
}

}  // namespace fathom
