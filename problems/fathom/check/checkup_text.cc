// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/checkup_text.h"

#include "fathom/base/files/json_text.h"
#include "fathom/base/interval95.h"
#include "fathom/findings/advice.h"
#include "fathom/findings/explain_first.h"
#include "fathom/findings/finding_json.h"
#include "fathom/planning/plan_hint.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

// "surge, sway and yaw"
std::string Listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  const std::vector<std::string> all_but_last(names.begin(), names.end() - 1);
  return fmt::format("{} and {}", fmt::join(all_but_last, ", "), names.back());
}

// "inertia passivity", or "-" where there is none.
std::string WordsOrDash(const std::set<std::string>& words) {
  return words.empty() ? "-" : fmt::format("{}", fmt::join(words, " "));
}

// How well the interval leaves a value known.
std::string_view HowWellKnown(double value, double std) {
  constexpr double kWell = 0.2, kRoughly = 1.0;
  const double share = kStdsOf95 * std / std::abs(value);
  if (share <= kWell) return "well";
  return share <= kRoughly ? "roughly" : "not";
}

double StdOf(const FittedModel& model, int index) {
  return std::sqrt(model.covariance(index, index));
}

// Whether something biases the model that no interval of it holds: what is red, or another axis.
bool IsBiased(const LogCheckup& checkup, const DofCheckup& dof) {
  return HasRed(checkup) || Has(dof.findings, "other_axes");
}

// Of a usable model. Where the data do not tell a delay of the command, with an unknown one.
std::string_view HowWellKnown(const LogCheckup& checkup, const DofCheckup& dof, int index) {
  const Identification& model = *dof.model;
  const double std = StdOf(model.fitted, index);
  const std::string_view known =
      HowWellKnown(ToVector(model.fitted.model)[index],
                   model.std_with_delay ? std::max(std, (*model.std_with_delay)[index]) : std);
  return known != "not" && IsBiased(checkup, dof) ? "in doubt" : known;
}

std::string FindingLines(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += fmt::format("{:<7} {:<17} {}\n",
                        finding.severity == Severity::kWarning ? "red" : "yellow",
                        finding.code,
                        finding.sentence);
    const Advice advice = AdviceOn(finding.code);
    if (advice.remedy.empty()) continue;
    text += fmt::format(
        "{:<25} To a model: {}\n{:<25} To do: {}\n", "", advice.effect, "", RemedyOf(finding));
  }
  return text;
}

std::string IntervalText(const TimeInterval& interval) {
  return fmt::format("{:.1f} to {:.1f} s", interval.from, interval.to);
}

Json JsonOf(const TimeInterval& interval) { return Json::array({interval.from, interval.to}); }

// The DOFs that a model comes of.
std::vector<std::string> UsableDofs(const LogCheckup& checkup) {
  std::vector<std::string> usable;
  for (const DofCheckup& dof : checkup.dofs) {
    if (dof.model && dof.model->is_usable) usable.emplace_back(Name(dof.dof));
  }
  return usable;
}

// Those that nothing drives, and whose damping a free decay tells.
std::vector<std::string> DecayingDofs(const LogCheckup& checkup) {
  std::vector<std::string> decaying;
  for (const DofCheckup& dof : checkup.dofs) {
    if (dof.decays) decaying.emplace_back(Name(dof.dof));
  }
  return decaying;
}

// Those with a finding of this code.
std::vector<std::string> DofsWith(const std::string& code, const LogCheckup& checkup) {
  std::vector<std::string> dofs;
  for (const DofCheckup& dof : checkup.dofs) {
    if (Has(dof.findings, code)) dofs.emplace_back(Name(dof.dof));
  }
  return dofs;
}

std::string HowToHoldOut(const Log& log, const TimeInterval& held_out) {
  if (IsSingleCsv(log)) {
    return fmt::format("add --held_out={:.1f}:{:.1f}", held_out.from, held_out.to);
  }
  return fmt::format(
      "add to {}: held_out: [{:.1f}, {:.1f}]", PlaceOfKeys(log), held_out.from, held_out.to);
}

// "quadratic_damping". But the buoyancy, of which a small value is known well enough.
std::vector<std::string> UnknownOf(const LogCheckup& checkup, const DofCheckup& dof) {
  std::vector<std::string> unknown;
  if (!dof.model || !dof.model->is_usable) return unknown;
  for (const int i : {kInertia, kQuadraticDamping, kLinearDamping}) {
    if (HowWellKnown(checkup, dof, i) != "not") continue;
    unknown.emplace_back(kParameterInfo[static_cast<std::size_t>(i)].name);
  }
  return unknown;
}

