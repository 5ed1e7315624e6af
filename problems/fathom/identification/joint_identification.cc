// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/joint_identification.h"

#include "fathom/identification/family.h"
#include "fathom/joint_refinement/logs/marker_logs.h"
#include "fathom/signal/joined_signals.h"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// Lower is better; NaN where there is no fair yardstick.
double ScoreOf(const Identification& row, Source scored_against) {
  if (!row.is_usable) return std::numeric_limits<double>::quiet_NaN();
  if (std::isfinite(row.fitted.held_out.nmae)) return row.fitted.held_out.nmae;
  return scored_against == Source::kCamera ? std::numeric_limits<double>::quiet_NaN()
                                           : row.fitted.train.nmae;
}

// Where no score tells, the last usable one: output error, whose assumptions are the joint's.
const Identification* BestOf(std::span<const Identification> guesses, Source scored_against) {
  const Identification* best = nullptr;
  for (const Identification& guess : guesses) {
    if (!guess.is_usable) continue;
    const bool is_worse =
        best != nullptr && ScoreOf(guess, scored_against) > ScoreOf(*best, scored_against);
    if (!is_worse) best = &guess;
  }
  return best;
}

}  // namespace

Identification OrBestGuess(Identification joint,
                           std::span<const Identification> guesses,
                           Source scored_against) {
  constexpr double kWorse = 1.02;  // scores nearer than that are alike
  const Identification* const best = BestOf(guesses, scored_against);
  if (best == nullptr) return joint;
  const double own = ScoreOf(joint, scored_against), score = ScoreOf(*best, scored_against);
  std::string why;
  if (!joint.is_usable) {
    why = fmt::format("The joint refinement has no usable model: {}", joint.message);
  } else if (own > kWorse * score) {
    why = fmt::format(
        "The joint refinement simulates worse (NMAE {:.3g}) than its initial guess "
        "(NMAE {:.3g}).",
        own,
        score);
  } else {
    return joint;
  }
  why += fmt::format(" This is the model of the initial guess by {} on the poses.",
                     Name(best->family));
  joint.is_usable = true;
  joint.message = why;
  joint.fitted = best->fitted;
  joint.stand_in = best->family;
  joint.fitted.caveats.insert(joint.fitted.caveats.begin(), why);
  return joint;
}

Identification IdentificationOf(const JointSummary& joint, const Signals& scored) {
  Identification result;
  result.family = Family::kJoint;
  result.source = Source::kCamera;
  result.fitted.dof = scored.dof;
  result.fitted.force_unit = scored.force_unit;
  result.is_usable = joint.IsUsable();
  result.message = joint.message;
  result.fitted.model = joint.model;
  result.fitted.covariance = joint.covariance;
  result.fitted.caveats = joint.caveats;
  if (result.is_usable) ScoreByFreeRuns(scored, &result.fitted);
  return result;
}

Identification IdentifyJointly(std::vector<Log> logs,
                               const Signals& scored,
                               const IdentificationOptions& options,
                               std::vector<std::string>* remarks) {
  for (Log& log : logs) log.pose.reset();
  const MarkerLogs markers = PrepareMarkerLogs(std::move(logs), scored.dof);
  remarks->insert(remarks->end(), markers.remarks.begin(), markers.remarks.end());
  const Signals camera = JoinSignals(markers.logs, scored.dof, Source::kCamera).all;
  std::vector<Identification> guesses;
  for (const Family family : kSignalFamilies) {
    guesses.push_back(Identify(camera, scored, family, options));
  }
  return OrBestGuess(
      IdentificationOf(FitJoint(markers.input, options.joint), scored), guesses, scored.source);
}

}  // namespace fathom
