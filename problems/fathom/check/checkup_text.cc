// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/checkup_text.h"

#include "fathom/check/checkup_verdict.h"
#include "fathom/check/known_parameters.h"
#include "fathom/findings/advice.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

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

std::string HowToHoldOut(const Log& log, const TimeInterval& held_out) {
  if (IsSingleCsv(log)) {
    return fmt::format("add --held_out={:.1f}:{:.1f}", held_out.from, held_out.to);
  }
  return fmt::format(
      "add to {}: held_out: [{:.1f}, {:.1f}]", PlaceOfKeys(log), held_out.from, held_out.to);
}

}  // namespace

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
                  "100 % (roughly) or wider (not); the buoyancy goes by the greatest force{}\n",
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

}  // namespace fathom
