// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/verdict_sentence.h"

#include "fathom/diagnosis/report/cause_text.h"
#include "fathom/diagnosis/report/large_residual.h"
#include "fathom/diagnosis/report/moved_parameter.h"
#include "fathom/diagnosis/report/suspect_signals.h"
#include "fathom/simulate/noise_floor.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr std::array<const char*, 4> kCounts = {"no", "one", "two", "three"};

// "38 % of the error of your surge model that is not noise"; "Part of the error of your surge
// model" where no share is known.
std::string ShareOfError(const Diagnosis& diagnosis) {
  const std::string of_error = fmt::format("of the error of your {} model", Name(diagnosis.dof));
  const double share = diagnosis.explained_share;
  if (!(share >= 0.005)) return "Part " + of_error;
  return fmt::format("{:.0f} % {} that is not noise", 100.0 * share, of_error);
}

// "this log" or "these 3 logs".
std::string TheseLogs(const Diagnosis& diagnosis) {
  return diagnosis.logs.size() <= 1 ? "this log"
                                    : fmt::format("these {} logs", diagnosis.logs.size());
}

std::string Capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(text[0]));
  return text;
}

// So many digits, those at the end that are zero among them: "0.080".
std::string WithDigits(double value, int digits) {
  std::string text = fmt::format("{:#.{}g}", value, digits);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

// Why the error is there, all causes together.
std::string WhyItMisses(const Diagnosis& diagnosis) {
  const std::string subject = ShareOfError(diagnosis);
  if (diagnosis.causes.size() == 1) {
    return fmt::format("{} {} from {}.",
                       subject,
                       AreContradicted(diagnosis) ? "may come" : "comes",
                       ReasonText(diagnosis, diagnosis.causes.front(), "from "));
  }
  std::vector<std::string> reasons;
  for (const Cause& cause : diagnosis.causes) {
    reasons.push_back(ReasonText(diagnosis, cause, ""));
  }
  const std::string count =
      reasons.size() < kCounts.size() ? kCounts[reasons.size()] : fmt::format("{}", reasons.size());
  return fmt::format("{} {} {} causes: {}.",
                     subject,
                     AreContradicted(diagnosis) ? "may have" : "has",
                     count,
                     fmt::join(reasons, "; "));
}

// The same where no model without a cause fits.
std::string WhatItTakes(const Diagnosis& diagnosis) {
  const bool is_one = diagnosis.causes.size() == 1;
  std::vector<std::string> reasons;
  for (const Cause& cause : diagnosis.causes) {
    reasons.push_back(ReasonText(diagnosis, cause, ""));
  }
  std::string text = fmt::format("No {} model without {} fits {}. One with {} does: {}.",
                                 Name(diagnosis.dof),
                                 is_one ? "a cause" : "causes",
                                 TheseLogs(diagnosis),
                                 is_one ? "this cause" : "these causes",
                                 fmt::join(reasons, "; "));
  const double nmae = diagnosis.extended.held_out.nmae;
  if (std::isfinite(nmae)) {
    text += fmt::format(" Its {} is {}.", NameOfNmae(diagnosis), WithDigits(nmae, 2));
  }
  return text;
}

// What cannot be told apart, and what would tell; empty if everything can.
std::string WhatIsOpen(const Diagnosis& diagnosis) {
  std::vector<std::string> sentences, experiments;
  for (const Cause& cause : diagnosis.causes) {
    const std::vector<std::string> alternatives = LabelsOf(AlternativesOf(cause));
    if (alternatives.empty()) continue;
    const ActiveEffect& active = EffectOfCause(diagnosis, cause);
    sentences.push_back(fmt::format("{} cannot tell {} from {}.",
                                    Capitalised(TheseLogs(diagnosis)),
                                    LabelOf(active.effect->info(), active.setting),
                                    AnyOf(alternatives)));
    const std::string experiment = ToDecide(cause);
    if (experiment.empty() ||
        std::find(experiments.begin(), experiments.end(), experiment) != experiments.end()) {
      continue;
    }
    experiments.push_back(experiment);
    sentences.push_back(experiment);
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

// Two figures with as few digits as tell them apart, two at least.
std::pair<std::string, std::string> ToldApart(double a, double b) {
  for (int digits = 2; digits <= 4; ++digits) {
    if (WithDigits(a, digits) != WithDigits(b, digits)) {
      return {WithDigits(a, digits), WithDigits(b, digits)};
    }
  }
  return {WithDigits(a, 2), WithDigits(b, 2)};
}

std::string OnUnseenData(const Diagnosis& diagnosis) {
  if (diagnosis.by_left_out_logs) return "on logs left out in turn";
  return diagnosis.by_left_out_blocks ? "in cross-validation" : "on held-out data";
}

// What is put in: "it", "them", or the one that was taken of a group.
std::string WhatIsIn(const Diagnosis& diagnosis) {
  if (diagnosis.causes.size() > 1) return "them";
  const Cause& cause = diagnosis.causes.front();
  if (AlternativesOf(cause).empty()) return "it";
  const ActiveEffect& active = EffectOfCause(diagnosis, cause);
  return LabelOf(active.effect->info(), active.setting);
}

// "a gain of 32 %; 95 % interval 23 to 37 %"; a gain below zero is a loss.
std::string GainText(double gain, double low, double high) {
  const char* word = "gain";
  if (gain < 0.0) {
    word = "loss";
    gain = -gain;
    std::swap(low, high);
    low = -low;
    high = -high;
  }
  const auto percent = [](double share) { return static_cast<int>(std::lround(100.0 * share)); };
  return fmt::format(
      "a {} of {} %; 95 % interval {} to {} %", word, percent(gain), percent(low), percent(high));
}

// How the error on unseen data changes; empty where none was held out.
std::string WhatItGains(const Diagnosis& diagnosis) {
  if (diagnosis.gain_is_in_poses) {
    if (!std::isfinite(diagnosis.held_out_gain)) return "";
    const long percent = std::lround(100.0 * diagnosis.held_out_gain);
    return fmt::format(
        "{} on the poses only: with {} in the model, their motion within 10 s is predicted {} {} "
        "({})",
        diagnosis.causes.size() > 1 ? "These act" : "This acts",
        WhatIsIn(diagnosis),
        percent == 0  ? "as before"
        : percent > 0 ? "better"
                      : "worse",
        OnUnseenData(diagnosis),
        GainText(
            diagnosis.held_out_gain, diagnosis.held_out_gain_low, diagnosis.held_out_gain_high));
  }
  const double before = diagnosis.baseline.held_out.nmae, after = diagnosis.extended.held_out.nmae;
  if (!std::isfinite(before) || !std::isfinite(after)) return "";
  const auto [from, to] = ToldApart(before, after);
  std::string text =
      fmt::format("With {} in the model, the {} ", WhatIsIn(diagnosis), NameOfNmae(diagnosis));
  if (from == to) {
    text += "stays at " + from;
  } else {
    text += fmt::format("{} from {} to {}", after < before ? "falls" : "rises", from, to);
  }
  const double low = diagnosis.held_out_gain_low, high = diagnosis.held_out_gain_high;
  if (std::isfinite(low) && std::isfinite(high)) {
    text += fmt::format(" ({})", GainText(diagnosis.held_out_gain, low, high));
  }
  return text;
}

std::string Joined(const std::string& gains, const std::string& moves) {
  if (gains.empty() && moves.empty()) return "";
  if (moves.empty()) return gains + ".";
  return gains.empty() ? Capitalised(moves) + "." : fmt::format("{}, and {}.", gains, moves);
}

// Empty where it follows nothing.
std::string WhatTheRestFollows(const Diagnosis& diagnosis) {
  const auto followed = FollowedByTheRest(diagnosis);
  if (!followed) return "";
  return fmt::format(" The missing {} follows the {}, which explains {:.0f} % of it.",
                     IsAngular(diagnosis.dof) ? "moment" : "force",
                     followed->name,
                     100.0 * followed->share);
}

// What speaks against building on the causes; empty where nothing does.
std::string WhatIsLeft(const Diagnosis& diagnosis) {
  std::vector<std::string> sentences;
  if (diagnosis.held_out_gain_high < 0.0) {
    sentences.push_back(
        "On data that no fit has seen, this model is worse than the one without: do not rely on "
        "it.");
  }
  if (diagnosis.coincidence) {
    sentences.push_back(
        fmt::format("A free function of the {} explains these data about as well as {}. The cause "
                    "may be one that the catalogue does not have.",
                    diagnosis.coincidence->input,
                    diagnosis.coincidence->label));
  } else if (diagnosis.is_only_cut) {
    sentences.push_back(
        "The rest of the error is noise, but the search was ended before it was through: other "
        "causes may do as well.");
  } else if (diagnosis.verdict == Verdict::kUnexplained) {
    sentences.push_back(
        fmt::format("The remaining error is still more than noise, and no effect in the catalogue "
                    "explains it.{} What is named may only have a shape like the true cause's.",
                    WhatTheRestFollows(diagnosis)));
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

// Where nothing is named.
std::string WithoutCauses(const Diagnosis& diagnosis) {
  std::string text;
  const std::string logs = Capitalised(TheseLogs(diagnosis));
  const char* const show = diagnosis.logs.size() <= 1 ? "shows" : "show";
  if (diagnosis.verdict == Verdict::kConsistent && diagnosis.wander_ratio > kMuchMoreThanScatter) {
    text = fmt::format(
        "{} {} no cause for the error of your {} model. The error is {:.0f} times the scatter "
        "from sample to sample. It varies slowly, as under slow random forces or with a "
        "drifting sensor, and it follows nothing that was logged. It is noise, or its cause is "
        "not in the log: here `consistent` does not mean that the model is right.",
        logs,
        show,
        Name(diagnosis.dof),
        diagnosis.wander_ratio);
  } else if (diagnosis.verdict == Verdict::kConsistent) {
    text = fmt::format(
        "{} {} no error of your {} model beyond noise.", logs, show, Name(diagnosis.dof));
  } else if (diagnosis.not_named) {
    text = fmt::format(
        "Part of the error of your {} model is not noise. It fits best with {}, but {}: no cause "
        "is "
        "named.{}",
        Name(diagnosis.dof),
        diagnosis.not_named->label,
        diagnosis.not_named->why,
        WhatTheRestFollows(diagnosis));
  } else if (diagnosis.is_only_red) {
    text = fmt::format(
        "{} {} no error of your {} model beyond noise. But the red findings say that the data are "
        "wrong, and then so is the model.",
        logs,
        show,
        Name(diagnosis.dof));
  } else {
    text = fmt::format(
        "Part of the error of your {} model is not noise, and no effect in the catalogue explains "
        "it.{}",
        Name(diagnosis.dof),
        WhatTheRestFollows(diagnosis));
  }
  if (const auto missed = LargeResidual(diagnosis);
      missed && diagnosis.verdict == Verdict::kConsistent) {
    text += fmt::format("{} the command alone, the model misses up to {:.0f} % of the motion.",
                        diagnosis.wander_ratio > kMuchMoreThanScatter
                            ? " Simulated from"
                            : " But the noise is large: simulated from",
                        100.0 * *missed);
  }
  const double nmae = diagnosis.baseline.held_out.nmae;
  if (std::isfinite(nmae)) {
    text += fmt::format(" The {} is {}.", NameOfNmae(diagnosis), WithDigits(nmae, 2));
  }
  return text;
}

}  // namespace

std::string_view FittedQuantity(const Diagnosis& diagnosis) {
  return diagnosis.has_velocity ? "velocity" : "position";
}

std::string_view WhereUnseen(const Diagnosis& diagnosis) {
  if (diagnosis.by_left_out_logs) return "logs left out";
  return diagnosis.by_left_out_blocks ? "cross-validated" : "held-out data";
}

std::string NameOfNmae(const Diagnosis& diagnosis) {
  const std::string_view quantity = FittedQuantity(diagnosis);
  if (diagnosis.by_left_out_logs) return fmt::format("{} NMAE on logs left out in turn", quantity);
  return diagnosis.by_left_out_blocks ? fmt::format("cross-validated {} NMAE", quantity)
                                      : fmt::format("{} NMAE on held-out data", quantity);
}

std::vector<std::string> VerdictParagraphs(const Diagnosis& diagnosis) {
  if (diagnosis.causes.empty()) return {WithoutCauses(diagnosis)};
  std::vector<std::string> paragraphs = {diagnosis.has_baseline ? WhyItMisses(diagnosis)
                                                                : WhatItTakes(diagnosis)};
  const auto add = [&](const std::string& text) {
    if (!text.empty()) paragraphs.push_back(text);
  };
  add(WhatIsOpen(diagnosis));
  add(Joined(WhatItGains(diagnosis), WhatMoves(diagnosis)));
  add(WhatIsLeft(diagnosis));
  return paragraphs;
}

std::string VerdictSentence(const Diagnosis& diagnosis) {
  return fmt::format("{}", fmt::join(VerdictParagraphs(diagnosis), " "));
}

}  // namespace fathom
