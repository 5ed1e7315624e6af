// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/event_text.h"

#include "fathom/base/listed.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

namespace fathom {
namespace {

constexpr double kClearDeviations = 2.0;

struct Number {
  double value = 0.0;
  double std = 0.0;
};

// "14", "(± 2)" around what stands between them.
std::string WithDeviation(const Number& number, const std::string& between) {
  const int decimals = DecimalsFor(number.std);
  return RoundedAt(std::abs(number.value), decimals) + between + " (± " +
         RoundedAt(number.std, decimals) + ")";
}

// "inertia in surge", "thrust gain of port", "inertia that couples sway and yaw".
std::string NameOfNumber(const DiveSeries& one) {
  const std::string dof(Name(one.dof));
  std::string name =
      one.entry ? NameOf(*one.entry) : std::string(kParameterInfo[one.parameter].name);
  name = name.substr(0, name.find('.'));
  std::replace(name.begin(), name.end(), '_', ' ');
  if (one.IsOfActuator()) return name + " of " + one.entry->actuator;
  if (!one.entry || one.entry->row == one.entry->column) return name + " in " + dof;
  const std::string column(Name(one.entry->column));
  return one.entry->kind == FreeEntry::Kind::kInertia
             ? name + " that couples " + dof + " and " + column
             : name + " in " + dof + " by " + column;
}

// With a space before it; empty of a number without one.
std::string UnitOfNumber(const DiveSeries& one) {
  const std::string unit =
      one.entry ? UnitOf(*one.entry)
                : ParameterUnit(one.parameter, one.dof, std::string(ForceUnit(one.dof)));
  return unit == "1" ? "" : " " + UnitText(unit);
}

struct Teller {
  const NamedCause& named;
  const EventFit& event;
  const Column& column;
  std::span<const DiveSeries> series;
  std::span<const char> told;
  std::span<const std::string> dive_names;

  bool IsTrend() const { return column.kind == ChangeKind::kTrend; }

  // A trend's difference is told for each dive.
  double PerDive() const {
    return IsTrend() ? 1.0 / std::max<double>(dive_names.size() - 1.0, 1.0) : 1.0;
  }

  std::string Opening() const {
    if (IsTrend()) return "";
    const std::string& name = dive_names[column.at];
    return (name.starts_with("dive") ? "From " : "From dive ") + name + " on ";
  }

  bool IsTold(std::size_t i) const {
    const int s = event.series[i];
    return named.cause == "unnamed" ? told[s] != 0 : named.pattern.Moves(s);
  }

  std::string Dofs(bool with_angular = true) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < event.series.size(); ++i) {
      if (series[event.series[i]].IsOfActuator()) continue;
      const Dof dof = series[event.series[i]].dof;
      if (IsAngular(dof) && !with_angular) continue;
      const std::string name(Name(dof));
      if (IsTold(i) && (names.empty() || names.back() != name)) names.push_back(name);
    }
    return Listed(names);
  }

  Number Difference(std::size_t i) const {
    const Eigen::Index m = event.before.size();
    const double scale = series[event.series[i]].scale * PerDive();
    return {scale * event.difference(i), scale * std::sqrt(event.covariance(m + i, m + i))};
  }

  // The told of which it is clear that they changed; all told, where it is clear of none.
  std::vector<std::size_t> ClearOf(const std::vector<std::size_t>& told_ones) const {
    std::vector<std::size_t> clear;
    for (const std::size_t i : told_ones) {
      const Number number = Difference(i);
      if (std::abs(number.value) > kClearDeviations * number.std) clear.push_back(i);
    }
    return clear.empty() ? told_ones : clear;
  }

  // "the buoyancy in heave is 5.0 N larger (± 0.4)", "... grows by 5.0 N a dive (± 0.4)".
  std::string Parameters(bool with_linear = true) const {
    std::vector<std::size_t> told_ones;
    for (std::size_t i = 0; i < event.series.size(); ++i) {
      if (IsTold(i) && (with_linear || !HasMass(series[event.series[i]]))) told_ones.push_back(i);
    }
    std::vector<std::string> items;
    for (const std::size_t i : ClearOf(told_ones)) {
      const DiveSeries& one = series[event.series[i]];
      const Number number = Difference(i);
      const std::string unit = UnitOfNumber(one);
      const bool grows = number.value > 0.0;
      std::string item = "the " + NameOfNumber(one);
      if (IsTrend()) {
        item += (grows ? " grows by " : " falls by ") + WithDeviation(number, unit + " a dive");
      } else {
        item += " is " + WithDeviation(number, unit + (grows ? " larger" : " smaller"));
      }
      items.push_back(item);
    }
    return Listed(items);
  }

