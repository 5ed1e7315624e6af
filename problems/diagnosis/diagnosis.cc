// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/diagnosis.h"

#include "fathom/base/input_error.h"
#include "fathom/diagnosis/held_out.h"
#include "fathom/diagnosis/missing_force.h"
#include "fathom/diagnosis/outliers.h"
#include "fathom/diagnosis/ranking.h"
#include "fathom/diagnosis/records.h"
#include "fathom/diagnosis/remaining_structure.h"
#include "fathom/diagnosis/robust_start.h"
#include "fathom/diagnosis/search.h"
#include "fathom/diagnosis/structure_fit.h"
#include "fathom/diagnosis/suspects.h"
#include "fathom/diagnosis/thinned.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kSmallestPValue = 0.001;  // of remaining structure, at which it is said to remain
constexpr double kMaterialShare = 0.05;    // of all structure, below which the rest is no matter
// Share of the motion below which a residual is nobody's business: finer than any sensor shows it,
// and than the uncoupled model can be true.
constexpr double kNegligible = 1e-3;
constexpr double kMuchMoreThanTheSensor = 3.0;  // at which a consistent log's noise needs a word
constexpr double kLossWorthAWord = 0.02;        // of held-out NMAE
constexpr double kLossTooMuch = 0.05;           // of the same, at which nothing is named
constexpr int kNumFolds = 4;                    // of left-out blocks, where nothing is held out

void RequireUsable(const DiagnosisOptions& options) {
  if (!(options.false_alarm_rate > 0.0 && options.false_alarm_rate <= 0.5)) {
    throw InputError(fmt::format("false_alarm_rate is {}, expected a number in (0, 0.5].",
                                 options.false_alarm_rate));
  }
  if (options.most_causes < 1 || options.most_causes > 3) {
    throw InputError(fmt::format("most_causes is {}, expected 1 to 3.", options.most_causes));
  }
  if (!(options.separation >= 0.0)) {
    throw InputError(
        fmt::format("separation is {}, expected a number of at least 0.", options.separation));
  }
}

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

// Free runs of two models over records that neither was fitted to.
struct Scored {
  std::vector<FreeRun> before, after;
};

void Score(const std::vector<Record>& records,
           const ExtendedModel& before,
           const ExtendedModel& after,
           Scored* scored) {
  for (const Record& record : records) {
    auto run_before = FreeRunOver(record, before);
    auto run_after = FreeRunOver(record, after);
    if (!run_before || !run_after) continue;
    scored->before.push_back(std::move(*run_before));
    scored->after.push_back(std::move(*run_after));
  }
}

// The samples of a record within [from, to].
Record Between(const Record& record, double from, double to) {
  Record part = record;
  const auto cut = [&](std::vector<double>* time, std::vector<double>* value) {
    const auto begin = std::lower_bound(time->begin(), time->end(), from) - time->begin();
    const auto end = std::upper_bound(time->begin(), time->end(), to) - time->begin();
    *time = {time->begin() + begin, time->begin() + end};
    *value = {value->begin() + begin, value->begin() + end};
  };
  cut(&part.stamps.velocity, &part.velocity);
  cut(&part.stamps.displacement, &part.displacement);
  return part;
}

