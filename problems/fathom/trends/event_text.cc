// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/event_text.h"

#include "fathom/report/format_value.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace fathom {
namespace {

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

std::string Listed(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += i + 1 == items.size() ? " and " : ", ";
    text += items[i];
  }
  return text;
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

  // "the buoyancy in heave is 5.0 N larger (± 0.4)", "... grows by 5.0 N a dive (± 0.4)".
  std::string Parameters(bool with_linear = true) const {
    std::vector<std::string> items;
    for (std::size_t i = 0; i < event.series.size(); ++i) {
      if (!IsTold(i) || (!with_linear && !IsAngular(series[event.series[i]].dof))) continue;
      const DiveSeries& one = series[event.series[i]];
      const Number number = Difference(i);
      std::string name = kParameterInfo[one.parameter].name;
      std::replace(name.begin(), name.end(), '_', ' ');
      const std::string unit =
          UnitText(ParameterUnit(one.parameter, one.dof, std::string(ForceUnit(one.dof))));
      const bool grows = number.value > 0.0;
      std::string item = "the " + name + " in " + std::string(Name(one.dof));
      if (IsTrend()) {
        item +=
            (grows ? " grows by " : " falls by ") + WithDeviation(number, " " + unit + " a dive");
      } else {
        item += " is " + WithDeviation(number, " " + unit + (grows ? " larger" : " smaller"));
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
    if (!IsTrend()) {
      return what + " is " + WithDeviation(percent, " % " + (grows ? more : less)) + " in " +
             Dofs();
    }
    return what + (grows ? " grows by " : " falls by ") + WithDeviation(percent, " % a dive") +
           " in " + Dofs();
  }

  std::string Payload() const {
    // The mass that the DOFs agree on.
    double weight = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < event.series.size(); ++i) {
      if (!IsTold(i) || IsAngular(series[event.series[i]].dof)) continue;
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

  std::string Sentence() const {
    if (named.cause == "payload") return Payload();
    const double f = named.fit.factor;
    if (named.cause == "fouling" || named.cause == "cleaning") {
      if (!named.pattern.HasFactor()) return Parameters();
      const double slope = std::pow(1.0 - f, -2);
      return Percent("damping", "larger", "smaller", {f / (1.0 - f), slope * named.fit.factor_std});
    }
    if (named.pattern.HasFactor()) {
      std::string what = "the thrust";
      if (named.cause.rfind("thruster(", 0) == 0) {
        what += " of thruster " + named.cause.substr(9, named.cause.size() - 10);
      }
      return Percent(what, "stronger", "weaker", {-f, named.fit.factor_std});
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