  // The common factor of what the pattern moves, in percent of what it was.
  std::string Percent(const std::string& what,
                      const std::string& more,
                      const std::string& less,
                      const Number& share) const {
    const Number percent{100.0 * PerDive() * share.value, 100.0 * PerDive() * share.std};
    const bool grows = percent.value > 0.0;
    const std::string dofs = Dofs();
    const std::string where = dofs.empty() ? "" : " in " + dofs;
    if (!IsTrend()) {
      return what + " is " + WithDeviation(percent, " % " + (grows ? more : less)) + where;
    }
    return what + (grows ? " grows by " : " falls by ") + WithDeviation(percent, " % a dive") +
           where;
  }

  // Whether a number is a mass, or a moment of one.
  static bool HasMass(const DiveSeries& one) {
    return one.parameter == kInertia && !IsAngular(one.dof);
  }

  // What a pattern that moves the gain of one thruster alone says of it; nothing of any other.
  std::optional<Number> Gain() const {
    std::optional<Number> gain;
    for (std::size_t i = 0; i < event.series.size(); ++i) {
      const DiveSeries& one = series[event.series[i]];
      if (!IsTold(i)) continue;
      if (!one.entry || one.entry->kind != FreeEntry::Kind::kThrustGain || gain) return {};
      const double before = event.before(i);
      const Number difference = Difference(i);
      gain = {difference.value / (one.scale * before), difference.std / (one.scale * before)};
    }
    return gain;
  }

  std::string Payload() const {
    // The mass that the DOFs agree on.
    double weight = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < event.series.size(); ++i) {
      if (!IsTold(i) || !HasMass(series[event.series[i]])) continue;
      const Number number = Difference(i);
      weight += std::pow(number.std, -2);
      sum += number.value * std::pow(number.std, -2);
    }
    if (weight == 0.0) return Parameters();
    const Number mass{sum / weight, 1.0 / std::sqrt(weight)};
    const std::string how = mass.value > 0.0 ? "heavier" : "lighter";
    const std::string moments = Parameters(/*with_linear=*/false);
    const std::string rest =
        " in " + Dofs(/*with_angular=*/false) + (moments.empty() ? "" : ", and " + moments);
    if (IsTrend())
      return "the vehicle grows " + how + " by " + WithDeviation(mass, " kg a dive") + rest;
    return "the vehicle is " + WithDeviation(mass, " kg " + how) + rest;
  }

  // "the thrust of thruster port"
  std::string Thrust() const {
    if (named.cause.rfind("thruster(", 0) != 0) return "the thrust";
    return "the thrust of thruster " + named.cause.substr(9, named.cause.size() - 10);
  }

  std::string Sentence() const {
    if (named.cause == "payload") return Payload();
    const double f = named.fit.factor;
    if (named.cause == "fouling" || named.cause == "cleaning") {
      if (!named.pattern.HasFactor()) return Parameters();
      const double slope = std::pow(1.0 - f, -2);
      return Percent("damping", "larger", "smaller", {f / (1.0 - f), slope * named.fit.factor_std});
    }
    if (named.pattern.HasFactor()) {
      return Percent(Thrust(), "stronger", "weaker", {-f, named.fit.factor_std});
    }
    if (const auto gain = Gain(); gain && named.cause != "unnamed") {
      // Difference() of a trend is that of one dive already.
      return Percent(
          Thrust(), "stronger", "weaker", {gain->value / PerDive(), gain->std / PerDive()});
    }
    return Parameters();
  }
};

}  // namespace

std::string EventText(const NamedCause& named,
                      std::span<const std::string> alternatives,
                      const EventFit& event,
                      const Column& column,
                      std::span<const DiveSeries> series,
                      std::span<const char> told,
                      std::span<const std::string> dive_names) {
  const Teller teller{named, event, column, series, told, dive_names};
  std::string text = teller.Opening() + teller.Sentence();
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  text += named.cause == "unnamed" ? ": no known cause fits" : ": " + named.cause;
  if (!alternatives.empty()) {
    text += ", or as well " + Listed({alternatives.begin(), alternatives.end()});
  }
  return text + ".";
}

}  // namespace fathom
