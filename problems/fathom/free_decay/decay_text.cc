// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/decay_text.h"

#include "fathom/base/files/json_text.h"
#include "fathom/base/interval95.h"
#include "fathom/report/format_value.h"
#include "fathom/report/table.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

// In the order in which they are shown.
std::vector<int> RatesOf(const LogDecay& decay) {
  return {kLinearRate, kQuadraticRate, decay.has_stiffness ? kStiffnessRate : kConstantRate};
}

// Of dampings those of a model file.
std::string NameOf(int rate, Dof dof) {
  switch (rate) {
    case kLinearRate:
      return kParameterInfo[kLinearDamping].name;
    case kQuadraticRate:
      return kParameterInfo[kQuadraticDamping].name;
    case kStiffnessRate:
      return "stiffness";
    default:
      if (IsAngular(dof)) return "constant_moment";
      return dof == Dof::kHeave ? "net_buoyancy" : "constant_force";
  }
}

std::string RateUnit(int rate, Dof dof) {
  const std::string length(DisplacementUnit(dof));
  switch (rate) {
    case kLinearRate:
      return "1/s";
    case kQuadraticRate:
      return "1/" + length;
    case kStiffnessRate:
      return "1/s^2";
    default:
      return length + "/s^2";
  }
}

std::string UnitOf(int rate, Dof dof) {
  const std::string force(ForceUnit(dof));
  switch (rate) {
    case kLinearRate:
      return ParameterUnit(kLinearDamping, dof, force);
    case kQuadraticRate:
      return ParameterUnit(kQuadraticDamping, dof, force);
    case kStiffnessRate:
      return IsAngular(dof) ? "N m/rad" : "N/m";
    default:
      return force;
  }
}

double LowerBound(int rate) {
  return rate == kConstantRate ? -std::numeric_limits<double>::infinity() : 0.0;
}

double DecayStd(const LogDecay& decay, int rate) {
  return std::sqrt(decay.summary.covariance(rate, rate));
}

double RateOf(const LogDecay& decay, int rate) {
  return decay.summary.rates[static_cast<std::size_t>(rate)];
}

std::string InertiaUnit(Dof dof) {
  return ParameterUnit(kInertia, dof, std::string(ForceUnit(dof)));
}

// What cannot be seen in the table.
std::vector<std::string> NotesOn(const LogDecay& decay) {
  std::vector<std::string> notes = decay.summary.caveats;
  const double constant = RateOf(decay, kConstantRate);
  if (!decay.has_stiffness && std::abs(constant) > kStdsOf95 * DecayStd(decay, kConstantRate)) {
    notes.push_back(fmt::format(
        "A constant {} is in it, {} {} by the inertia: a current, a tether, an offset of "
        "the sensor, or a drive that was not off. The last spoils the dampings.",
        IsAngular(decay.dof) ? "moment" : "force",
        FormatValue(constant, DecayStd(decay, kConstantRate)),
        UnitText(RateUnit(kConstantRate, decay.dof))));
  }
  if (decay.has_stiffness) {
    const double c = RateOf(decay, kStiffnessRate), a = RateOf(decay, kLinearRate);
    if (c > a * a / 4.0) {
      notes.push_back(fmt::format("period of small swings: {:.3g} s",
                                  2.0 * 3.14159265358979 / std::sqrt(c - a * a / 4.0)));
    }
  }
  if (decay.dry_mass) {
    notes.push_back(fmt::format(
        "Of the inertia only the dry mass is known, {:g} kg. The water that moves along adds "
        "to it, so linear_damping is at least {:.3g} kg/s and quadratic_damping at least {:.3g} "
        "kg/m. `inertia: {{{}: ...}}` in the vehicle file, mass and added mass, gives them.",
        *decay.dry_mass,
        *decay.dry_mass * RateOf(decay, kLinearRate),
        *decay.dry_mass * RateOf(decay, kQuadraticRate),
        Name(decay.dof)));
  } else if (!decay.inertia) {
    notes.push_back(fmt::format(
        "Without a force, a decay tells ratios to the inertia only. `inertia: {{{}: ...}}` "
        "[{}] in the vehicle file gives the parameters themselves.",
        Name(decay.dof),
        UnitText(InertiaUnit(decay.dof))));
  }
  return notes;
}

}  // namespace

std::vector<DecayQuantity> QuantitiesOf(const LogDecay& decay) {
  std::vector<DecayQuantity> quantities;
  for (const int rate : RatesOf(decay)) {
    quantities.push_back({NameOf(rate, decay.dof) + " / inertia",
                          RateUnit(rate, decay.dof),
                          RateOf(decay, rate),
                          DecayStd(decay, rate),
                          LowerBound(rate)});
  }
  if (!decay.inertia) return quantities;
  for (const int rate : RatesOf(decay)) {
    quantities.push_back({NameOf(rate, decay.dof),
                          UnitOf(rate, decay.dof),
                          *decay.inertia * RateOf(decay, rate),
                          *decay.inertia * DecayStd(decay, rate),
                          LowerBound(rate)});
  }
  return quantities;
}

std::string QuantitiesText(const LogDecay& decay) {
  std::vector<std::string> told;
  for (const DecayQuantity& quantity : QuantitiesOf(decay)) {
    told.push_back(fmt::format("{} {}",
                               quantity.name,
                               WithInterval(quantity.value,
                                            quantity.std,
                                            UnitText(quantity.unit),
                                            quantity.lower_bound,
                                            std::numeric_limits<double>::infinity())));
  }
  return fmt::format("{}", fmt::join(told, ", "));
}

