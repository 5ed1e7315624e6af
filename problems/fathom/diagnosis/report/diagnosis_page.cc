// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/diagnosis_page.h"

#include "fathom/diagnosis/report/candidate_text.h"
#include "fathom/diagnosis/report/cause_text.h"
#include "fathom/diagnosis/report/diagnosis_panels.h"
#include "fathom/diagnosis/report/diagnosis_tables.h"
#include "fathom/diagnosis/report/limit_text.h"
#include "fathom/diagnosis/report/next_steps.h"
#include "fathom/diagnosis/report/verdict_sentence.h"
#include "fathom/findings/explain_first.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/effects/in_words.h"
#include "fathom/vehicle/files/model_file.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

PageSection NextStepsSection(const Diagnosis& diagnosis, const std::string& plan_command) {
  PageSection section;
  section.heading = "What to do next";
  section.text = NextSteps(diagnosis);
  if (!plan_command.empty()) {
    section.text.push_back("To plan the run that decides: " + plan_command);
  }
  if (!diagnosis.causes.empty()) section.tables.push_back(CauseTable(diagnosis));
  return section;
}

// A section for each panel, which is a log's, with the command below it.
void AddSections(std::vector<TimePanel> panels,
                 std::vector<TimePanel> commands,
                 const std::string& heading,
                 const std::vector<std::string>& text,
                 bool are_several,
                 Page* page) {
  for (std::size_t i = 0; i < panels.size(); ++i) {
    TimePanel& panel = panels[i];
    PageSection section;
    section.heading = are_several ? heading + ": " + panel.title : heading;
    section.text = text;
    panel.title.clear();
    panel.is_low = page->sections.empty();  // the first screen holds more than that
    section.time_panels = {std::move(panel)};
    if (!commands[i].time.empty()) section.time_panels.push_back(std::move(commands[i]));
    page->sections.push_back(std::move(section));
  }
}

void AddFreeRuns(const Diagnosis& diagnosis, Page* page) {
  AddSections(FreeRunPanels(diagnosis),
              CommandPanels(diagnosis, diagnosis.traces),
              diagnosis.ComparesTwoModels() ? "Before and after" : "The model and the measurement",
              {},
              diagnosis.logs.size() > 1,
              page);
}

void AddPoses(const Diagnosis& diagnosis, Page* page) {
  AddSections(
      PosePanels(diagnosis),
      CommandPanels(diagnosis, diagnosis.pose_traces),
      diagnosis.ComparesTwoModels() ? "The poses before and after" : "The model and the poses",
      {"Every 10 s the modelled displacement is reset to the measured straight line, "
       "because the drift of a simulation from the command alone would soon hide the "
       "errors of the poses."},
      diagnosis.logs.size() > 1,
      page);
}

// What was measured against both models, where the causes show first.
void AddBeforeAndAfter(const Diagnosis& diagnosis, Page* page) {
  if (diagnosis.gain_is_in_poses) AddPoses(diagnosis, page);
  AddFreeRuns(diagnosis, page);
  if (!diagnosis.gain_is_in_poses) AddPoses(diagnosis, page);
}

PageSection MissingForceSection(const Diagnosis& diagnosis) {
  PageSection section;
  section.heading = IsAngular(diagnosis.dof) ? "The missing moment" : "The missing force";
  section.text = {
      std::string("This is the force that would have to be added to the command for the model ") +
      (diagnosis.has_baseline ? "without causes " : "") +
      "to follow the measurement. It is estimated as a random force that decays within seconds "
      "(an Ornstein-Uhlenbeck process), smoothed over the log. The band is two standard "
      "deviations. " +
      std::string(!diagnosis.ComparesTwoModels()
                      ? "If it follows one of the signals below, look there for the cause."
                      : "The force that the causes explain should lie inside the band. The "
                        "points show both forces over each signal.") +
      " The percentage is the share of its variance that the mean over the signal explains. Up "
      "to some 20 % can be chance, because the force is smooth."};
  section.time_panels = MissingForcePanels(diagnosis);
  section.scatter_panels = SuspectPanels(diagnosis);
  return section;
}

PageSection ParameterSection(const Diagnosis& diagnosis) {
  PageSection section;
  section.heading =
      diagnosis.ComparesTwoModels() ? "The parameters before and after" : "The parameters";
  section.parameter_panels = ParameterPanels(diagnosis);
  section.tables.push_back(BeforeAndAfterTable(diagnosis));
  return section;
}

PageSection CandidateSection(const Diagnosis& diagnosis) {
  PageSection section;
  section.heading = "All candidates";
  section.text = {
      "The score is twice the log-likelihood that an effect gains over the model without causes, "
      "by a linear screen. The candidates that matter were refitted. The p-value is the "
      "probability of such a gain among all candidates if nothing is missing: the refitted gain, "
      "or the score where there is none."};
  if (std::string text = NonePassesText(diagnosis); !text.empty()) {
    section.text.insert(section.text.begin(), std::move(text));
  }
  section.tables.push_back(CandidateTable(diagnosis));
  return section;
}

PageSection LimitSection(const Diagnosis& diagnosis) {
  PageSection section;
  section.heading = "What these logs rule out";
  section.text = {HowToReadLimits(diagnosis)};
  section.tables.push_back(LimitTable(diagnosis));
  return section;
}

