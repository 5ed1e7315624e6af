// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/diagnosis_tables.h"

#include "fathom/base/not_known.h"
#include "fathom/diagnosis/report/candidate_text.h"
#include "fathom/diagnosis/report/cause_text.h"
#include "fathom/diagnosis/report/verdict_sentence.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::string Figure(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

// "0.032", "1e-12", "< 1e-15".
std::string Probability(double p) {
  if (!std::isfinite(p)) return "-";
  if (p < 1e-15) return "< 1e-15";
  return p < 1e-3 ? fmt::format("{:.0e}", p) : fmt::format("{:.2g}", p);
}

std::string InBrackets(const std::string& unit) {
  return unit == "-" ? "" : fmt::format(" [{}]", UnitText(unit));
}

double StdOf(const DiagnosedModel& model, int i) {
  return i < model.covariance.rows() ? std::sqrt(model.covariance(i, i)) : kNotKnown;
}

}  // namespace

Table CauseTable(const Diagnosis& diagnosis) {
  Table table;
  table.columns = {{"cause"},
                   {"parameter"},
                   {"value"},
                   {"p-value", true, 2},
                   {"evidence (BIC)", true, 1},
                   {"held-out gain", true},
                   {"looks like"}};
  for (const Cause& cause : diagnosis.causes) {
    const ActiveEffect& active = EffectOfCause(diagnosis, cause);
    const std::vector<double> stds = EffectStds(diagnosis.extended, cause.effect_index);
    const std::vector<std::string> alternatives = LabelsOf(cause.alternatives);
    for (std::size_t k = 0; k < active.values.size(); ++k) {
      const EffectParameter& parameter = active.effect->info().parameters[k];
      const std::string unit = UnitOf(parameter.quantity, diagnosis.dof, diagnosis.force_unit);
      const std::string value = WithInterval(
          active.values[k], stds[k], unit == "-" ? "" : unit, parameter.lower, parameter.upper);
      if (k > 0) {  // of the same cause
        table.rows.push_back({{"", std::string(parameter.name), value, "", "", "", ""}});
        continue;
      }
      table.rows.push_back(
          {{LabelOf(active.effect->info(), active.setting),
            std::string(parameter.name),
            value,
            Probability(cause.p_value),
            Figure(cause.delta_bic, "{:.0f}"),
            Figure(std::round(100.0 * cause.held_out_gain) + 0.0, "{:.0f} %"),  // no -0
            alternatives.empty() ? "-" : fmt::format("{}", fmt::join(alternatives, ", "))}});
    }
  }
  return table;
}

Table BeforeAndAfterTable(const Diagnosis& diagnosis) {
  Table table;
  table.columns = {{"parameter"}};
  if (diagnosis.ComparesTwoModels()) {
    table.columns.insert(table.columns.end(),
                         {{"before", true}, {"after", true}, {"change", true}});
  } else {
    table.columns.push_back({"value", true});
  }
  const auto add = [&](const std::string& name,
                       const std::string& was,
                       const std::string& is,
                       const std::string& change) {
    table.rows.push_back({diagnosis.ComparesTwoModels()
                              ? std::vector<std::string>{name, was, is, change}
                              : std::vector<std::string>{name, is}});
  };
  const auto moves_by = [](double was, double is) {
    return Figure(100.0 * (is - was) / std::abs(was), "{:+.1f} %");
  };
  const ParameterVector before = ToVector(diagnosis.baseline.model.baseline);
  const ParameterVector after = ToVector(diagnosis.extended.model.baseline);
  for (int i = 0; i < kNumParameters; ++i) {
    add(kParameterInfo[i].name + InBrackets(ParameterUnit(i, diagnosis.dof, diagnosis.force_unit)),
        FormatValue(before[i], StdOf(diagnosis.baseline, i)),
        FormatValue(after[i], StdOf(diagnosis.extended, i)),
        i == kBuoyancy ? "-" : moves_by(before[i], after[i]));
  }
  int index = kNumParameters;
  for (const ActiveEffect& active : diagnosis.extended.model.effects) {
    for (std::size_t k = 0; k < active.values.size(); ++k) {
      const EffectParameter& parameter = active.effect->info().parameters[k];
      add(KeyOf(active, parameter) +
              InBrackets(UnitOf(parameter.quantity, diagnosis.dof, diagnosis.force_unit)),
          "-",
          FormatValue(active.values[k], StdOf(diagnosis.extended, index++)),
          "-");
    }
  }
  const auto add_figure = [&](const std::string& name, double was, double is) {
    add(name, ShareText(was, 4), ShareText(is, 4), moves_by(was, is));
  };
  const std::string nmae = fmt::format("{} NMAE", FittedQuantity(diagnosis));
  add_figure(
      nmae + ", training data", diagnosis.baseline.train.nmae, diagnosis.extended.train.nmae);
  add_figure(fmt::format("{}, {}", nmae, WhereUnseen(diagnosis)),
             diagnosis.baseline.held_out.nmae,
             diagnosis.extended.held_out.nmae);
  return table;
}

Table CandidateTable(const Diagnosis& diagnosis, std::size_t most) {
  Table table;
  table.columns = {{"candidate"},
                   {"score", true},
                   {"p-value", true, 1},
                   {"gain, refitted", true, 2},
                   {"evidence (BIC)", true},
                   {"result"}};
  for (const Candidate& candidate : diagnosis.candidates) {
    if (table.rows.size() == most) break;
    const bool is_refitted = std::isfinite(candidate.gain) && !candidate.values.empty();
    table.rows.push_back({{candidate.label,
                           Figure(candidate.score, "{:.1f}"),
                           Probability(candidate.p_value),
                           is_refitted ? Figure(candidate.gain, "{:.1f}") : "-",
                           is_refitted ? Figure(candidate.delta_bic, "{:.1f}") : "-",
                           WhyText(candidate)},
                          candidate.IsKept() ? RowFlag::kKept : RowFlag::kNone});
  }
  return table;
}

Table LimitTable(const Diagnosis& diagnosis) {
  Table table;
  table.columns = {{"effect not named"}, {"parameter"}, {"95 % excluded"}};
  for (const ExclusionLimit& limit : diagnosis.limits) {
    const EffectParameter& parameter = limit.effect->info().parameters.front();
    const std::string unit = UnitOf(parameter.quantity, diagnosis.dof, diagnosis.force_unit);
    // As many digits as tell both ends apart.
    const bool is_narrow = fmt::format("{:.3g}", limit.low) == fmt::format("{:.3g}", limit.high);
    const auto text = [&](double value) {
      const std::string number = fmt::format("{:.{}g}", value, is_narrow ? 6 : 3);
      return fmt::format("{}{}", number, unit == "-" ? "" : " " + UnitText(unit));
    };
    const std::string excluded =
        !limit.is_told           ? "nothing: these logs cannot show it"
        : std::isinf(limit.high) ? "below " + text(limit.low)
        : limit.low <= parameter.lower
            ? "above " + text(limit.high)
            : fmt::format("below {}, above {}", text(limit.low), text(limit.high));
    table.rows.push_back({{limit.label, std::string(parameter.name), excluded}});
  }
  return table;
}

}  // namespace fathom
