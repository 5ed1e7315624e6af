// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/identification_text.h"

#include "fathom/base/not_known.h"
#include "fathom/report/format_value.h"
#include "fathom/report/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

std::string FiguresText(const char* where, const FitFigures& figures, std::string_view unit) {
  if (!std::isfinite(figures.nmae)) return "";
  return fmt::format(
      "{:<9} velocity MAE {:.5f} {}, velocity NMAE {:.4f}   ({} samples, {:.0f} s)\n",
      where,
      figures.mae,
      unit,
      figures.nmae,
      figures.num_samples,
      figures.duration);
}

// A row of the table: a number with its interval, which does not reach below `lower_bound`.
TableRow RowOf(const std::string& name,
               const Ratio& number,
               const std::string& unit,
               double lower_bound,
               double share) {
  return {{name,
           FormatValue(number.value, number.std),
           unit,
           FormatInterval(number.value, number.std, lower_bound),
           std::isfinite(share) ? fmt::format("{:.0f} %", 100.0 * share) : "-"}};
}

std::string WithSpaces(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

bool HasSiForce(const FittedModel& fitted) { return fitted.force_unit == ForceUnit(fitted.dof); }

// The condition number is of columns of length 1: Belsley, Kuh and Welsch call 30 and more harmful
// (docs/signal.md).
std::string WhatTheColumnsSay(const Identification& identification) {
  std::string text = "±: one standard deviation";
  if (!std::isfinite(identification.condition_number)) return text + "\n";
  text += "; unique effect: the part that no other parameter can imitate\n";
  return text + fmt::format(
                    "condition number {:.1f} (1: the parameters act unlike each other; above 30: "
                    "some act almost alike)\n",
                    identification.condition_number);
}

}  // namespace

Table IdentificationTable(const Identification& identification) {
  const FittedModel& fitted = identification.fitted;
  const ParameterVector values = ToVector(fitted.model);
  Table table;
  table.columns = {
      {"parameter"}, {"value", true}, {"unit"}, {"95 % interval", true}, {"unique effect", true}};
  for (int i = 0; i < kNumParameters; ++i) {
    table.rows.push_back(RowOf(kParameterInfo[i].name,
                               {values[i], std::sqrt(fitted.covariance(i, i))},
                               UnitText(ParameterUnit(i, fitted.dof, fitted.force_unit)),
                               kParameterInfo[i].lower_bound,
                               identification.share[i]));
  }
  if (HasSiForce(fitted)) return table;
  const char* const per_length = IsAngular(fitted.dof) ? "1/rad" : "1/m";
  table.rows.push_back(RowOf("linear_damping / inertia",
                             RatioOf(fitted, kLinearDamping, kInertia),
                             "1/s",
                             0.0,
                             kNotKnown));
  table.rows.push_back(RowOf("quadratic_damping / inertia",
                             RatioOf(fitted, kQuadraticDamping, kInertia),
                             per_length,
                             0.0,
                             kNotKnown));
  return table;
}

std::string ModelName(const Identification& identification) {
  constexpr std::array<const char*, 4> kFamilies = {
      "Least squares", "Adaptive", "Output error", "Joint"};
  return fmt::format("{}, {}",
                     kFamilies[static_cast<size_t>(identification.family)],
                     NameInText(identification.source));
}

Ratio RatioOf(const FittedModel& fitted, int numerator, int denominator) {
  const ParameterVector p = ToVector(fitted.model);
  const double ratio = p[numerator] / p[denominator];
  ParameterVector gradient = ParameterVector::Zero();
  gradient[numerator] = 1.0 / p[denominator];
  gradient[denominator] = -ratio / p[denominator];
  // Where the two always move together the variance is zero but for rounding; NaN stays NaN.
  const double variance = gradient.dot(fitted.covariance * gradient);
  return {ratio, std::sqrt(variance < 0.0 ? 0.0 : variance)};
}

std::string FormatIdentification(const Identification& identification,
                                 const std::string& velocity_file) {
  const FittedModel& fitted = identification.fitted;
  std::string text = fmt::format("{} by {} from {}: {}\n",
                                 Name(fitted.dof),
                                 WithSpaces(Name(identification.family)),
                                 identification.source == Source::kPoseEstimator
                                     ? std::string_view(velocity_file)
                                     : NameInText(identification.source),
                                 identification.message);
  if (!identification.is_usable) return text;

  text += FormatTable(IdentificationTable(identification));
  if (!HasSiForce(fitted)) {
    text += fmt::format(
        "The command is in {}, not in {}. Only the ratios are properties of the vehicle; the "
        "other values contain the unknown thrust per {}.\n",
        fitted.force_unit,
        ForceUnit(fitted.dof),
        fitted.force_unit);
  }
  text += WhatTheColumnsSay(identification);
  if (identification.weighting == "learned") {
    text += "weighting: learned (by the noise in the residual).\n";
  } else if (!identification.weighting_reason.empty()) {
    text +=
        fmt::format("weighting: plain (all samples alike). {}\n", identification.weighting_reason);
  }
  text += FiguresText("training", fitted.train, VelocityUnit(fitted.dof));
  text += FiguresText("held out", fitted.held_out, VelocityUnit(fitted.dof));
  for (const std::string& caveat : fitted.caveats) text += fmt::format("note: {}\n", caveat);
  return text;
}

}  // namespace fathom