// The same of all DOFs; with the DOF where there are several.
std::vector<std::string> UnknownParameters(const LogCheckup& checkup, bool of_several_dofs) {
  std::vector<std::string> unknown;
  for (const DofCheckup& dof : checkup.dofs) {
    for (const std::string& name : UnknownOf(checkup, dof)) {
      unknown.push_back(of_several_dofs ? fmt::format("{} of {}", name, Name(dof.dof)) : name);
    }
  }
  return unknown;
}

bool HasSurfaces(const LogCheckup& checkup) { return checkup.log.fins || checkup.log.shafts; }

// Fins and shafts act in a model of several DOFs alone.
std::string CoupledStep(const LogCheckup& checkup) {
  std::vector<std::string_view> dofs;
  for (const DofCheckup& dof : checkup.dofs) dofs.push_back(Name(dof.dof));
  return fmt::format("fathom_identify --log={} --dofs={} --model=coupled.json",
                     checkup.log.path.string(),
                     fmt::join(dofs, ","));
}

}  // namespace

std::string Verdict(const LogCheckup& checkup) {
  if (std::string first = ExplainFirst(AllFindings(checkup)); !first.empty()) return first;
  const std::vector<std::string> usable = UsableDofs(checkup);
  if (const std::vector<std::string> decays = DecayingDofs(checkup);
      usable.empty() && !decays.empty()) {
    return fmt::format(
        "Nothing drives this log. Its free decay tells the damping of {} by the inertia.",
        Listed(decays));
  }
  if (usable.empty() && HasSurfaces(checkup)) {
    return "No model of one DOF comes of this log: its fins or shafts act in one of several.";
  }
  if (usable.empty()) return "Nothing in this log can be identified.";
  const std::vector<std::string> poor = DofsWith("poor_fit", checkup);
  const std::vector<std::string> driven = DofsWith("other_axes", checkup);
  std::vector<std::string> good;
  std::ranges::copy_if(usable, std::back_inserter(good), [&](const std::string& dof) {
    return std::ranges::count(poor, dof) + std::ranges::count(driven, dof) == 0;
  });
  const std::string of_driven =
      driven.empty() ? ""
                     : fmt::format(" Other axes act on {}: a model of one axis alone is biased.",
                                   Listed(driven));
  const std::vector<std::string> unknown = UnknownParameters(checkup, usable.size() > 1);
  if (good.empty() && poor.empty()) {
    return fmt::format(
        "{} can be identified from this log{}.{}",
        Listed(usable),
        unknown.empty() ? "" : fmt::format(", which leaves {} unknown", Listed(unknown)),
        of_driven);
  }
  if (good.empty()) {
    return fmt::format(
        "A model of {} from this log fits poorly{}.{}",
        Listed(poor),
        unknown.empty() ? "" : fmt::format(" and leaves {} unknown", Listed(unknown)),
        of_driven);
  }
  return fmt::format(
      "Nothing speaks against a model of {} from this log{}.{}{}",
      Listed(good),
      unknown.empty() ? "" : fmt::format(", but it leaves {} unknown", Listed(unknown)),
      poor.empty() ? "" : fmt::format(" One of {} fits poorly.", Listed(poor)),
      of_driven);
}

std::string NextStep(const LogCheckup& checkup) {
  const std::string log = checkup.log.path.string();
  if (HasRed(checkup)) return fmt::format("mend what is red, then fathom_check --log={}", log);
  if (Has(checkup.findings, "not_tracked")) return fmt::format("fathom_track --log={}", log);
  const std::vector<std::string> usable = UsableDofs(checkup);
  if (const std::vector<std::string> decays = DecayingDofs(checkup);
      usable.empty() && !decays.empty()) {
    return fmt::format("fathom_identify --log={} --dof={}", log, decays[0]);
  }
  if (usable.empty() && HasSurfaces(checkup)) return CoupledStep(checkup);
  if (usable.empty()) return "drive what this log lacks, or fit it together with other logs";
  const std::string step =
      fmt::format("fathom_identify --log={} --dof={} --model={}.json", log, usable[0], usable[0]);
  if (usable.size() == 1) return step;
  return fmt::format("{}; likewise {}", step, Listed({usable.begin() + 1, usable.end()}));
}