// "sensor_lag or thruster_lag": a cause and what it may be instead.
std::string LabelsOf(const Diagnosis& diagnosis, const Cause& cause) {
  const ActiveEffect& active = EffectOfCause(diagnosis, cause);
  const std::string label = LabelOf(active.effect->info(), active.setting);
  const std::vector<std::string> alternatives = LabelsOf(AlternativesOf(cause));
  if (alternatives.empty()) return label;
  if (alternatives.size() > 2) {
    return fmt::format("{}, or another effect {}", label, PlacesText(diagnosis, cause));
  }
  return fmt::format("{} or {}", label, fmt::join(alternatives, " or "));
}

std::vector<Fact> FactsOf(const Diagnosis& diagnosis) {
  std::vector<Fact> facts = {{"verdict", std::string(Name(diagnosis.verdict))}};
  std::vector<std::string> names;
  for (const Cause& cause : diagnosis.causes) names.push_back(LabelsOf(diagnosis, cause));
  if (!names.empty()) {
    facts.push_back({std::string(names.size() == 1 ? "cause" : "causes") +
                         (AreUnconfirmed(diagnosis) ? ", not confirmed" : ""),
                     InWords(fmt::format("{}", fmt::join(names, "; ")))});
  }
  if (std::isfinite(diagnosis.explained_share)) {
    facts.push_back({"squared error beyond scatter, explained",
                     fmt::format("{:.0f} %", 100.0 * diagnosis.explained_share)});
  }
  if (diagnosis.gain_is_in_poses) {
    const double gain = diagnosis.held_out_gain;
    facts.push_back(
        {"error on held-out poses",
         fmt::format("{:.0f} % {}", 100.0 * std::abs(gain), gain < 0.0 ? "more" : "less")});
  }
  const double before = diagnosis.baseline.held_out.nmae, after = diagnosis.extended.held_out.nmae;
  if (std::isfinite(after)) {
    facts.push_back({NameOfNmae(diagnosis),
                     diagnosis.ComparesTwoModels()
                         ? fmt::format("{} → {}", ShareText(before, 3), ShareText(after, 3))
                         : ShareText(after, 3)});
    if (std::isfinite(diagnosis.noise_nmae)) {
      facts.push_back({"noise alone gives", fmt::format("about {:.2g}", diagnosis.noise_nmae)});
    }
  }
  return facts;
}

std::string TitleOf(const Diagnosis& diagnosis) {
  return fmt::format(
      "{}: diagnosis of the {} model", fmt::join(diagnosis.logs, ", "), Name(diagnosis.dof));
}

std::vector<std::string> WarningsOf(const Diagnosis& diagnosis) {
  std::vector<std::string> warnings;
  for (const Finding& finding : diagnosis.findings) {
    if (finding.severity == Severity::kWarning) warnings.push_back(finding.sentence);
  }
  return warnings;
}

// What is red comes before what the diagnosis says.
std::vector<std::string> LeadOf(const Diagnosis& diagnosis) {
  std::vector<std::string> lead = VerdictParagraphs(diagnosis);
  if (std::string first = ExplainFirst(diagnosis.findings); !first.empty()) {
    lead.insert(lead.begin(), std::move(first));
  }
  for (std::string& paragraph : lead) paragraph = InWords(paragraph);
  return lead;
}

}  // namespace

Page NoDiagnosisPage(const Diagnosis& diagnosis, const std::string& why) {
  Page page;
  page.title = TitleOf(diagnosis);
  page.lead = {InWords(fmt::format("There is no diagnosis: {}", why))};
  page.warnings = WarningsOf(diagnosis);
  PageSection notes;
  notes.heading = "Remarks";
  notes.text = diagnosis.remarks;
  if (!notes.text.empty()) page.sections.push_back(std::move(notes));
  return page;
}

Page DiagnosisPage(const Diagnosis& diagnosis, const std::string& plan_command) {
  Page page;
  page.title = TitleOf(diagnosis);
  page.lead = LeadOf(diagnosis);
  page.warnings = WarningsOf(diagnosis);
  page.facts = FactsOf(diagnosis);
  AddBeforeAndAfter(diagnosis, &page);
  page.sections.push_back(NextStepsSection(diagnosis, plan_command));
  if (!diagnosis.missing_force.time.empty()) {
    page.sections.push_back(MissingForceSection(diagnosis));
  }
  page.sections.push_back(ParameterSection(diagnosis));
  if (!diagnosis.candidates.empty()) page.sections.push_back(CandidateSection(diagnosis));
  if (!diagnosis.limits.empty()) page.sections.push_back(LimitSection(diagnosis));
  if (!diagnosis.remarks.empty()) {
    PageSection notes;
    notes.heading = "Remarks";
    notes.text = diagnosis.remarks;
    page.sections.push_back(std::move(notes));
  }
  page.footer =
      "Shares are of the squared error when simulating from the command alone, and so is NMAE "
      "(docs/models.md). Intervals are 95 %; ± is one standard deviation. docs/diagnosis.md says "
      "how causes are found and how certain they are.";
  return page;
}

}  // namespace fathom
