// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/diagnosis.h"

#include "fathom/base/input_error.h"
#include "fathom/diagnosis/data/records.h"
#include "fathom/diagnosis/data/thinned.h"
#include "fathom/diagnosis/fit/outliers.h"
#include "fathom/diagnosis/fit/remaining_structure.h"
#include "fathom/diagnosis/fit/robust_start.h"
#include "fathom/diagnosis/fit/structure_fit.h"
#include "fathom/diagnosis/judge/evidence_remarks.h"
#include "fathom/diagnosis/judge/held_out.h"
#include "fathom/diagnosis/judge/left_out_blocks.h"
#include "fathom/diagnosis/judge/missing_force.h"
#include "fathom/diagnosis/judge/ranking.h"
#include "fathom/diagnosis/judge/refutation.h"
#include "fathom/diagnosis/search/search.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kMaterialShare = 0.05;  // of all structure, below which the rest is no matter
constexpr double kLossTooMuchInTraining = 0.1;  // of NMAE, at which nothing is named
constexpr double kLossWorthAWord = 0.02;        // of held-out NMAE
// The least inertia that a fit may try, of the smaller of the baseline's and output error's. Far
// below the truth a run takes ever more steps; but where the baseline leaves the inertia open, it
// is no measure of the truth.
constexpr double kLeastInertia = 0.1, kLeastInertiaIfOpen = 0.01;
// About five for each unknown of a model with three causes.
constexpr size_t kLeastSamples = 60;

std::vector<Record> Part(const std::vector<Record>& records, bool held_out) {
  std::vector<Record> part;
  for (const Record& record : records) {
    if (record.is_held_out == held_out) part.push_back(record);
  }
  return part;
}

DiagnosedModel Describe(const TrainingData& data, const StructureFit& fit) {
  DiagnosedModel described;
  described.model = fit.model;
  described.covariance = fit.covariance;
  described.log_likelihood = fit.log_likelihood;
  std::vector<FreeRun> runs;
  for (size_t r = 0; r < data.records().size(); ++r) {
    if (auto run = FreeRunOver(data.records()[r], fit.model, fit.initial[r])) {
      runs.push_back(std::move(*run));
    }
  }
  described.train = FiguresOfRuns(runs);
  return described;
}

// Output error's model, as fathom_identify gives it: what the user has, and what free runs are
// judged against. In the baseline's own fit what is missing passes for noise; it is for weighing
// causes, and runs worse.
StructureFit UsersModel(const TrainingData& data,
                        const RobustStart& start,
                        const StructureFit& baseline) {
  StructureFit users = FitStates(data, start.model, start.initial);
  if (users.jacobian.size() == 0) return baseline;
  users.covariance = start.covariance;
  users.log_likelihood = baseline.log_likelihood;
  users.noise = baseline.noise;
  return users;
}

// Fits the best hypothesis to all data, and takes from it every cause that they do not call for:
// what answers to the thinning itself shows here.
void ConfirmOnAllData(const TrainingData& data,
                      const StructureFit& baseline,
                      const DiagnosisOptions& options,
                      SearchResult* search) {
  std::map<int, StructureFit> fits = {{0, baseline}};
  const auto fit_of = [&](int index) -> const StructureFit& {
    if (const auto found = fits.find(index); found != fits.end()) return found->second;
    const StructureFit& rough = search->tried[index].fit;
    return fits[index] = FitStructureAndNoise(data, rough.model, rough.initial, rough.noise);
  };
  const auto worth = [&](int index) {
    return 2.0 * (fit_of(index).log_likelihood - baseline.log_likelihood) -
           PriceOfStarts(data, fit_of(index)) - ThresholdOf(*search, search->tried[index].suspects);
  };
  for (bool is_settled = false; !is_settled;) {
    is_settled = true;
    const int best = search->best;
    for (const int suspect : search->tried[best].suspects) {
      const Hypothesis* without = FindWithout(*search, best, suspect);
      if (without == nullptr || !IsPhysical(*without)) continue;
      const auto index = static_cast<int>(without - search->tried.data());
      if (worth(index) < worth(search->best)) continue;
      search->best = index;
      is_settled = false;
    }
  }
  if (fit_of(search->best).jacobian.size() == 0) search->best = 0;
  search->tried[search->best].fit = fit_of(search->best);
  search->rivals = FindRivals(data, *search, options.separation);
}