std::vector<std::string> PlanSteps(const LogCheckup& checkup) {
  std::vector<std::string> steps;
  if (HasRed(checkup) || Has(checkup.findings, "not_tracked")) return steps;
  for (const DofCheckup& dof : checkup.dofs) {
    if (UnknownOf(checkup, dof).empty()) continue;
    std::string step = PlanCommandOfModel(dof.model->fitted, fmt::format("{}.json", Name(dof.dof)));
    if (!step.empty()) steps.push_back(std::move(step));
  }
  return steps;
}

Table StreamTable(const LogCheckup& checkup) {
  Table table;
  table.columns = {{"file"},
                   {"rows", true},
                   {"first [s]", true},
                   {"last [s]", true},
                   {"rate [Hz]", true},
                   {"longest gap [s]", true}};
  for (const StreamSummary& stream : checkup.streams) {
    table.rows.push_back({{stream.file,
                           std::to_string(stream.rows),
                           fmt::format("{:.3f}", stream.first),
                           fmt::format("{:.3f}", stream.last),
                           fmt::format("{:.1f}", stream.rate),
                           fmt::format("{:.2f}", stream.longest_gap)}});
  }
  return table;
}

Table DeterminedTable(const LogCheckup& checkup, const DofCheckup& dof) {
  Table table;
  table.columns = {{"parameter"}, {"value", true}, {"known"}};
  if (!dof.model || !dof.model->is_usable) return table;
  const FittedModel& fitted = dof.model->fitted;
  const ParameterVector values = ToVector(fitted.model);
  for (int i = 0; i < kNumParameters; ++i) {
    const double std = StdOf(fitted, i);
    table.rows.push_back(
        {{fmt::format("{} [{}]",
                      kParameterInfo[static_cast<std::size_t>(i)].name,
                      ParameterUnit(i, fitted.dof, fitted.force_unit)),
          FormatInterval(values[i], std, kParameterInfo[static_cast<std::size_t>(i)].lower_bound),
          std::string(HowWellKnown(checkup, dof, i))}});
  }
  return table;
}

std::string WordsOnDoubt(const LogCheckup& checkup, const DofCheckup& dof) {
  if (!IsBiased(checkup, dof)) return "";
  return fmt::format("; in doubt: the interval leaves out the bias of {}",
                     HasRed(checkup) ? "what is red" : "other axes");
}

std::vector<std::string> CaveatsOn(const DofCheckup& dof) {
  if (!dof.model || !dof.model->is_usable) return {};
  return dof.model->fitted.caveats;
}

std::vector<std::string> ExcitationSentences(const LogCheckup& checkup, const DofCheckup& dof) {
  std::vector<std::string> sentences;
  if (!dof.signals) return sentences;
  const Excitation& excitation = dof.excitation;
  constexpr double kMostly = 0.8;
  constexpr std::size_t kMostListed = 6;
  if (excitation.excited < kMostly * excitation.duration && !excitation.stretches.empty()) {
    std::vector<std::string> stretches;
    const std::size_t num_listed = std::min(kMostListed, excitation.stretches.size());
    for (std::size_t i = 0; i < num_listed; ++i) {
      stretches.push_back(IntervalText(excitation.stretches[i]));
    }
    if (num_listed < excitation.stretches.size()) {
      stretches.push_back(fmt::format("and {} more", excitation.stretches.size() - num_listed));
    }
    sentences.push_back(fmt::format("Excited for {:.0f} of {:.0f} s: {}.",
                                    excitation.excited,
                                    excitation.duration,
                                    fmt::join(stretches, ", ")));
  }
  if (checkup.log.held_out.empty() && excitation.held_out) {
    const TimeInterval held_out = OutToTenths(*excitation.held_out);
    sentences.push_back(fmt::format("To judge the model on data that it has not seen, {}",
                                    HowToHoldOut(checkup.log, held_out)));
  }
  return sentences;
}

