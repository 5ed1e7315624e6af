// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/remarks.h"

#include "fathom/base/plural.h"
#include "fathom/diagnosis/fit/residual_noise.h"
#include "fathom/diagnosis/report/cause_text.h"
#include "fathom/diagnosis/search/suspects.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// A clause.
std::string WhyRefused(const Refusal& refusal) {
  switch (refusal.reason) {
    case Refusal::Reason::kFinerThanTheStamps:
      return "it is under half of the step between two samples: how a log is sampled does as much";
    case Refusal::Reason::kLosesBesideOthers:
      return "with it the error on held-out data grows";
    case Refusal::Reason::kGainsNothing:
      return "it has no significant gain on held-out data, and more structure remains that nothing "
             "explains";
    case Refusal::Reason::kLosesOnUnseenData:
      return fmt::format("the error on held-out data grows by {:.0f} %{}",
                         -100.0 * refusal.loss.value,
                         std::isnan(refusal.loss.low) ? ""
                                                      : fmt::format(" ({:.0f} to {:.0f} %)",
                                                                    -100.0 * refusal.loss.high,
                                                                    -100.0 * refusal.loss.low));
    case Refusal::Reason::kTwoLogsTellTooLittle:
      return "it may stand in for more that is missing, and two logs cannot tell (a third would)";
    case Refusal::Reason::kNotConfirmedByLogs:
      return fmt::format(
          "logs left out in turn do not confirm it: with it the error {} in {} of {}, by {:.0f} % "
          "in all",
          refusal.loss.value < 0.0 ? "grows" : "falls",
          refusal.loss.value < 0.0 ? refusal.loss.num_logs - refusal.loss.num_better
                                   : refusal.loss.num_better,
          refusal.loss.num_logs,
          100.0 * std::abs(refusal.loss.value));
    case Refusal::Reason::kLosesInTraining:
      return fmt::format("the NMAE on the training data itself grows from {:.2g} to {:.2g}",
                         refusal.nmae_before,
                         refusal.nmae_after);
  }
  return "";
}

std::string RemarkOn(const Refusal& refusal, const std::vector<Suspect>& suspects) {
  const std::string kept = LabelsOf(refusal.kept, suspects);
  return fmt::format("Not named{}{}: {}. It improves the fit, but {}.",
                     kept.empty() ? "" : " beside ",
                     kept,
                     LabelsOf(refusal.refused, suspects),
                     WhyRefused(refusal));
}

// On how far the data carry what is said of them: a baseline that they do not determine, poses
// alone, a command of one tone.
std::vector<std::string> RemarksOnEvidence(const Evidence& evidence,
                                           bool has_velocity,
                                           bool has_causes) {
  std::vector<std::string> remarks;
  if (!(evidence.inertia_std < evidence.inertia)) {
    const std::string figures = std::isfinite(evidence.inertia_std)
                                    ? fmt::format(
                                          ": the inertia is {:.3g} with a standard "
                                          "deviation of {:.2g}",
                                          evidence.inertia,
                                          evidence.inertia_std)
                                    : "";
    remarks.push_back(
        fmt::format("Without causes these logs do not determine the model{}. Treat this result as "
                    "a hint.",
                    figures));
  }
  if (!has_velocity) {
    remarks.push_back(
        "The log has poses but no velocities. A wrong scale of the poses (marker size, "
        "refraction) leaves no trace: a scale of 1 + e divides inertia and linear damping by 1 + "
        "e and quadratic damping by its square. A clock offset of the poses looks like a command "
        "delay (time_offset). A velocity sensor would show both.");
  }
  if (evidence.IsNegligible()) {
    remarks.push_back(
        fmt::format("Without any cause the model misses {:.2g} % of the motion. Below {:.2g} % "
                    "no cause is searched.",
                    100.0 * evidence.share_left,
                    100.0 * Evidence::kNegligible));
    return remarks;
  }
  const Tone& tone = evidence.command_tone;
  if (tone.IsAlone() && has_causes) {
    remarks.push_back(
        fmt::format("The command is almost a single sine of {:.2g} rad/s. One second is {:.0f} "
                    "degrees of its phase, and any delay or lag with that phase looks nearly the "
                    "same.",
                    tone.frequency,
                    tone.frequency * 180.0 / std::numbers::pi));
  }
  return remarks;
}