size_t NumSamples(const std::vector<Record>& records) {
  size_t count = 0;
  for (const Record& record : records) count += record.velocity.size() + record.displacement.size();
  return count;
}

// The search over thinned data, confirmed on all of them.
SearchResult SearchThinned(const TrainingData& data,
                           const std::vector<Record>& thinned_records,
                           const StructureFit& baseline,
                           const StructureFit& users,
                           const std::vector<Suspect>& suspects,
                           const DiagnosisOptions& options) {
  const double inertia = std::min(baseline.model.baseline.inertia, users.model.baseline.inertia);
  const bool is_open =
      !baseline.is_on_bound[kInertia] &&
      !(std::sqrt(baseline.covariance(kInertia, kInertia)) < baseline.model.baseline.inertia);
  const TrainingData thinned(thinned_records,
                             baseline.model.baseline,
                             (is_open ? kLeastInertiaIfOpen : kLeastInertia) * inertia);
  const StructureFit rough =
      FitStructureAndNoise(thinned, baseline.model, baseline.initial, baseline.noise);
  SearchResult search =
      SearchCauses(thinned, rough.jacobian.size() == 0 ? baseline : rough, suspects, options);
  ConfirmOnAllData(data, baseline, options, &search);
  search.tried[0].fit = baseline;
  return search;
}

// True if what the best hypothesis leaves is more than noise, and a matter.
bool Remains(const RemainingStructure& remaining, const SearchResult& search) {
  const double all_structure = search.tried[search.best].gain + remaining.gain;
  return remaining.p_value < RemainingStructure::kClear &&
         remaining.gain - remaining.num_columns > kMaterialShare * all_structure;
}

// Share of the baseline's squared error that is more than noise.
double StructureShare(const StructureFit& baseline, const StructureFit& best) {
  const double before = baseline.residual.squaredNorm();
  return before > 0.0 ? std::clamp(1.0 - best.residual.squaredNorm() / before, 0.0, 1.0) : 0.0;
}

// Whether a cause acts on the poses alone, or what is unexplained may.
bool MayLieInPoses(const Diagnosis& diagnosis) {
  if (diagnosis.verdict == Verdict::kUnexplained) return true;
  const auto& effects = diagnosis.extended.model.effects;
  return std::any_of(effects.begin(), effects.end(), [](const ActiveEffect& active) {
    return active.effect->info().needs_pose;
  });
}

}  // namespace

