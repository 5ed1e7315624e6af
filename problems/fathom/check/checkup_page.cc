// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/checkup_page.h"

#include "fathom/check/checkup_text.h"
#include "fathom/check/checkup_verdict.h"
#include "fathom/check/finding_picture.h"
#include "fathom/findings/advice.h"
#include "fathom/report/held_curve.h"
#include "fathom/report/page.h"
#include "fathom/vehicle/effects/in_words.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

std::string FindingText(const Finding& finding) {
  const Advice advice = AdviceOn(finding.code);
  const char* const colour = finding.severity == Severity::kWarning ? "Red" : "Yellow";
  std::string text = fmt::format("{}: {}", colour, finding.sentence);
  if (!advice.effect.empty()) text += fmt::format(" To a model: {}", advice.effect);
  if (!advice.remedy.empty()) text += fmt::format(" To do: {}", RemedyOf(finding));
  return fmt::format("{} ({})", text, finding.code);
}

void AddFinding(const Finding& finding,
                std::vector<std::string>* warnings,
                std::vector<std::string>* text) {
  // Warnings stand out, notes are paragraphs.
  (finding.severity == Severity::kWarning ? warnings : text)->push_back(FindingText(finding));
}

// Those with a picture become sections of their own, which are given back.
std::vector<PageSection> AddFindings(const std::vector<Finding>& findings,
                                     const Log& log,
                                     const DofCheckup* dof,
                                     std::vector<std::string>* warnings,
                                     std::vector<std::string>* text) {
  std::vector<PageSection> pictures;
  for (const Finding& finding : findings) {
    if (auto picture = PictureOf(finding, log, dof)) {
      AddFinding(finding, &picture->warnings, &picture->text);
      pictures.push_back(*std::move(picture));
    } else {
      AddFinding(finding, warnings, text);
    }
  }
  return pictures;
}

// Motion and command, with a gap between two segments.
void AddCharts(const DofCheckup& dof, PageSection* section) {
  std::vector<const Segment*> segments;
  for (const Segment& segment : dof.signals->train) segments.push_back(&segment);
  for (const Segment& segment : dof.signals->held_out) segments.push_back(&segment);
  std::ranges::sort(segments, {}, [](const Segment* segment) { return segment->time.front(); });
  TimePanel motion;
  motion.quantity = fmt::format("{} velocity", Name(dof.dof));
  motion.unit = VelocityUnit(dof.dof);
  motion.has_residuals = false;
  for (const Segment& segment : dof.signals->held_out) {
    motion.held_out.push_back({segment.time.front(), segment.time.back()});
  }
  Series measured = {"measured", {}};
  TimePanel command =
      HeldCurvePanel(fmt::format("{} command", Name(dof.dof)), dof.signals->force_unit);
  for (const Segment* const segment : segments) {
    motion.time.insert(motion.time.end(), segment->time.begin(), segment->time.end());
    measured.values.insert(
        measured.values.end(), segment->velocity.begin(), segment->velocity.end());
    motion.time.push_back(segment->time.back());
    measured.values.push_back(std::numeric_limits<double>::quiet_NaN());
    AppendHeldCurve(dof.command.time,
                    dof.command.value,
                    {segment->time.front(), segment->time.back()},
                    0.0,
                    &command);
  }
  command.held_out = motion.held_out;
  motion.measured = std::move(measured);
  section->time_panels = {std::move(motion), std::move(command)};
}

}  // namespace

std::string RenderCheckupPage(const LogCheckup& checkup, const PageOrigin& origin) {
  Page page;
  page.title = fmt::format("Check of {}", checkup.log.name);
  page.lead = {InWords(Verdict(checkup))};
  const auto tell = [&](const std::vector<Finding>& findings) {
    for (const Finding& finding : findings) {
      if (finding.severity == Severity::kWarning) page.lead.push_back(InWords(finding.sentence));
    }
  };
  tell(checkup.findings);
  for (const DofCheckup& dof : checkup.dofs) tell(dof.findings);
  page.lead.push_back("Next: " + NextStep(checkup));
  for (const std::string& step : PlanSteps(checkup)) {
    page.lead.push_back("Then, to plan the run that tells most of the rest: " + step);
  }
  page.footer = kColourKey;
  page.origin = origin;
  PageSection streams;
  streams.heading = "Files";
  streams.tables = {StreamTable(checkup)};
  for (const Remark& remark : checkup.log.remarks) streams.text.push_back(remark.text);
  page.sections =
      AddFindings(checkup.findings, checkup.log, nullptr, &page.warnings, &streams.text);
  for (const DofCheckup& dof : checkup.dofs) {
    PageSection section;
    section.heading = std::string(Name(dof.dof));
    if (!dof.why_not.empty()) {
      section.text.push_back(fmt::format("It cannot be identified: {}", dof.why_not));
    }
    std::vector<PageSection> pictures =
        AddFindings(dof.findings, checkup.log, &dof, &section.warnings, &section.text);
    if (dof.findings.empty() && dof.why_not.empty()) {
      section.text.emplace_back("Green: nothing found.");
    }
    for (std::string& caveat : CaveatsOn(dof)) section.text.push_back(std::move(caveat));
    for (std::string& sentence : ExcitationSentences(checkup, dof)) {
      section.text.push_back(std::move(sentence));
    }
    if (dof.signals && !dof.signals->train.empty()) AddCharts(dof, &section);
    if (Table table = DeterminedTable(checkup, dof); !table.rows.empty()) {
      table.caption = fmt::format(
          "How well this log knows the parameters (95 %{}): well within 20 %, roughly within "
          "100 %; the buoyancy by the greatest force{}.",
          dof.model->std_with_delay ? ", with an unknown delay of the command" : "",
          WordsOnDoubt(checkup, dof));
      section.tables = {std::move(table)};
    }
    page.sections.push_back(std::move(section));
    std::ranges::move(pictures, std::back_inserter(page.sections));
  }
  page.sections.push_back(std::move(streams));
  std::ranges::stable_partition(
      page.sections, [](const PageSection& section) { return !section.warnings.empty(); });
  return RenderPage(page);
}

}  // namespace fathom
