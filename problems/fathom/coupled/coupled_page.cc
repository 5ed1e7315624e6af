// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_page.h"

#include "fathom/base/names_of_dofs.h"
#include "fathom/coupled/cause_words.h"
#include "fathom/coupled/coupled_text.h"
#include "fathom/coupled/motion_panels.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

PageSection MotionSection(const CoupledIdentification& identified) {
  PageSection section;
  section.heading = "Measured and simulated";
  section.text = {fmt::format(
      "Free runs over the command, begun anew from the measured state every {:g} s. Between the "
      "starts the measured motion enters nowhere.",
      identified.fitted.horizon)};
  section.tables.push_back(CoupledFigureTable(identified.fitted));
  std::vector<NamedPrediction> predictions;
  if (identified.diagonal) predictions.push_back({"diagonal model", &*identified.diagonal});
  predictions.push_back({"this model", &identified.prediction});
  section.time_panels = MotionPanels(identified.data, identified.fitted.model.dofs, predictions);
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
  if (!ladder.not_asked_for.empty()) section.text.push_back(NotFittedSentence(ladder));
  section.tables.push_back(LadderTable(ladder, dofs));
  return section;
}

PageSection MatrixSection(const FittedCoupledModel& fitted) {
  PageSection section;
  section.heading = "The numbers";
  Table all = CoupledEntryTable(fitted);
  if (fitted.model.dofs.size() > 1) {
    section.text = {
        "Numbers with ± were fitted, numbers without were given. \"-\" is 0: the data do not ask "
        "for more."};
    section.tables = CoupledMatrixTables(fitted);
    all.fold = "All numbers with their 95 % intervals";
  }
  section.tables.push_back(std::move(all));
  return section;
}

}  // namespace

Page CoupledPage(const CoupledDiagnosis& diagnosis,
                 const CoupledIdentification& identified,
                 const std::string& plan_command) {
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
  next.text = CoupledNextSteps(diagnosis, plan_command);
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
