// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/verdict_sentence.h"

#include "fathom/report/format_value.h"
#include "fathom/vehicle/model_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kHalfInterval = 1.96;  // of 95 %, in standard deviations
constexpr std::size_t kMostTold = 2;    // alternatives that are told in words

constexpr std::array<const char*, 4> kCounts = {"no", "one", "two", "three"};

// "38 %"; "Part" where no share is known.
std::string Percent(double share) {
  if (!(share >= 0.005)) return "Part";
  return fmt::format("{:.0f} %", 100.0 * share);
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

// An experiment as it follows "To decide: ": what it does, and in brackets why.
std::string ToDecide(std::string experiment) {
  if (experiment.empty() || experiment.starts_with("No ")) return experiment;
  while (experiment.back() == '.') experiment.pop_back();
  if (experiment.size() > 1 && std::islower(static_cast<unsigned char>(experiment[1])) != 0) {
    experiment[0] = static_cast<char>(std::tolower(experiment[0]));
  }
  if (experiment.starts_with("A ")) experiment[0] = 'a';
  const std::size_t colon = experiment.find(": ");
  if (colon != std::string::npos) experiment.replace(colon, 2, " (") += ")";
  return fmt::format("To decide: {}.", experiment);
}

// Without those that stand there twice, in their order.
std::vector<std::string> Alternatives(const Cause& cause) {
  std::vector<std::string> labels;
  for (const std::string& label : cause.alternatives) {
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
  }
  return labels;
}

// Decimals that show the first digit of `size`, or its second if the first is a 1; below 0 they
// stand before the point.
int DecimalsFor(double size) {
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  const double first_digit = size / std::pow(10.0, exponent);
  return first_digit < 1.95 ? 1 - exponent : -exponent;
}

std::string RoundedAt(double value, int decimals) {
  constexpr int kMostDecimals = 6;
  if (decimals > kMostDecimals || std::abs(value) >= 1e6) return fmt::format("{:.3g}", value);
  if (decimals < 0) {
    const double unit = std::pow(10.0, -decimals);
    value = std::round(value / unit) * unit;
  }
  std::string text = fmt::format("{:.{}f}", value, std::max(decimals, 0));
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

const ActiveEffect& EffectOf(const Diagnosis& diagnosis, const Cause& cause) {
  return diagnosis.extended.model.effects.at(static_cast<std::size_t>(cause.effect_index));
}

// "time_constant 0.42 s (0.39 to 0.45 s)" for each parameter.
std::string Sizes(const Diagnosis& diagnosis, int effect_index) {
  const ActiveEffect& active =
      diagnosis.extended.model.effects.at(static_cast<std::size_t>(effect_index));
  const std::vector<double> stds = EffectStds(diagnosis.extended, effect_index);
  std::vector<std::string> sizes;
  for (std::size_t k = 0; k < active.values.size(); ++k) {
    const EffectParameter& parameter = active.effect->info().parameters[k];
    const std::string unit = UnitOf(parameter.quantity, diagnosis.dof, diagnosis.force_unit);
    std::string name(parameter.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    sizes.push_back(fmt::format(
        "{} {}{}",
        name,
        WithInterval(
            active.values[k], stds[k], unit == "-" ? "" : unit, parameter.lower, parameter.upper),
        parameter.search == Search::kTimeOfRun ? " after the first command" : ""));
  }
  return fmt::format("{}", fmt::join(sizes, ", "));
}

// "the propellers take time to reach their speed (thruster_lag)" for a label of an alternative.
std::string Told(const std::string& label) {
  const Effect* effect = FindEffect(label.substr(0, label.find('(')));
  return effect == nullptr ? label : fmt::format("{} ({})", effect->info().cause, label);
}

// What a cause is and how large, and what it may be instead, after "because".
std::string Reason(const Diagnosis& diagnosis, const Cause& cause) {
  const ActiveEffect& active = EffectOf(diagnosis, cause);
  const EffectInfo& info = active.effect->info();
  std::string reason = fmt::format("{} ({}), {}",
                                   info.cause,
                                   LabelOf(info, active.setting),
                                   Sizes(diagnosis, cause.effect_index));
  const std::vector<std::string> alternatives = Alternatives(cause);
  if (alternatives.empty()) return reason;
  if (alternatives.size() > kMostTold) {
    return fmt::format("{}, or because of one of {}", reason, fmt::join(alternatives, ", "));
  }
  for (const std::string& label : alternatives) reason += ", or because " + Told(label);
  return reason;
}

// Why the error is there, all causes together.
std::string WhyItMisses(const Diagnosis& diagnosis) {
  const std::string share = Percent(diagnosis.structure_share * diagnosis.explained_share);
  const std::string subject =
      fmt::format("{} of the error of your {} model", share, Name(diagnosis.dof));
  if (diagnosis.causes.size() == 1) {
    return fmt::format(
        "{} is there because {}.", subject, Reason(diagnosis, diagnosis.causes.front()));
  }
  std::vector<std::string> reasons;
  for (const Cause& cause : diagnosis.causes) reasons.push_back(Reason(diagnosis, cause));
  const std::string count =
      reasons.size() < kCounts.size() ? kCounts[reasons.size()] : fmt::format("{}", reasons.size());
  return fmt::format("{} has {} causes. It is there because {}.",
                     subject,
                     count,
                     fmt::join(reasons, "; and because "));
}

// What cannot be told apart, and what would tell; empty if everything can.
std::string WhatIsOpen(const Diagnosis& diagnosis) {
  std::string text;
  std::vector<std::string> experiments;
  for (const Cause& cause : diagnosis.causes) {
    const std::vector<std::string> alternatives = Alternatives(cause);
    if (alternatives.empty()) continue;
    const ActiveEffect& active = EffectOf(diagnosis, cause);
    text += fmt::format(" {} cannot tell {} from {}.",
                        Capitalised(TheseLogs(diagnosis)),
                        LabelOf(active.effect->info(), active.setting),
                        fmt::join(alternatives, " or "));
    const std::string experiment = ToDecide(cause.experiment);
    if (experiment.empty() ||
        std::find(experiments.begin(), experiments.end(), experiment) != experiments.end()) {
      continue;
    }
    experiments.push_back(experiment);
    text += " " + experiment;
  }
  return text;
}

// Two figures with as few digits as tell them apart, two at least.
std::pair<std::string, std::string> ToldApart(double a, double b) {
  for (int digits = 2; digits <= 4; ++digits) {
    const auto text = [&](double value) { return fmt::format("{:.{}g}", value, digits); };
    if (text(a) != text(b)) return {text(a), text(b)};
  }
  return {fmt::format("{:.2g}", a), fmt::format("{:.2g}", b)};
}

std::string OnUnseenData(const Diagnosis& diagnosis) {
  return diagnosis.by_left_out_blocks ? "on blocks left out in turn" : "on held-out data";
}

// How the error on unseen data changes; empty where none was held out.
std::string WhatItGains(const Diagnosis& diagnosis) {
  const double before = diagnosis.baseline.held_out.nmae, after = diagnosis.extended.held_out.nmae;
  if (!std::isfinite(before) || !std::isfinite(after)) return "";
  const auto [from, to] = ToldApart(before, after);
  std::string text = fmt::format("With {} in, NMAE {} ",
                                 diagnosis.causes.size() == 1 ? "it" : "them",
                                 OnUnseenData(diagnosis));
  if (from == to) {
    text += "stays at " + from;
  } else {
    text += fmt::format("{} from {} to {}", after < before ? "falls" : "rises", from, to);
  }
  if (std::isfinite(diagnosis.held_out_gain_low) && std::isfinite(diagnosis.held_out_gain_high)) {
    text += fmt::format(" (a gain of {:.0f} %; 95 % interval {:.0f} to {:.0f} %)",
                        100.0 * diagnosis.held_out_gain,
                        100.0 * diagnosis.held_out_gain_low,
                        100.0 * diagnosis.held_out_gain_high);
  }
  return text;
}

// RMS of what each parameter of the baseline multiplies, over the extended model's free runs (which
// hold no noise): acceleration, v|v|, v, 1.
std::array<double, kNumParameters> Loads(const Diagnosis& diagnosis) {
  std::array<double, kNumParameters> sums = {};
  double count = 0.0;
  for (const ResidualTrace& trace : diagnosis.traces) {
    std::vector<double> v = trace.after;
    std::vector<double> time = trace.time;
    const auto differentiate = [&](const std::vector<double>& values) {
      std::vector<double> slopes;
      for (std::size_t i = 1; i < values.size(); ++i) {
        slopes.push_back((values[i] - values[i - 1]) / (time[i] - time[i - 1]));
      }
      return slopes;
    };
    if (!diagnosis.has_velocity) v = differentiate(v);
    if (v.size() < time.size()) time.erase(time.begin());
    const std::vector<double> slopes = differentiate(v);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      const std::array<double, kNumParameters> loads = {slopes[i], v[i] * v[i], v[i], 1.0};
      for (int k = 0; k < kNumParameters; ++k) sums[k] += loads[k] * loads[k];
      count += 1.0;
    }
  }
  for (double& sum : sums) sum = count > 0.0 ? std::sqrt(sum / count) : 0.0;
  return sums;
}

// The parameter of the baseline whose share of the force changes most, among those that move by
// more than their interval; empty if none does.
std::string WhatMoves(const Diagnosis& diagnosis) {
  const ParameterVector before = ToVector(diagnosis.baseline.model.baseline);
  const ParameterVector after = ToVector(diagnosis.extended.model.baseline);
  const std::array<double, kNumParameters> loads = Loads(diagnosis);
  const auto std_of = [](const DiagnosedModel& model, int i) {
    return i < model.covariance.rows() ? std::sqrt(model.covariance(i, i))
                                       : std::numeric_limits<double>::quiet_NaN();
  };
  int most = -1;
  double most_force = 0.0;
  for (int i = 0; i < kNumParameters; ++i) {
    const double way = std::abs(after[i] - before[i]);
    if (!(way > kHalfInterval * std_of(diagnosis.extended, i))) continue;
    if (way * loads[i] > most_force) {
      most = i;
      most_force = way * loads[i];
    }
  }
  if (most < 0) return "";
  // No finer than a thousandth: what counts is how far it moves.
  const double finest = 1e-3 * std::max(std::abs(before[most]), std::abs(after[most]));
  const int decimals =
      DecimalsFor(std::max(kHalfInterval * std_of(diagnosis.extended, most), finest));
  std::string name(kParameterInfo[most].name);
  std::replace(name.begin(), name.end(), '_', ' ');
  return fmt::format("the {} moves from {} to {} {}",
                     name,
                     RoundedAt(before[most], decimals),
                     RoundedAt(after[most], decimals),
                     ParameterUnit(most, diagnosis.dof, diagnosis.force_unit));
}

std::string Joined(const std::string& gains, const std::string& moves) {
  if (gains.empty() && moves.empty()) return "";
  if (moves.empty()) return " " + gains + ".";
  return gains.empty() ? fmt::format(" {}.", Capitalised(moves))
                       : fmt::format(" {}, and {}.", gains, moves);
}

std::string Remainder(const Diagnosis& diagnosis) {
  if (diagnosis.verdict != Verdict::kUnexplained) return "";
  return " What is left is still not noise alone, and nothing in the catalogue accounts for it.";
}

}  // namespace

std::string WithInterval(
    double value, double std, std::string_view unit, double lower, double upper) {
  const auto with_unit = [&](const std::string& number) {
    return unit.empty() ? number : fmt::format("{} {}", number, unit);
  };
  if (!std::isfinite(std) || !(std > 0.0)) return with_unit(FormatValue(value));
  const double half = kHalfInterval * std;
  const int decimals = DecimalsFor(half);
  return fmt::format("{} ({} to {})",
                     with_unit(RoundedAt(value, decimals)),
                     RoundedAt(std::max(value - half, lower), decimals),
                     with_unit(RoundedAt(std::min(value + half, upper), decimals)));
}

std::vector<double> EffectStds(const DiagnosedModel& model, int effect_index) {
  Eigen::Index first = kNumParameters;
  for (int k = 0; k < effect_index; ++k) {
    first += static_cast<Eigen::Index>(model.model.effects[k].values.size());
  }
  std::vector<double> stds;
  for (std::size_t k = 0; k < model.model.effects.at(effect_index).values.size(); ++k) {
    const Eigen::Index i = first + static_cast<Eigen::Index>(k);
    stds.push_back(i < model.covariance.rows() ? std::sqrt(model.covariance(i, i))
                                               : std::numeric_limits<double>::quiet_NaN());
  }
  return stds;
}

std::string VerdictSentence(const Diagnosis& diagnosis) {
  const std::string_view dof = Name(diagnosis.dof);
  if (diagnosis.verdict == Verdict::kConsistent) {
    std::string text = fmt::format("{} show{} nothing that your {} model gets wrong beyond noise.",
                                   Capitalised(TheseLogs(diagnosis)),
                                   diagnosis.logs.size() <= 1 ? "s" : "",
                                   dof);
    if (std::isfinite(diagnosis.baseline.held_out.nmae)) {
      text += fmt::format(
          " Its NMAE {} is {:.2g}.", OnUnseenData(diagnosis), diagnosis.baseline.held_out.nmae);
    }
    return text;
  }
  if (diagnosis.causes.empty()) {
    return fmt::format(
        "{} of the error of your {} model is not noise, and nothing in the catalogue "
        "accounts for it.",
        Percent(diagnosis.structure_share),
        dof);
  }
  return WhyItMisses(diagnosis) + WhatIsOpen(diagnosis) +
         Joined(WhatItGains(diagnosis), WhatMoves(diagnosis)) + Remainder(diagnosis);
}

std::vector<std::string> NextSteps(const Diagnosis& diagnosis) {
  std::vector<std::string> steps;
  for (const Cause& cause : diagnosis.causes) {
    const ActiveEffect& active = EffectOf(diagnosis, cause);
    const EffectInfo& info = active.effect->info();
    const std::string label = LabelOf(info, active.setting);
    const std::vector<std::string> alternatives = Alternatives(cause);
    if (alternatives.empty()) {
      steps.push_back(fmt::format("{}: {}", label, info.advice));
    } else {
      steps.push_back(fmt::format("Find out first whether it is {} or {}. {}",
                                  label,
                                  fmt::join(alternatives, " or "),
                                  ToDecide(cause.experiment)));
      steps.push_back(fmt::format("If it is {}: {}", label, info.advice));
    }
    for (const std::string& alternative : alternatives) {
      const Effect* effect = FindEffect(alternative.substr(0, alternative.find('(')));
      if (effect == nullptr) continue;
      steps.push_back(fmt::format("If it is {}: {}", alternative, effect->info().advice));
    }
    if (info.scope == Scope::kRun) {
      steps.push_back(fmt::format(
          "{} belongs to this run: fathom_simulate leaves it out on any other log.", label));
    }
  }
  if (diagnosis.verdict == Verdict::kUnexplained) {
    steps.push_back(
        "Look at what the missing force follows: something that was not logged, a mechanism of "
        "your "
        "own (docs/adding_an_effect.md), or slow forces of the water itself.");
  }
  if (diagnosis.verdict == Verdict::kConsistent) {
    steps.push_back(
        "Use the model within the speeds and commands of this data. What they did not excite they "
        "cannot show: an experiment of another kind is the test.");
  }
  return steps;
}

}  // namespace fathom