std::string DecaySentence(const LogDecay& decay) {
  const std::string rule = fmt::format(
      "Nothing drives {}: without a command, {}",
      Name(decay.dof),
      decay.inertia ? "the damping is known as far as the inertia of the vehicle file is"
                    : "only ratios to the inertia can be known");
  return decay.summary.IsUsable()
             ? fmt::format("{}. This free decay tells {}.", rule, QuantitiesText(decay))
             : fmt::format(
                   "{}, and no free decay tells them here. {}", rule, decay.summary.message);
}

double NmaeOf(const LogDecay& decay) {
  if (decay.output != DecayOutput::kVelocity || decay.summary.residuals.size() == 0) {
    return FreeDecaySummary::kNotComputed;
  }
  double sum = 0.0;
  for (const DecayStretch& stretch : decay.measured) {
    for (const double speed : stretch.motion) sum += std::abs(speed);
  }
  return decay.summary.residuals.lpNorm<1>() / sum;
}

Table QuantityTable(const LogDecay& decay) {
  Table table;
  table.columns = {{"parameter"}, {"value", true}, {"unit"}, {"95 % interval", true}};
  for (const DecayQuantity& quantity : QuantitiesOf(decay)) {
    table.rows.push_back({{quantity.name,
                           FormatValue(quantity.value, quantity.std),
                           UnitText(quantity.unit),
                           FormatInterval(quantity.value, quantity.std, quantity.lower_bound)}});
  }
  return table;
}

std::string FormatDecay(const LogDecay& decay) {
  std::string text;
  for (const std::string& note : decay.notes) text += "note: " + note + "\n";
  if (!decay.summary.IsUsable()) return text;
  const FreeDecaySummary& summary = decay.summary;
  text += fmt::format("{}: {}\n", Name(decay.dof), summary.message);
  text += FormatTable(QuantityTable(decay)) + "±: one standard deviation\n";
  if (decay.inertia) {
    text += fmt::format("inertia: {:g} {}, of the vehicle file, taken as exact\n",
                        *decay.inertia,
                        UnitText(InertiaUnit(decay.dof)));
  }
  text += fmt::format("residual {:.2g} {} over speeds of {:.3g} to {:.3g} {}\n",
                      summary.rms,
                      decay.output == DecayOutput::kVelocity ? VelocityUnit(decay.dof)
                                                             : DisplacementUnit(decay.dof),
                      summary.smallest_speed,
                      summary.largest_speed,
                      VelocityUnit(decay.dof));
  for (const std::string& note : NotesOn(decay)) text += "note: " + note + "\n";
  return text;
}

std::vector<std::string> DecayComments(const LogDecay& decay) {
  std::vector<std::string> comments = decay.notes;
  if (!decay.summary.IsUsable()) return comments;
  std::ranges::move(NotesOn(decay), std::back_inserter(comments));
  return comments;
}

std::string FormatDecayJson(const LogDecay& decay, const std::string& log) {
  const auto number = [](double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  };
  Json quantities = Json::object(), stretches = Json::array();
  if (decay.summary.IsUsable()) {
    for (const DecayQuantity& quantity : QuantitiesOf(decay)) {
      quantities[quantity.name] = {{"value", number(quantity.value)},
                                   {"std", number(quantity.std)},
                                   {"unit", quantity.unit}};
    }
  }
  for (const TimeInterval& time : decay.stretches) {
    stretches.push_back(Json::array({time.from, time.to}));
  }
  const Json json = {{"schema", "fathom-decay-1"},
                     {"log", log},
                     {"dof", Name(decay.dof)},
                     {"source", Name(decay.source)},
                     {"usable", decay.summary.IsUsable()},
                     {"message", decay.summary.message},
                     {"sentence", DecaySentence(decay)},
                     {"stretches", std::move(stretches)},
                     {"inertia", decay.inertia ? Json(*decay.inertia) : Json(nullptr)},
                     {"parameters", std::move(quantities)},
                     {"rms", number(decay.summary.rms)},
                     {"notes", decay.notes},
                     {"caveats", decay.summary.caveats}};
  return JsonText(json);
}

std::optional<FittedModel> ModelOf(const LogDecay& decay) {
  if (!decay.summary.IsUsable() || !decay.inertia || decay.has_stiffness) return std::nullopt;
  const double inertia = *decay.inertia;
  FittedModel fitted;
  fitted.dof = decay.dof;
  fitted.force_unit = ForceUnit(decay.dof);
  fitted.model.inertia = inertia;
  fitted.model.linear_damping = inertia * RateOf(decay, kLinearRate);
  fitted.model.quadratic_damping = inertia * RateOf(decay, kQuadraticRate);
  fitted.model.buoyancy = inertia * RateOf(decay, kConstantRate);
  fitted.covariance.setZero();
  const std::pair<int, int> places[] = {{kLinearDamping, kLinearRate},
                                        {kQuadraticDamping, kQuadraticRate},
                                        {kBuoyancy, kConstantRate}};
  for (const auto& [row, row_rate] : places) {
    for (const auto& [column, column_rate] : places) {
      fitted.covariance(row, column) =
          inertia * inertia * decay.summary.covariance(row_rate, column_rate);
    }
  }
  fitted.caveats = decay.summary.caveats;
  fitted.caveats.push_back("From a free decay: the inertia is that of the vehicle file, as exact.");
  return fitted;
}

}  // namespace fathom