Diagnosis Diagnose(std::span<const Log> logs, Dof dof, const DiagnosisOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty())
    throw InputError(problems.front());
  const Records records = RecordsOf(logs, dof);
  Diagnosis diagnosis;
  diagnosis.dof = dof;
  diagnosis.force_unit = records.force_unit;
  diagnosis.logs = records.logs;
  diagnosis.fits_displacement = records.has_displacement;
  diagnosis.has_velocity = records.has_velocity;
  diagnosis.remarks = records.remarks;

  std::vector<Record> train = Part(records.all, false);
  const auto start = FindRobustStart(train);
  if (!start) {
    diagnosis.message = fmt::format(
        "output error finds no physical baseline model along {}, and without one there is nothing "
        "to diagnose. fathom_identify says why.",
        Name(dof));
    return diagnosis;
  }
  if (const int count = RemoveOutliers(start->model, start->initial, &train); count > 0) {
    diagnosis.remarks.push_back(fmt::format("Left out: {} single sample{} far from {} neighbours.",
                                            count,
                                            count == 1 ? "" : "s",
                                            count == 1 ? "its" : "their"));
  }
  const std::vector<Record> thinned = Thinned(train);
  if (NumSamples(thinned) < kLeastSamples) {
    diagnosis.message = fmt::format(
        "the training data are {} samples (at 10 Hz at most), expected at least {}: with fewer, "
        "structure cannot be told from noise.",
        NumSamples(thinned),
        kLeastSamples);
    return diagnosis;
  }
  const TrainingData data(
      std::move(train), start->model.baseline, kLeastInertiaIfOpen * start->model.baseline.inertia);
  const StructureFit baseline = FitBaseline(data, start->model, start->initial);
  if (baseline.jacobian.size() == 0) {
    diagnosis.message = "the baseline model cannot be simulated over these logs.";
    return diagnosis;
  }

  const StructureFit users = UsersModel(data, *start, baseline);

  const std::vector<const Effect*> effects =
      options.effects.empty()
          ? std::vector<const Effect*>(EffectCatalogue().begin(), EffectCatalogue().end())
          : options.effects;
  const bool is_negligible = IsNegligible(data, baseline);
  const std::vector<Suspect> suspects =
      is_negligible ? std::vector<Suspect>() : SuspectsFor(records, dof, effects);
  SearchResult search = SearchThinned(data, thinned, baseline, users, suspects, options);
  const std::vector<Record> held_out = Part(records.all, true);
  diagnosis.by_left_out_blocks = held_out.empty();
  const auto leave_out = [&](Burden burden) {
    LeaveOutTheRefuted(data, held_out, suspects, options, burden, &search, &diagnosis.remarks);
  };
  leave_out(Burden::kNotToLose);
  const auto find_remaining = [&] {
    const StructureFit& fit = search.tried[search.best].fit;
    return is_negligible ? RemainingStructure() : FindRemainingStructure(data, fit);
  };
  // The causes may stand in for what nothing explains; unseen data tell.
  if (!held_out.empty() && Remains(find_remaining(), search)) leave_out(Burden::kToGain);
  Scored scored;
  if (held_out.empty()) {
    scored = LeaveBlocksOut(data, users.model, search.tried[search.best].fit);
  } else {
    Score(held_out, users.model, search.tried[search.best].fit.model, &scored);
  }
  const auto keep_none = [&] {
    scored.after = scored.before;
    scored.poses_after = scored.poses_before;
  };
  if (search.best == 0) keep_none();
  const auto gain_of_best = [&] {
    const bool on_poses = ActOnPosesAlone(search.tried[search.best].suspects, suspects);
    return GainOf(scored, on_poses, options.seed);
  };
  Gain gain = gain_of_best();
  diagnosis.baseline = Describe(data, users);
  diagnosis.extended =
      search.best == 0 ? diagnosis.baseline : Describe(data, search.tried[search.best].fit);
  // Of blocks left out in turn the models are refitted on less: only what is certain counts.
  std::optional<Gain> loss = RefutingGain(scored, gain.is_in_poses, options.seed);
  if (diagnosis.by_left_out_blocks && !gain.is_in_poses && !(gain.high < 0.0)) loss.reset();
  const bool runs_worse = diagnosis.extended.train.nmae >
                          (1.0 + kLossTooMuchInTraining) * diagnosis.baseline.train.nmae;
  const bool is_refuted = search.best != 0 && (loss || runs_worse);
  if (is_refuted) {
    diagnosis.remarks.push_back(fmt::format(
        "Not named: {}. It is the likeliest, but {}.",
        LabelsOf(search.tried[search.best].suspects, suspects),
        loss ? fmt::format("on data that no fit has seen the error grows by {:.0f} % ({:.0f} to "
                           "{:.0f} %)",
                           -100.0 * loss->value,
                           -100.0 * loss->high,
                           -100.0 * loss->low)
             : fmt::format("with it NMAE on the training data themselves grows from {:.2g} to "
                           "{:.2g}",
                           diagnosis.baseline.train.nmae,
                           diagnosis.extended.train.nmae)));
    search.best = 0;
    search.rivals.clear();
    diagnosis.extended = diagnosis.baseline;
    keep_none();
    gain = gain_of_best();
  }
  const Hypothesis& best = search.tried[search.best];
  const RemainingStructure remaining = find_remaining();
  const bool remains = Remains(remaining, search);
  if (remaining.num_columns == 0 && !is_negligible) {
    diagnosis.remarks.push_back(
        "Not looked for: structure that no effect of the catalogue accounts for. The training data "
        "are too few for that.");
  }
  if (remains) {
    // What nothing explains gains so much per column: then it takes as many times more to tell two
    // causes apart, either of which may stand in for it.
    const double times_noise = remaining.gain / remaining.num_columns;
    search.rivals = FindRivals(data, search, options.separation * std::max(1.0, times_noise));
  }

  const StructureFit& extended = best.suspects.empty() ? users : best.fit;
  diagnosis.remaining_p_value = remaining.p_value;
  const double all_structure = best.gain + remaining.gain;
  diagnosis.explained_share = all_structure > 0.0 ? best.gain / all_structure : 0.0;
  diagnosis.structure_share = StructureShare(users, extended);
  if (remains || is_refuted) {
    diagnosis.verdict = Verdict::kUnexplained;
  } else if (best.suspects.empty()) {
    diagnosis.verdict = Verdict::kConsistent;
  } else {
    diagnosis.verdict = search.rivals.empty() ? Verdict::kExplained : Verdict::kAmbiguous;
  }
  if (diagnosis.verdict == Verdict::kConsistent && !is_negligible) {
    diagnosis.wander_ratio = WanderRatio(data, users);
  }
  diagnosis.causes = CausesOf(search, suspects);
  AddRemarksOnTheEvidence(data, baseline, &diagnosis);
  diagnosis.candidates = RankCandidates(search, suspects);

  diagnosis.baseline.held_out = FiguresOfRuns(scored.before);
  diagnosis.extended.held_out = FiguresOfRuns(scored.after);
  diagnosis.gain_is_in_poses = gain.is_in_poses;
  diagnosis.held_out_gain = gain.value;
  diagnosis.held_out_gain_low = gain.low;
  diagnosis.held_out_gain_high = gain.high;
  if (!diagnosis.causes.empty() && gain.value < -kLossWorthAWord) {
    diagnosis.remarks.push_back(
        "Data that no fit has seen do not bear out what is named: the error on them grows. Do not "
        "build on it before another run confirms it.");
  }
  for (Cause& cause : diagnosis.causes) {
    const ExtendedModel without =
        diagnosis.causes.size() == 1 ? users.model : WithoutCause(search, suspects, cause);
    Scored own;
    if (!held_out.empty()) {
      Score(held_out, without, extended.model, &own);
      const ActiveEffect& active = extended.model.effects[cause.effect_index];
      cause.held_out_gain = GainOf(own, active.effect->info().needs_pose, options.seed).value;
    } else {
      cause.held_out_gain = gain.value;
    }
  }

  diagnosis.missing_force = FindMissingForce(data, users, extended, records.partners);
  for (size_t r = 0; r < data.records().size(); ++r) {
    const Record& record = data.records()[r];
    diagnosis.traces.push_back(TraceOf(record,
                                       FreeRunOver(record, users.model, users.initial[r]),
                                       FreeRunOver(record, extended.model, extended.initial[r])));
  }
  for (const Record& record : held_out) {
    diagnosis.traces.push_back(
        TraceOf(record, FreeRunOver(record, users.model), FreeRunOver(record, extended.model)));
  }
  const bool has_velocity_and_poses = records.has_velocity && records.has_displacement;
  if (has_velocity_and_poses && MayLieInPoses(diagnosis)) {
    for (const Record& record : records.all) {
      diagnosis.pose_traces.push_back(
          TraceOf(record, PosesByBlock(record, users.model), PosesByBlock(record, extended.model)));
    }
  }
  return diagnosis;
}

}  // namespace fathom
