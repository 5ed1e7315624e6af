// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/description.h"

#include "fathom/diagnosis/judge/ranking.h"
#include "fathom/diagnosis/measures/explained_share.h"
#include "fathom/diagnosis/measures/limits.h"
#include "fathom/diagnosis/measures/missing_force.h"
#include "fathom/diagnosis/report/remarks.h"
#include "fathom/simulate/data_range.h"
#include "fathom/simulate/noise_floor.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

namespace fathom {
namespace {

DiagnosedModel Described(const StartedModel& model,
                         const FitFigures& train,
                         const std::vector<FreeRun>& unseen,
                         const StructureFit& weighed) {
  return {.model = model.model,
          .covariance = model.covariance,
          .train = train,
          .held_out = FiguresOfRuns(unseen),
          .weighed_log_likelihood = weighed.log_likelihood};
}

FitFigures TrainFigures(const Prepared& prepared, const ExtendedModel& model) {
  std::vector<FreeRun> runs;
  for (const MeasuredSegment& segment : prepared.data.segments()) {
    if (auto run = FreeRunOver(segment, model)) runs.push_back(*std::move(run));
  }
  return FiguresOfRuns(runs);
}

// On unseen data; where there are none, on the training data, which `traces` begin with.
double ShareOf(const Scored& unseen, const std::vector<ResidualTrace>& traces) {
  if (!unseen.before.empty()) {
    const std::array sources = {SourceRuns{unseen.before, unseen.after},
                                SourceRuns{unseen.poses_before, unseen.poses_after}};
    return ExplainedShare(sources);
  }
  std::vector<FreeRun> before, after;
  for (const ResidualTrace& trace : traces) {
    if (trace.before.empty() || trace.after.empty()) continue;
    before.push_back({trace.time, trace.measured, trace.before});
    after.push_back({trace.time, trace.measured, trace.after});
  }
  const SourceRuns runs = {before, after};
  return ExplainedShare({&runs, 1});
}

// What a cause gains beside the others on blocks or logs that are left out in turn.
double LeftOutGain(const Judgement& judgement, const Cause& cause) {
  const FreeRunComparison& runs = judgement.runs;
  const Choice& choice = judgement.choice;
  const auto& effects = choice.fit().model.effects;
  if (effects.size() == 1) return runs.gain.value;
  StructureFit without = choice.fit();
  without.model = WithoutCause(judgement, cause);
  const Scored scored = Score(*runs.parts, without, judgement.search.criterion);
  const bool acts_on_poses = effects[cause.effect_index].effect->info().needs_pose;
  return GainOf(Beside(scored, runs.unseen), acts_on_poses).value;
}

// What a cause gains on the held-out data beside the others.
double HeldOutGain(const Prepared& prepared, const Judgement& judgement, const Cause& cause) {
  if (prepared.held_out.empty()) return LeftOutGain(judgement, cause);
  const Choice& choice = judgement.choice;
  const ExtendedModel& extended = choice.fit().model;
  const ExtendedModel without =
      extended.effects.size() == 1 ? prepared.users.model : WithoutCause(judgement, cause);
  const ActiveEffect& active = extended.effects[cause.effect_index];
  const Scored scored = Score(prepared.held_out, without, extended);
  return GainOf(scored, active.effect->info().needs_pose).value;
}

// Over training data first, then over those held out.
std::vector<ResidualTrace> Traces(const Prepared& prepared, const ExtendedModel& extended) {
  const ExtendedModel& users = prepared.users.model;
  std::vector<ResidualTrace> traces;
  const auto add = [&](const std::vector<MeasuredSegment>& segments) {
    for (const MeasuredSegment& segment : segments) {
      traces.push_back(
          TraceOf(segment, FreeRunOver(segment, users), FreeRunOver(segment, extended)));
    }
  };
  add(prepared.data.segments());
  add(prepared.held_out);
  return traces;
}

// Whether a cause acts on the poses alone, or what is unexplained may.
bool MayLieInPoses(Verdict verdict, const ExtendedModel& extended) {
  if (verdict == Verdict::kUnexplained) return true;
  return std::any_of(extended.effects.begin(),
                     extended.effects.end(),
                     [](const ActiveEffect& active) { return active.effect->info().needs_pose; });
}

std::vector<ResidualTrace> PoseTraces(const MeasuredSegments& segments,
                                      const ExtendedModel& users,
                                      const ExtendedModel& extended) {
  std::vector<ResidualTrace> traces;
  if (!segments.has_velocity || !segments.has_displacement) return traces;
  for (const MeasuredSegment& segment : segments.all) {
    traces.push_back(
        TraceOf(segment, PosesByBlock(segment, users), PosesByBlock(segment, extended)));
  }
  return traces;
}

std::vector<Segment> PlainSegments(const std::vector<MeasuredSegment>& segments) {
  std::vector<Segment> plain;
  for (const MeasuredSegment& segment : segments) plain.push_back(PlainSegment(segment));
  return plain;
}

// A diagnosis whose baseline only was where searches started from: nothing is said of it.
Diagnosis WithoutBaseline(Diagnosis diagnosis) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  diagnosis.has_baseline = false;
  diagnosis.baseline = {
      .model = {{kNone, kNone, kNone, kNone}, {}},
      .covariance = Eigen::MatrixXd::Constant(kNumParameters, kNumParameters, kNone),
      .train = {kNone, kNone},
      .held_out = {kNone, kNone}};
  diagnosis.explained_share = kNone;
  diagnosis.held_out_gain = diagnosis.held_out_gain_low = diagnosis.held_out_gain_high = kNone;
  for (Cause& cause : diagnosis.causes) cause.held_out_gain = kNone;
  diagnosis.missing_force.explained.clear();
  for (auto* traces : {&diagnosis.traces, &diagnosis.pose_traces}) {
    for (ResidualTrace& trace : *traces) trace.before.clear();
  }
  return diagnosis;
}

}  // namespace

