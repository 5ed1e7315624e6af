// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/film_page.h"

#include "fathom/base/median.h"
#include "fathom/base/names_of_dofs.h"
#include "fathom/coupled/coupled_text.h"
#include "fathom/coupled/motion_panels.h"
#include "fathom/coupled_refinement/film_text.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// What the corners tell beyond the poses.
std::string GainSentence(const FilmRefinement& refinement) {
  const Eigen::VectorXd before = refinement.of_poses.fitted.covariance.diagonal();
  const Eigen::VectorXd after = refinement.fitted.covariance.diagonal();
  std::vector<double> ratios;
  for (Eigen::Index k = 0; k < after.size(); ++k) ratios.push_back(std::sqrt(before[k] / after[k]));
  return fmt::format(
      "Model and path of the camera were estimated together from the corners of the markers. The "
      "intervals are {:.2g} times narrower, in the median, than those of the fit of the PnP poses.",
      Median(std::move(ratios)));
}

PageSection FreeRunSection(const FilmRefinement& refinement) {
  PageSection section;
  section.heading = "Measured and simulated";
  section.text = {fmt::format(
      "Free runs over the command, begun anew from the measured state every {:g} s, against {}.",
      refinement.fitted.horizon,
      FilmJudge(refinement))};
  section.tables.push_back(FilmFigureTable(refinement));
  std::vector<NamedPrediction> predictions;
  if (refinement.poses_prediction) {
    predictions.push_back({"from PnP poses", &*refinement.poses_prediction});
  }
  predictions.push_back({"joint", &*refinement.joint_prediction});
  section.time_panels = MotionPanels(refinement.judges, refinement.fitted.model.dofs, predictions);
  return section;
}

PageSection NumberSection(const FilmRefinement& refinement) {
  PageSection section;
  section.heading = "The numbers";
  section.tables = {FilmEntryTable(refinement)};
  if (refinement.fitted.model.dofs.size() > 1) {
    for (Table& matrix : CoupledMatrixTables(refinement.fitted)) {
      section.tables.push_back(std::move(matrix));
    }
  }
  section.notes = refinement.fitted.caveats;
  section.notes.insert(section.notes.end(), refinement.remarks.begin(), refinement.remarks.end());
  return section;
}

}  // namespace

Page FilmPage(const FilmRefinement& refinement) {
  Page page;
  page.title = fmt::format("Joint refinement: {}", NamesOf(refinement.fitted.model.dofs));
  std::vector<std::string> logs;
  for (const CoupledData& data : refinement.judges) logs.push_back(data.log);
  page.subtitle = fmt::format("{}", fmt::join(logs, ", "));
  page.lead = {GainSentence(refinement), FilmCornerSentence(refinement)};
  if (refinement.of_poses.ladder) page.lead.push_back(LadderSentence(*refinement.of_poses.ladder));
  page.facts = {{"corner sigma", fmt::format("{:.3g} px", refinement.joint.processes.corner_sigma)},
                {"detections", fmt::format("{}", refinement.joint.num_detections)},
                {"identified numbers", fmt::format("{}", refinement.fitted.entries.size())}};
  page.sections = {FreeRunSection(refinement), NumberSection(refinement)};
  return page;
}

}  // namespace fathom