// Whether the quietest sensors make up for what the fit leaves, in each channel that is measured.
bool IsWithoutNoise(const Judgement& judgement) {
  constexpr double kRounding = 1e-9;
  const TrainingData& data = judgement.search.thinned;
  const NoiseModel quietest = QuietestSensors(data);
  const NoiseModel& noise = judgement.search.baseline.noise;
  const bool has_velocity = std::ranges::any_of(data.samples(), [](const NoiseSample& sample) {
    return sample.channel == NoiseChannel::kVelocity;
  });
  const SensorNoise& own = has_velocity ? noise.velocity : noise.displacement;
  return own.white_std > 0.0 && own.white_std <= (1.0 + kRounding) * quietest.velocity.white_std;
}

}  // namespace

NotNamed NotNamedOf(const std::vector<Refusal>& refusals,
                    const std::vector<Candidate>& candidates,
                    const std::vector<Suspect>& suspects) {
  const Refusal& last = refusals.back();
  if (refusals.size() == 1) return {LabelsOf(last.refused, suspects), WhyRefused(last)};
  std::set<std::string> refused;
  for (const Refusal& refusal : refusals) {
    for (const int suspect : refusal.refused) refused.insert(LabelOf(suspects[suspect]));
  }
  std::vector<std::string> labels;
  for (const Candidate& candidate : candidates) {
    if (refused.contains(candidate.label)) labels.push_back(candidate.label);
  }
  if (labels.size() == 1) return {labels.front(), WhyRefused(last)};
  return {AnyOf(labels), "held-out data confirm none of them (the notes say why)"};
}

std::vector<std::string> RemarksOnData(const MeasuredSegments& segments,
                                       const Preparation& preparation) {
  constexpr double kHour = 3600.0;  // [s]
  std::vector<std::string> remarks = segments.remarks;
  if (preparation.used < preparation.duration) {
    remarks.push_back(fmt::format(
        "Causes are searched for in {:.3g} of the {:.3g} h of training data, in pieces that are "
        "spread evenly over it. The baseline is fitted to all of it.",
        preparation.used / kHour,
        preparation.duration / kHour));
  }
  const int num_outliers = preparation.num_outliers;
  if (num_outliers > 0) {
    remarks.push_back(fmt::format("Left out: {} far from {} neighbours.",
                                  Plural(static_cast<std::size_t>(num_outliers), "single outlier"),
                                  num_outliers == 1 ? "its" : "their"));
  }
  return remarks;
}

void AddRemarksOn(const Identified& identified, std::vector<std::string>* remarks) {
  remarks->insert(remarks->end(), identified.remarks.begin(), identified.remarks.end());
  if (identified.model) return;
  remarks->push_back(
      fmt::format("fathom_identify gives no model of these logs: {} The model without causes is "
                  "what output error finds from another start. Treat it as a hint.",
                  identified.why_none));
}

std::vector<std::string> RemarksOnJudgement(const Judgement& judgement, bool has_velocity) {
  const std::vector<Suspect>& suspects = judgement.search.suspects;
  std::vector<std::string> remarks;
  for (const Refusal& refusal : judgement.choice.refusals)
    remarks.push_back(RemarkOn(refusal, suspects));
  if (!judgement.IsRemainingTried()) {
    remarks.push_back(
        "Not tested: structure that no effect in the catalogue explains. There are too few "
        "training data for this test.");
  }
  if (judgement.search.found.is_cut) {
    remarks.push_back(
        "The search was ended before it was through. --effort=4 lets it go on for four times as "
        "long.");
  }
  if (IsWithoutNoise(judgement)) {
    remarks.push_back(
        "The data have no sensor noise, as those of a simulation. They are taken as if a sensor "
        "scattered by 0.01 % of the motion: what is smaller is rounding and integration.");
  }
  const bool has_causes = judgement.choice.chosen != 0;
  if (has_causes && judgement.runs.gain.num_logs == 2) {
    remarks.push_back(
        "Each of two logs was predicted by the model of the other. Two logs tell little of what "
        "carries over to a third: predict one more before the causes are built upon.");
  }
  for (std::string& remark : RemarksOnEvidence(judgement.evidence, has_velocity, has_causes)) {
    remarks.push_back(std::move(remark));
  }
  return remarks;
}

}  // namespace fathom