// Both structures refitted with a block left out at a time, and run over that block.
Scored LeaveBlocksOut(const TrainingData& data,
                      const StructureFit& baseline,
                      const StructureFit& extended) {
  Scored scored;
  double total = 0.0;
  for (const Record& record : data.records()) total += record.duration();
  for (int fold = 0; fold < kNumFolds; ++fold) {
    std::vector<Record> kept, left_out;
    double passed = 0.0;
    const double from = total * fold / kNumFolds, to = total * (fold + 1) / kNumFolds;
    for (const Record& record : data.records()) {
      const double start = record.stamps.start, end = start + record.duration();
      const double low = std::clamp(start + from - passed, start, end);
      const double high = std::clamp(start + to - passed, start, end);
      passed += record.duration();
      const auto add = [](Record part, std::vector<Record>* to_list) {
        const auto& time = part.velocity.empty() ? part.stamps.displacement : part.stamps.velocity;
        if (time.size() < 20) return;
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
    const TrainingData rest(std::move(kept), baseline.model.baseline);
    const Whitener whitener(extended.noise, rest.samples());
    const Whitener baseline_whitener(baseline.noise, rest.samples());
    const StructureFit before = FitStructure(rest, baseline.model, initial, baseline_whitener);
    const StructureFit after = FitStructure(rest, extended.model, initial, whitener);
    Score(left_out, before.model, after.model, &scored);
  }
  return scored;
}

// The baseline's residual as a share of the motion: of the speed, and of the way made in a second.
// The larger of the two.
double ShareLeft(const TrainingData& data, const StructureFit& baseline) {
  double speed2 = 0.0, num_speeds = 0.0;
  for (const Record& record : data.records()) {
    for (const double v : SegmentOfRecord(record).velocity) {
      speed2 += v * v;
      num_speeds += 1.0;
    }
  }
  double largest = 0.0;
  for (const NoiseChannel channel : {NoiseChannel::kVelocity, NoiseChannel::kDisplacement}) {
    double left2 = 0.0, n = 0.0;
    for (int i = 0; i < data.bins().size(); ++i) {
      if (data.samples()[i].channel != channel) continue;
      left2 += baseline.residual[i] * baseline.residual[i];
      n += 1.0;
    }
    if (n > 0.0) largest = std::max(largest, std::sqrt(left2 / n * num_speeds / speed2));
  }
  return largest;
}

std::string LabelsOf(const Hypothesis& hypothesis, const std::vector<Suspect>& suspects) {
  std::string labels;
  for (const int suspect : hypothesis.suspects) {
    labels += (labels.empty() ? "" : " with ") + LabelOf(suspects[suspect]);
  }
  return labels;
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
           ThresholdOf(*search, search->tried[index].suspects);
  };
  for (bool is_settled = false; !is_settled;) {
    is_settled = true;
    const int best = search->best;
    for (const int suspect : search->tried[best].suspects) {
      std::vector<int> others = search->tried[best].suspects;
      std::erase(others, suspect);
      const Hypothesis* without = FindHypothesis(*search, others);
      if (without == nullptr) continue;
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

// The search over thinned data, confirmed on all of them.
SearchResult SearchThinned(const TrainingData& data,
                           const StructureFit& baseline,
                           const std::vector<Suspect>& suspects,
                           const DiagnosisOptions& options) {
  const TrainingData thinned(Thinned(data.records()), baseline.model.baseline);
  const StructureFit rough =
      FitStructureAndNoise(thinned, baseline.model, baseline.initial, baseline.noise);
  SearchResult search =
      SearchCauses(thinned, rough.jacobian.size() == 0 ? baseline : rough, suspects, options);
  ConfirmOnAllData(data, baseline, options, &search);
  search.tried[0].fit = baseline;
  return search;
}

// True if data that no fit has seen speak against what is named: for certain, or as far as they go
// by so much that it should not be built on.
bool IsRefuted(const Gain& gain) { return gain.high < 0.0 || gain.value < -kLossTooMuch; }

// True if what the best hypothesis leaves is more than noise, and a matter.
bool Remains(const RemainingStructure& remaining, const SearchResult& search) {
  const double all_structure = search.tried[search.best].gain + remaining.gain;
  return remaining.p_value < kSmallestPValue &&
         remaining.gain - remaining.num_columns > kMaterialShare * all_structure;
}

// The best hypothesis of at most so many causes without any of some suspects.
int BestWithout(const std::set<int>& left_out, size_t most_causes, const SearchResult& search) {
  int best = 0;
  for (size_t i = 0; i < search.tried.size(); ++i) {
    const Hypothesis& other = search.tried[i];
    const bool has_one = std::any_of(other.suspects.begin(),
                                     other.suspects.end(),
                                     [&](int suspect) { return left_out.contains(suspect); });
    if (has_one || other.suspects.size() > most_causes) continue;
    if (!(other.gain > ThresholdOf(search, other.suspects))) continue;
    if (other.delta_bic > search.tried[best].delta_bic) best = static_cast<int>(i);
  }
  return best;
}

// Leaves out of the best hypothesis every cause that the held-out data speak against; where each
// must gain, also those whose gain on them is not certain.
void LeaveOutTheRefuted(const TrainingData& data,
                        const std::vector<Record>& held_out,
                        const std::vector<Suspect>& suspects,
                        const DiagnosisOptions& options,
                        bool each_must_gain,
                        SearchResult* search,
                        std::vector<std::string>* remarks) {
  const auto refuted = [&]() -> int {
    const Hypothesis& best = search->tried[search->best];
    for (const int suspect : best.suspects) {
      std::vector<int> others = best.suspects;
      std::erase(others, suspect);
      const Hypothesis* without = FindHypothesis(*search, others);
      if (without == nullptr) continue;
      Scored scored;
      Score(held_out, without->fit.model, best.fit.model, &scored);
      const Gain gain = GainOf(scored.before, scored.after, options.seed);
      if (IsRefuted(gain) || (each_must_gain && !(gain.low > 0.0))) return suspect;
    }
    return -1;
  };
  std::set<int> left_out;
  const size_t fewest = each_must_gain ? 0 : 1;
  while (search->tried[search->best].suspects.size() > fewest) {
    const int suspect = refuted();
    if (suspect < 0) return;
    left_out.insert(suspect);
    search->best = BestWithout(left_out, search->tried[search->best].suspects.size() - 1, *search);
    StructureFit& fit = search->tried[search->best].fit;  // of thinned data until now
    fit = FitStructureAndNoise(
        data, ExtendedModel(fit.model), std::vector(fit.initial), NoiseModel(fit.noise));
    if (fit.jacobian.size() == 0) search->best = 0;
    search->rivals = FindRivals(data, *search, options.separation);
    const std::string kept = LabelsOf(search->tried[search->best], suspects);
    remarks->push_back(fmt::format(
        "Not named{}{}: {}. {}.",
        kept.empty() ? "" : " beside ",
        kept,
        LabelOf(suspects[suspect]),
        each_must_gain ? "It fits the training data, but gains nothing for certain on data that no "
                         "fit has seen, and there is more that nothing explains"
                       : "With it the error grows on data that no fit has seen"));
  }
}

void AddRemarksOnTheEvidence(const TrainingData& data,
                             const StructureFit& baseline,
                             Diagnosis* diagnosis) {
  const double inertia = baseline.model.baseline.inertia;
  const double std = std::sqrt(baseline.covariance(kInertia, kInertia));
  if (!(std < inertia)) {
    diagnosis->remarks.push_back(
        fmt::format("Without causes these logs do not determine the model: the inertia is {:.3g} "
                    "with a standard deviation of {:.2g}. Take what is said here as a hint.",
                    inertia,
                    std));
  }
  if (!diagnosis->has_velocity) {
    diagnosis->remarks.push_back(
        "These poses have no velocities beside them. A wrong scale of theirs (marker size, "
        "refraction) leaves no trace: one of 1 + e divides inertia and linear damping by 1 + e and "
        "quadratic damping by its square. A clock of theirs that differs from the command's is the "
        "same as a delay of the command (time_offset). A velocity sensor tells both.");
  }
  if (const double share_left = ShareLeft(data, baseline); share_left < kNegligible) {
    diagnosis->remarks.push_back(
        fmt::format("Without any cause the model leaves {:.2g} % of the motion. Below {:.2g} % no "
                    "cause is looked for.",
                    100.0 * share_left,
                    100.0 * kNegligible));
    return;
  }
  const auto& leading =
      diagnosis->has_velocity ? baseline.noise.velocity : baseline.noise.displacement;
  const NoiseChannel channel =
      diagnosis->has_velocity ? NoiseChannel::kVelocity : NoiseChannel::kDisplacement;
  double sum = 0.0, n = 0.0;
  for (int i = 0; i < data.bins().size(); ++i) {
    if (data.samples()[i].channel != channel) continue;
    sum += baseline.residual[i] * baseline.residual[i];
    n += 1.0;
  }
  const double times_the_sensor = std::sqrt(sum / n) / std::max(leading.white_std, 1e-12);
  if (diagnosis->verdict == Verdict::kConsistent && times_the_sensor > kMuchMoreThanTheSensor) {
    diagnosis->remarks.push_back(
        fmt::format("The error is {:.0f} times what scatters from sample to sample. It wanders as "
                    "slow random forces or a wandering sensor make it wander, and follows nothing "
                    "that was logged: noise, or something that these logs do not show.",
                    times_the_sensor));
  }
  const Tone& tone = data.command_tone();
  if (tone.IsAlone() && !diagnosis->causes.empty()) {
    diagnosis->remarks.push_back(
        fmt::format("The command is little more than a single sine of {:.2g} rad/s: one second is "
                    "{:.0f} degrees of its phase, and any delay or lag of that phase looks nearly "
                    "the same.",
                    tone.frequency,
                    tone.frequency * 180.0 / std::numbers::pi));
  }
}

// Share of the baseline's squared error that is more than noise.
double StructureShare(const StructureFit& baseline, const StructureFit& best) {
  const double before = baseline.residual.squaredNorm();
  return before > 0.0 ? std::clamp(1.0 - best.residual.squaredNorm() / before, 0.0, 1.0) : 0.0;
}

}  // namespace

std::string_view Name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kConsistent:
      return "consistent";
    case Verdict::kExplained:
      return "explained";
    case Verdict::kAmbiguous:
      return "ambiguous";
    case Verdict::kUnexplained:
      return "unexplained";
  }
  return "";
}

Diagnosis Diagnose(std::span<const Log> logs, Dof dof, const DiagnosisOptions& options) {
  RequireUsable(options);
  const Records records = RecordsOf(logs, dof);
  Diagnosis diagnosis;
  diagnosis.dof = dof;
  diagnosis.force_unit = records.force_unit;
  for (const Log& log : logs) diagnosis.logs.push_back(log.name);
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
  const TrainingData data(std::move(train), start->model.baseline);
  const StructureFit baseline = FitBaseline(data, start->model, start->initial);
  if (baseline.jacobian.size() == 0) {
    diagnosis.message = "the baseline model cannot be simulated over these logs.";
    return diagnosis;
  }

  const std::vector<const Effect*> effects =
      options.effects.empty()
          ? std::vector<const Effect*>(EffectCatalogue().begin(), EffectCatalogue().end())
          : options.effects;
  const bool is_negligible = ShareLeft(data, baseline) < kNegligible;
  const std::vector<Suspect> suspects =
      is_negligible ? std::vector<Suspect>() : SuspectsFor(records, dof, effects);
  SearchResult search = SearchThinned(data, baseline, suspects, options);
  const std::vector<Record> held_out = Part(records.all, true);
  diagnosis.by_left_out_blocks = held_out.empty();
  const auto leave_out = [&](bool each_must_gain) {
    LeaveOutTheRefuted(
        data, held_out, suspects, options, each_must_gain, &search, &diagnosis.remarks);
  };
  leave_out(false);
  const auto find_remaining = [&] {
    const StructureFit& fit = search.tried[search.best].fit;
    return is_negligible ? RemainingStructure() : FindRemainingStructure(data, fit);
  };
  // The causes may stand in for what nothing explains; unseen data tell.
  if (!held_out.empty() && Remains(find_remaining(), search)) leave_out(true);
  Scored scored;
  if (held_out.empty()) {
    scored = LeaveBlocksOut(data, baseline, search.tried[search.best].fit);
  } else {
    Score(held_out, baseline.model, search.tried[search.best].fit.model, &scored);
  }
  Gain gain = GainOf(scored.before, scored.after, options.seed);
  // Of blocks left out in turn the models are refitted on less: only what is certain counts.
  const bool is_refuted =
      search.best != 0 && (diagnosis.by_left_out_blocks ? gain.high < 0.0 : IsRefuted(gain));
  if (is_refuted) {
    diagnosis.remarks.push_back(
        fmt::format("Not named: {}. It fits the training data best, but on data that no fit has "
                    "seen the error grows by {:.0f} % ({:.0f} to {:.0f} %).",
                    LabelsOf(search.tried[search.best], suspects),
                    -100.0 * gain.value,
                    -100.0 * gain.high,
                    -100.0 * gain.low));
    search.best = 0;
    search.rivals.clear();
    scored.after = scored.before;
    gain = GainOf(scored.before, scored.after, options.seed);
  }
  const Hypothesis& best = search.tried[search.best];
  const RemainingStructure remaining = find_remaining();
  const bool remains = Remains(remaining, search);
  if (remains) {
    // What nothing explains gains so much per column: then it takes as many times more to tell two
    // causes apart, either of which may stand in for it.
    const double times_noise = remaining.gain / remaining.num_columns;
    search.rivals = FindRivals(data, search, options.separation * std::max(1.0, times_noise));
  }

  diagnosis.baseline = Describe(data, baseline);
  diagnosis.extended = Describe(data, best.fit);
  diagnosis.remaining_p_value = remaining.p_value;
  const double all_structure = best.gain + remaining.gain;
  diagnosis.explained_share = all_structure > 0.0 ? best.gain / all_structure : 0.0;
  diagnosis.structure_share = StructureShare(baseline, best.fit);
  if (remains || is_refuted) {
    diagnosis.verdict = Verdict::kUnexplained;
  } else if (best.suspects.empty()) {
    diagnosis.verdict = Verdict::kConsistent;
  } else {
    diagnosis.verdict = search.rivals.empty() ? Verdict::kExplained : Verdict::kAmbiguous;
  }
  diagnosis.causes = CausesOf(data, search, suspects);
  AddRemarksOnTheEvidence(data, baseline, &diagnosis);
  diagnosis.candidates = RankCandidates(search, suspects);

  diagnosis.baseline.held_out = FiguresOfRuns(scored.before);
  diagnosis.extended.held_out = FiguresOfRuns(scored.after);
  diagnosis.held_out_gain = gain.value;
  diagnosis.held_out_gain_low = gain.low;
  diagnosis.held_out_gain_high = gain.high;
  if (!diagnosis.causes.empty() && gain.value < -kLossWorthAWord) {
    diagnosis.remarks.push_back(
        "Data that no fit has seen do not bear out what is named: the error on them grows. Do not "
        "build on it before another run confirms it.");
  }
  for (Cause& cause : diagnosis.causes) {
    const ExtendedModel without = WithoutCause(search, suspects, cause);
    Scored own;
    if (!held_out.empty()) {
      Score(held_out, without, best.fit.model, &own);
      cause.held_out_gain = GainOf(own.before, own.after, options.seed).value;
    } else {
      cause.held_out_gain = gain.value;
    }
  }

  diagnosis.missing_force = FindMissingForce(data, baseline, best.fit, records.partners);
  for (size_t r = 0; r < data.records().size(); ++r) {
    diagnosis.traces.push_back(TraceOf(data.records()[r],
                                       baseline.model,
                                       baseline.initial[r],
                                       best.fit.model,
                                       best.fit.initial[r]));
  }
  for (const Record& record : held_out) {
    diagnosis.traces.push_back(
        TraceOf(record, baseline.model, record.initial, best.fit.model, record.initial));
  }
  return diagnosis;
}

}  // namespace fathom