Diagnosis Described(const MeasuredSegments& segments,
                    const Prepared& prepared,
                    const Judgement& judgement,
                    Diagnosis diagnosis) {
  const StartedModel& users = prepared.users;
  const StructureFit& fit = judgement.choice.fit();
  const StartedModel extended = judgement.choice.chosen == 0 ? users : StartedFrom(fit);
  diagnosis.range = RangeOf(PlainSegments(prepared.data.segments()));
  const auto& unseen = judgement.runs.unseen;
  const auto& gain = judgement.runs.gain;
  diagnosis.verdict = judgement.verdict;
  diagnosis.baseline = Described(
      users, TrainFigures(prepared, users.model), unseen.before, judgement.search.baseline);
  diagnosis.extended =
      Described(extended, TrainFigures(prepared, extended.model), unseen.after, fit);
  diagnosis.causes = CausesOf(judgement);
  for (Cause& cause : diagnosis.causes) {
    cause.held_out_gain = HeldOutGain(prepared, judgement, cause);
  }
  diagnosis.candidates = RankCandidates(judgement);
  diagnosis.limits = LimitsOf(judgement.search.thinned,
                              judgement.book()[judgement.choice.chosen].fit,
                              judgement.search.suspects);

  const bool is_noise = judgement.verdict == Verdict::kConsistent;
  if (is_noise && !judgement.evidence.IsNegligible()) {
    diagnosis.wander_ratio = WanderRatio(prepared.data, users.residual);
  }
  const bool is_red = std::ranges::any_of(diagnosis.findings, [](const Finding& finding) {
    return finding.severity == Severity::kWarning;
  });
  diagnosis.is_only_red = is_noise && is_red;
  if (diagnosis.is_only_red) diagnosis.verdict = Verdict::kUnexplained;
  diagnosis.noise_nmae = NmaeOfScatter(unseen.after);
  diagnosis.is_only_cut = judgement.is_only_cut;
  diagnosis.coincidence = judgement.coincidence;
  diagnosis.remaining_p_value = judgement.remaining.p_value;
  diagnosis.held_out_gain = gain.value;
  diagnosis.held_out_gain_low = gain.low;
  diagnosis.held_out_gain_high = gain.high;
  diagnosis.gain_is_in_poses = gain.is_in_poses;
  diagnosis.by_left_out_blocks = prepared.held_out.empty();
  diagnosis.by_left_out_logs = unseen.by_log;
  diagnosis.num_left_out_logs = gain.num_logs;
  diagnosis.num_better_logs = gain.num_better;

  diagnosis.missing_force = FindMissingForce(prepared.data,
                                             prepared.has_baseline ? users : extended,
                                             extended,
                                             fit.noise,
                                             segments.partners);
  if (diagnosis.causes.empty() && !judgement.choice.refusals.empty()) {
    diagnosis.not_named =
        NotNamedOf(judgement.choice.refusals, diagnosis.candidates, judgement.search.suspects);
  }
  diagnosis.traces = Traces(prepared, extended.model);
  if (!diagnosis.causes.empty()) {
    diagnosis.explained_share = ShareOf(judgement.runs.unseen, diagnosis.traces);
  }
  if (MayLieInPoses(judgement.verdict, extended.model)) {
    diagnosis.pose_traces = PoseTraces(segments, users.model, extended.model);
  }
  for (std::string& remark : RemarksOnJudgement(judgement, segments.has_velocity)) {
    diagnosis.remarks.push_back(std::move(remark));
  }
  return prepared.has_baseline ? diagnosis : WithoutBaseline(std::move(diagnosis));
}

}  // namespace fathom
