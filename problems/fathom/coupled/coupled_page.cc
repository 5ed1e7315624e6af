// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_page.h"

#include "fathom/base/names_of_dofs.h"
#include "fathom/coupled/cause_words.h"
#include "fathom/coupled/coupled_text.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

Series AlongDof(const char* name,
                const CoupledPrediction& prediction,
                std::size_t log,
                std::size_t segment,
                Dof dof) {
  Series series;
  series.name = name;
  for (const Vector6& velocity : prediction.velocity[log][segment]) {
    series.values.push_back(velocity[Index(dof)]);
  }
  return series;
}

// One stretch of a log: what was measured, and free runs of both models.
TimePanel PanelOf(const CoupledIdentification& identified,
                  std::size_t log,
                  std::size_t segment,
                  Dof dof) {
  const CoupledData& data = identified.data[log];
  const CoupledSegment& stretch = data.segments[segment];
  TimePanel panel;
  panel.title = identified.data.size() > 1 ? fmt::format("{}, {}", Name(dof), data.log)
                                           : std::string(Name(dof));
  panel.quantity = fmt::format("{} velocity", Name(dof));
  panel.unit = VelocityUnit(dof);
  panel.time = stretch.time;
  Series measured;
  measured.name = "measured";
  for (const Vector6& velocity : stretch.velocity) measured.values.push_back(velocity[Index(dof)]);
  panel.measured = std::move(measured);
  if (identified.diagonal) {
    panel.responses.push_back(AlongDof("diagonal model", *identified.diagonal, log, segment, dof));
  }
  panel.responses.push_back(AlongDof("this model", identified.prediction, log, segment, dof));
  if (stretch.is_held_out && !stretch.time.empty()) {
    panel.held_out.push_back({stretch.time.front(), stretch.time.back()});
  }
  return panel;
}

PageSection MotionSection(const CoupledIdentification& identified) {
  PageSection section;
  section.heading = "Measured and simulated";
  section.text = {fmt::format(
      "Free runs over the command, begun anew from the measured state every {:g} s. Between the "
      "starts the measured motion enters nowhere.",
      identified.fitted.horizon)};
  section.tables.push_back(CoupledFigureTable(identified.fitted));
  for (const Dof dof : identified.fitted.model.dofs) {
    for (std::size_t log = 0; log < identified.data.size(); ++log) {
      for (std::size_t s = 0; s < identified.data[log].segments.size(); ++s) {
        section.time_panels.push_back(PanelOf(identified, log, s, dof));
      }
    }
  }
  return section;
}

PageSection CauseSection(const CoupledDiagnosis& diagnosis, const FittedCoupledModel& fitted) {
  PageSection section;
  section.heading = "What the diagonal model leaves out";
  for (const NamedEntry& cause : diagnosis.causes) {
    section.text.push_back(CauseSentence(cause, fitted.force_unit));
  }
  return section;
}

PageSection LadderSection(const Ladder& ladder, const std::vector<Dof>& dofs) {
  PageSection section;
  section.heading = "Which structure";
  section.text = {
      "A structure stands if its runs over data that were not fitted are nearer than those of the "
      "one before, by more than 1.65 standard errors."};
  section.tables.push_back(LadderTable(ladder, dofs));
  return section;
}

PageSection MatrixSection(const FittedCoupledModel& fitted) {
  PageSection section;
  section.heading = "The numbers";
  Table all = CoupledEntryTable(fitted);
  if (fitted.model.dofs.size() > 1) {
    section.text = {
        "Numbers with a deviation were identified. Others were held, and \"-\" is 0 because "
        "nothing "
        "in the data asks for more."};
    section.tables = CoupledMatrixTables(fitted);
    all.fold = "All numbers with their 95 % intervals";
  }
  section.tables.push_back(std::move(all));
  return section;
}

}  // namespace

Page CoupledPage(const CoupledDiagnosis& diagnosis, const CoupledIdentification& identified) {
  const FittedCoupledModel& fitted = identified.fitted;
  const Ladder& ladder = *identified.ladder;
  Page page;
  page.title = fmt::format("Coupled motion: {}", NamesOf(fitted.model.dofs));
  std::vector<std::string> logs;
  for (const CoupledData& data : identified.data) logs.push_back(data.log);
  page.subtitle = fmt::format("{}", fmt::join(logs, ", "));
  page.lead = {CoupledVerdictSentence(diagnosis, identified)};
  page.facts = {{"verdict", std::string(Name(diagnosis.verdict))},
                {"structure", ladder.rungs[ladder.accepted].name},
                {"identified numbers", fmt::format("{}", fitted.entries.size())}};
  for (const Finding& finding : diagnosis.findings) {
    if (finding.severity == Severity::kWarning) page.warnings.push_back(finding.sentence);
  }
  if (diagnosis.causes.size() > 1) page.sections.push_back(CauseSection(diagnosis, fitted));
  PageSection next;
  next.heading = "What to do next";
  next.text = CoupledNextSteps(diagnosis);
  page.sections.push_back(std::move(next));
  page.sections.push_back(MotionSection(identified));
  page.sections.push_back(LadderSection(ladder, fitted.model.dofs));
  page.sections.push_back(MatrixSection(fitted));
  std::vector<std::string>& notes = page.sections.back().notes;
  notes = fitted.caveats;
  notes.insert(notes.end(), identified.remarks.begin(), identified.remarks.end());
  for (const Finding& finding : diagnosis.findings) {
    if (finding.severity == Severity::kNote) notes.push_back(finding.sentence);
  }
  return page;
}

}  // namespace fathom
