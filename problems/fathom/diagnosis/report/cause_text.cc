// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/cause_text.h"

#include "fathom/base/interval95.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// Alternatives that are told in words, and that are listed within a sentence.
constexpr std::size_t kMostTold = 2, kMostListed = 4;

// "time_constant 0.42 s (0.39 to 0.45 s)" for each parameter.
std::string Sizes(const Diagnosis& diagnosis, const Cause& cause) {
  const ActiveEffect& active = EffectOfCause(diagnosis, cause);
  const std::vector<double> stds = EffectStds(diagnosis.extended, cause.effect_index);
  std::vector<std::string> sizes;
  for (std::size_t k = 0; k < active.values.size(); ++k) {
    const EffectParameter& parameter = active.effect->info().parameters[k];
    const std::string unit = UnitOf(parameter.quantity, diagnosis.dof, diagnosis.force_unit);
    std::string name(parameter.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    const double value = active.values[k];
    const bool is_at_bound = value == parameter.lower || value == parameter.upper;
    sizes.push_back(fmt::format(
        "{} {}{}{}",
        name,
        WithInterval(value, stds[k], unit == "-" ? "" : unit, parameter.lower, parameter.upper),
        parameter.search == Search::kTimeOfRun ? " after the first command" : "",
        is_at_bound ? " (its physical bound)" : ""));
  }
  return fmt::format("{}", fmt::join(sizes, ", "));
}

// "-100.0 % (± 0.2 %)".
std::string ChangeText(const WeakThruster& thruster) {
  return fmt::format(
      "{:.1f} % (± {:.2g} %)", 100.0 * thruster.change, 100.0 * kStdsOf95 * thruster.std);
}

// "a lag of the thrusters (thruster_lag)".
std::string Told(const Alternative& alternative) {
  return fmt::format("{} ({})", alternative.effect->info().cause, alternative.label);
}

}  // namespace

const ActiveEffect& EffectOfCause(const Diagnosis& diagnosis, const Cause& cause) {
  return diagnosis.extended.model.effects.at(static_cast<std::size_t>(cause.effect_index));
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

std::vector<Alternative> AlternativesOf(const Cause& cause) {
  std::vector<Alternative> alternatives;
  for (const Alternative& alternative : cause.alternatives) {
    const bool is_new =
        std::none_of(alternatives.begin(), alternatives.end(), [&](const Alternative& other) {
          return other.label == alternative.label;
        });
    if (is_new) alternatives.push_back(alternative);
  }
  return alternatives;
}

std::vector<std::string> LabelsOf(const std::vector<Alternative>& alternatives) {
  std::vector<std::string> labels;
  for (const Alternative& alternative : alternatives) labels.push_back(alternative.label);
  return labels;
}

std::string PlacesText(const Diagnosis& diagnosis, const Cause& cause) {
  std::set<Place> places = {EffectOfCause(diagnosis, cause).effect->info().place};
  for (const Alternative& alternative : cause.alternatives) {
    places.insert(alternative.effect->info().place);
  }
  std::vector<std::string> names;
  for (const Place place : places) {
    names.push_back(fmt::format("{} the {}", place == Place::kWater ? "in" : "of", Name(place)));
  }
  return fmt::format("{}", fmt::join(names, " or "));
}

std::string AdviceText(const Diagnosis& diagnosis, const Cause& cause) {
  const ActiveEffect& active = EffectOfCause(diagnosis, cause);
  const EffectInfo& info = active.effect->info();
  if (cause.thruster) {
    return fmt::format(
        "Look at thruster {}: its propeller, its cable, and its place and direction in the vehicle "
        "file.",
        cause.thruster->name);
  }
  const std::vector<double>& command = diagnosis.missing_force.command;
  const Quantity& quantity = info.parameters.front().quantity;
  const bool is_force = quantity.force == 1.0 && quantity.speed == 0.0 && quantity.time == 0.0;
  const bool is_step_of_force = info.depends_on_time && info.place == Place::kWater && is_force;
  if (!is_step_of_force || command.empty()) return std::string(info.advice);
  double sum = 0.0;
  for (const double force : command) sum += force * force;
  const double usual = std::sqrt(sum / static_cast<double>(command.size()));
  if (!(std::abs(active.values.front()) > usual)) return std::string(info.advice);
  return "The step is as large as the thrust itself. Look for thrusters that stopped or ran on, a "
         "vehicle held fast, or a command that was not carried out at that time. A payload is that "
         "heavy on no vehicle that still moves.";
}

std::string ReasonText(const Diagnosis& diagnosis,
                       const Cause& cause,
                       std::string_view preposition) {
  const ActiveEffect& active = EffectOfCause(diagnosis, cause);
  const EffectInfo& info = active.effect->info();
  std::string reason = fmt::format(
      "{} ({}), {}", info.cause, LabelOf(info, active.setting), Sizes(diagnosis, cause));
  if (cause.thruster) {
    reason += fmt::format(
        ", which is thruster({}) at {}", cause.thruster->name, ChangeText(*cause.thruster));
  }
  const std::vector<Alternative> alternatives = AlternativesOf(cause);
  if (alternatives.empty()) return reason;
  if (alternatives.size() > kMostListed) {
    return fmt::format("an effect {}: {} fits best, and {} others fit as well",
                       PlacesText(diagnosis, cause),
                       reason,
                       alternatives.size());
  }
  if (alternatives.size() > kMostTold) {
    return fmt::format(
        "{}, or {}one of {}", reason, preposition, fmt::join(LabelsOf(alternatives), ", "));
  }
  for (const Alternative& alternative : alternatives) {
    reason += fmt::format(", or {}{}", preposition, Told(alternative));
  }
  return reason;
}

std::string AnyOf(const std::vector<std::string>& labels) {
  if (labels.size() <= kMostListed) return fmt::format("{}", fmt::join(labels, " or "));
  return fmt::format("any of {}", fmt::join(labels, ", "));
}

std::string ToDecide(const Cause& cause) {
  std::string experiment = cause.experiment.text;
  if (experiment.empty() || !cause.experiment.decides) return experiment;
  while (experiment.back() == '.') experiment.pop_back();
  if (experiment.size() > 1 && std::islower(static_cast<unsigned char>(experiment[1])) != 0) {
    experiment[0] = static_cast<char>(std::tolower(experiment[0]));
  }
  if (experiment.starts_with("A ")) experiment[0] = 'a';
  const std::size_t colon = experiment.find(": ");
  if (colon != std::string::npos) experiment.replace(colon, 2, " (") += ")";
  return fmt::format("To decide: {}.", experiment);
}

}  // namespace fathom