std::string FormatCheckup(const LogCheckup& checkup) {
  std::string text = fmt::format(
      "{}: {}\n\n{}", checkup.log.name, Verdict(checkup), FormatTable(StreamTable(checkup)));
  if (!checkup.findings.empty()) text += "\n" + FindingLines(checkup.findings);
  for (const DofCheckup& dof : checkup.dofs) {
    text += fmt::format("\n{}\n", Name(dof.dof));
    if (!dof.why_not.empty()) text += fmt::format("cannot be identified: {}\n", dof.why_not);
    text += FindingLines(dof.findings);
    if (dof.findings.empty() && dof.why_not.empty()) text += "green   nothing found\n";
    if (const Table table = DeterminedTable(checkup, dof); !table.rows.empty()) {
      text += "\n" + FormatTable(table) +
              fmt::format(
                  "known: {}the 95 % interval is within 20 % of the value (well), within "
                  "100 % (roughly) or wider (not){}\n",
                  dof.model->std_with_delay ? "with an unknown delay of the command, " : "",
                  WordsOnDoubt(checkup, dof));
    }
    for (const std::string& caveat : CaveatsOn(dof)) text += fmt::format("note: {}\n", caveat);
    for (const std::string& sentence : ExcitationSentences(checkup, dof)) text += sentence + "\n";
  }
  for (const Remark& remark : checkup.log.remarks) text += "note: " + remark.text + "\n";
  text += "next: " + NextStep(checkup) + "\n";
  for (const std::string& step : PlanSteps(checkup)) {
    text += fmt::format("then, to plan the run that tells most of the rest: {}\n", step);
  }
  return text;
}

std::string FormatCheckupJson(const LogCheckup& checkup) {
  Json streams = Json::array(), dofs = Json::array(), remarks = Json::array();
  for (const Remark& remark : checkup.log.remarks) remarks.push_back(remark.text);
  for (const StreamSummary& stream : checkup.streams) {
    streams.push_back({{"file", stream.file},
                       {"rows", stream.rows},
                       {"first", stream.first},
                       {"last", stream.last},
                       {"rate", stream.rate},
                       {"longest_gap", stream.longest_gap}});
  }
  for (const DofCheckup& dof : checkup.dofs) {
    Json parameters = Json::array(), stretches = Json::array();
    if (dof.model && dof.model->is_usable) {
      const FittedModel& fitted = dof.model->fitted;
      const ParameterVector values = ToVector(fitted.model);
      for (int i = 0; i < kNumParameters; ++i) {
        parameters.push_back({{"name", kParameterInfo[static_cast<std::size_t>(i)].name},
                              {"unit", ParameterUnit(i, fitted.dof, fitted.force_unit)},
                              {"value", values[i]},
                              {"std", StdOf(fitted, i)},
                              {"known", HowWellKnown(checkup, dof, i)}});
      }
    }
    for (const TimeInterval& stretch : dof.excitation.stretches) {
      stretches.push_back(JsonOf(stretch));
    }
    dofs.push_back(
        {{"dof", Name(dof.dof)},
         {"why_not", dof.why_not},
         {"findings", JsonOf<Json>(dof.findings)},
         {"parameters", std::move(parameters)},
         {"caveats", CaveatsOn(dof)},
         {"excited", std::move(stretches)},
         {"held_out", dof.excitation.held_out ? JsonOf(*dof.excitation.held_out) : Json(nullptr)}});
  }
  const Json json = {{"schema", "fathom-check-1"},
                     {"log", checkup.log.name},
                     {"verdict", Verdict(checkup)},
                     {"streams", std::move(streams)},
                     {"findings", JsonOf<Json>(checkup.findings)},
                     {"dofs", std::move(dofs)},
                     {"remarks", std::move(remarks)}};
  return JsonText(json);
}

Table CheckedLogsTable(const std::vector<CheckedLog>& logs) {
  Table table;
  table.columns = {{"log"}, {"DOFs"}, {"red"}, {"yellow", false, 1}};
  for (const CheckedLog& log : logs) {
    if (!log.message.empty()) {
      table.rows.push_back({{log.path, "-", "not readable", "-"}});
      continue;
    }
    const std::vector<std::string> usable = UsableDofs(log.checkup);
    std::set<std::string> red, yellow;
    for (const Finding& finding : AllFindings(log.checkup)) {
      (finding.severity == Severity::kWarning ? red : yellow).insert(finding.code);
    }
    table.rows.push_back({{log.path,
                           usable.empty() ? "-" : fmt::format("{}", fmt::join(usable, " ")),
                           WordsOrDash(red),
                           WordsOrDash(yellow)}});
  }
  return table;
}

std::string FormatCheckedLogs(const std::vector<CheckedLog>& logs, TableFormat format) {
  std::string text = format(CheckedLogsTable(logs));
  for (const CheckedLog& log : logs) {
    if (!log.message.empty())
      text += fmt::format("{} is not readable: {}\n", log.path, log.message);
  }
  return text;
}

}  // namespace fathom
