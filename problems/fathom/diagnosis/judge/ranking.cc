// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/ranking.h"

#include "fathom/diagnosis/judge/experiments.h"
#include "fathom/diagnosis/search/suspects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace fathom {
namespace {

// Why a suspect has no refit of its own.
std::string WhyNotRefitted(double score, double threshold, bool failed) {
  if (failed) {
    return "dropped: its fit cannot be simulated, leaves the inertia open, or is a tone at the "
           "command's own";
  }
  if (score < threshold) {
    return fmt::format(
        "dropped: scores {:.1f} on the screen, noise alone would reach {:.1f}", score, threshold);
  }
  return fmt::format("not refitted: scores {:.1f} on the screen, others score higher", score);
}

std::string WhyOf(
    const Candidate& candidate, double threshold, bool failed, bool is_rival, bool any_kept) {
  if (candidate.is_kept && !(candidate.gain > threshold)) return "kept: gains beside the others";
  if (candidate.is_kept) {
    return fmt::format(
        "kept: gains {:.0f}, noise alone would reach {:.1f}", candidate.gain, threshold);
  }
  if (is_rival) return "cannot be told from a kept cause on these logs";
  if (std::isnan(candidate.gain)) return WhyNotRefitted(candidate.score, threshold, failed);
  if (candidate.gain < threshold) {
    return fmt::format("dropped: gains {:.1f}, noise alone would reach {:.1f}",
                       std::max(0.0, candidate.gain),
                       threshold);
  }
  if (!any_kept) {
    return fmt::format(
        "dropped: gains {:.0f}, but what fits best fails on data that no fit has seen",
        candidate.gain);
  }
  return fmt::format("dropped: gains {:.0f} alone, nothing beside the kept causes", candidate.gain);
}

std::vector<bool> RivalsOf(const SearchResult& search, size_t num_suspects) {
  std::vector<bool> is_rival(num_suspects, false);
  const auto& kept = search.tried[search.best].suspects;
  for (const int index : search.rivals) {
    for (const int suspect : search.tried[index].suspects) {
      if (std::count(kept.begin(), kept.end(), suspect) == 0) is_rival[suspect] = true;
    }
  }
  return is_rival;
}

}  // namespace

std::vector<Cause> CausesOf(const SearchResult& search, const std::vector<Suspect>& suspects) {
  const Hypothesis& best = search.tried[search.best];
  std::vector<Cause> causes;
  for (const int suspect : best.suspects) {
    Cause cause;
    cause.effect_index = PlaceIn(best.fit.model, suspects[suspect]);
    if (const Hypothesis* without = FindWithout(search, search.best, suspect)) {
      const double own_gain = best.gain - without->gain;
      cause.delta_bic = best.delta_bic - without->delta_bic;
      cause.p_value = search.significance.FamilyWisePValue(suspect, own_gain);
    } else {
      cause.delta_bic = best.delta_bic;
      cause.p_value = search.significance.FamilyWisePValue(suspect, best.gain);
    }
    std::vector<Suspect> rivals;
    for (const int index : search.rivals) {
      const auto& other = search.tried[index].suspects;
      if (std::count(other.begin(), other.end(), suspect) > 0) continue;
      for (const int replacing : other) {
        if (std::count(best.suspects.begin(), best.suspects.end(), replacing) > 0) continue;
        cause.alternatives.push_back(LabelOf(suspects[replacing]));
        rivals.push_back(suspects[replacing]);
      }
    }
    if (!rivals.empty()) cause.experiment = DecidingExperiment(suspects[suspect], rivals);
    causes.push_back(std::move(cause));
  }
  std::sort(causes.begin(), causes.end(), [](const Cause& a, const Cause& b) {
    return a.effect_index < b.effect_index;
  });
  return causes;
}

std::vector<Candidate> RankCandidates(const SearchResult& search,
                                      const std::vector<Suspect>& suspects) {
  const Hypothesis& best = search.tried[search.best];
  const std::vector<bool> is_rival = RivalsOf(search, suspects.size());
  std::vector<Candidate> candidates;
  for (size_t k = 0; k < suspects.size(); ++k) {
    Candidate candidate;
    candidate.effect = suspects[k].effect;
    candidate.setting = suspects[k].setting;
    candidate.label = LabelOf(suspects[k]);
    candidate.score = search.scores[k];
    candidate.gain = std::numeric_limits<double>::quiet_NaN();
    const int index = static_cast<int>(k);
    if (const Hypothesis* alone = FindHypothesis(search, {index})) {
      candidate.gain = alone->gain;
      candidate.delta_bic = alone->delta_bic;
      const ActiveEffect& active = alone->fit.model.effects[0];
      candidate.values = active.values;
      for (size_t i = 0; i < active.values.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(kNumParameters + i);
        candidate.stds.push_back(std::sqrt(alone->fit.covariance(at, at)));
      }
    }
    const double gain = std::isnan(candidate.gain) ? candidate.score : candidate.gain;
    candidate.p_value = search.significance.FamilyWisePValue(index, gain);
    candidate.is_kept = std::count(best.suspects.begin(), best.suspects.end(), index) > 0;
    candidate.why = WhyOf(candidate,
                          search.significance.Threshold(index),
                          search.failed_alone[k],
                          is_rival[k],
                          search.best != 0);
    candidates.push_back(std::move(candidate));
  }
  const auto worth = [](const Candidate& candidate) {
    return std::isnan(candidate.gain) ? candidate.score - 1e6 : candidate.gain;
  };
  std::stable_sort(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
    if (a.is_kept != b.is_kept) return a.is_kept;
    return worth(a) > worth(b);
  });
  return candidates;
}

ExtendedModel WithoutCause(const SearchResult& search,
                           const std::vector<Suspect>& suspects,
                           const Cause& cause) {
  const Hypothesis& best = search.tried[search.best];
  for (const int suspect : best.suspects) {
    if (PlaceIn(best.fit.model, suspects[suspect]) != cause.effect_index) continue;
    const Hypothesis* without = FindWithout(search, search.best, suspect);
    if (without != nullptr) return without->fit.model;
  }
  return WithoutEffect(best.fit.model, cause.effect_index);
}

}  // namespace fathom
