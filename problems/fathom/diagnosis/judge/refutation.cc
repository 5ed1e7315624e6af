// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/refutation.h"

#include "fathom/diagnosis/search/suspects.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLossTooMuch = 0.05;   // of held-out NMAE, at which nothing is named
constexpr double kTraceInPoses = 0.01;  // losses that say nothing
constexpr double kTraceInVelocities = 0.005;
constexpr double kMaterialGain = 0.05;  // in poses, that outweighs them in velocities

double TraceOf(const Gain& gain) { return gain.is_in_poses ? kTraceInPoses : 0.0; }

// For certain, by more than a trace, or by too much as far as the data go.
bool IsLoss(const Gain& gain, double trace) {
  return gain.high < -trace || gain.value < -kLossTooMuch;
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
    if (!IsPhysical(other) || !(other.gain > ThresholdOf(search, other.suspects))) continue;
    if (other.delta_bic > search.tried[best].delta_bic) best = static_cast<int>(i);
  }
  return best;
}

}  // namespace

std::optional<Gain> RefutingGain(const Scored& scored,
                                 bool acts_on_poses_alone,
                                 std::uint64_t seed) {
  const Gain gain = GainOf(scored, acts_on_poses_alone, seed);
  if (IsLoss(gain, TraceOf(gain))) return gain;
  if (!gain.is_in_poses) return std::nullopt;
  const Gain in_velocities = GainOf(scored, false, seed);
  if (IsLoss(in_velocities, kTraceInVelocities)) return in_velocities;
  return std::nullopt;
}

void LeaveOutTheRefuted(const TrainingData& data,
                        const std::vector<Record>& held_out,
                        const std::vector<Suspect>& suspects,
                        const DiagnosisOptions& options,
                        Burden burden,
                        SearchResult* search,
                        std::vector<std::string>* remarks) {
  const auto refuted = [&]() -> int {
    const Hypothesis& best = search->tried[search->best];
    for (const int suspect : best.suspects) {
      const Hypothesis* without = FindWithout(*search, search->best, suspect);
      if (without == nullptr) continue;
      Scored scored;
      Score(held_out, without->fit.model, best.fit.model, &scored);
      const Gain in_velocities = GainOf(scored, false, options.seed);
      const Gain gain = GainOf(scored, ActOnPosesAlone({suspect}, suspects), options.seed);
      const bool is_borne_out = gain.is_in_poses && gain.low > kMaterialGain;
      if (!is_borne_out && (IsLoss(in_velocities, 0.0) || IsLoss(gain, TraceOf(gain)))) {
        return suspect;
      }
      if (burden == Burden::kToGain && !(gain.low > 0.0)) return suspect;
    }
    return -1;
  };
  std::set<int> left_out;
  const size_t fewest = burden == Burden::kToGain ? 0 : 1;
  while (search->tried[search->best].suspects.size() > fewest) {
    const int suspect = refuted();
    if (suspect < 0) return;
    left_out.insert(suspect);
    search->best = BestWithout(left_out, search->tried[search->best].suspects.size() - 1, *search);
    if (search->best != 0) {
      StructureFit& fit = search->tried[search->best].fit;  // of thinned data until now
      fit = FitStructureAndNoise(
          data, ExtendedModel(fit.model), std::vector(fit.initial), NoiseModel(fit.noise));
      if (fit.jacobian.size() == 0) search->best = 0;
    }
    search->rivals = FindRivals(data, *search, options.separation);
    const std::string kept = LabelsOf(search->tried[search->best].suspects, suspects);
    remarks->push_back(fmt::format(
        "Not named{}{}: {}. {}.",
        kept.empty() ? "" : " beside ",
        kept,
        LabelOf(suspects[suspect]),
        burden == Burden::kToGain
            ? "It fits the training data, but gains nothing for certain on data that no "
              "fit has seen, and there is more that nothing explains"
            : "With it the error grows on data that no fit has seen"));
  }
}

}  // namespace fathom
