// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/film_text.h"

#include "fathom/coupled/coupled_text.h"
#include "fathom/report/format_value.h"
#include "fathom/report/table.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
Table FilmEntryTable(const FilmRefinement& refinement) {
  Table table = CoupledEntryTable(refinement.fitted);
  const FittedCoupledModel& before = refinement.of_poses.fitted;
  table.columns.push_back({"from PnP poses", true});
  for (std::size_t k = 0; k < before.entries.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    table.rows[k].cells.push_back(FormatValue(ValueIn(before.model, before.entries[k]),
                                              std::sqrt(before.covariance(at, at))));
  }
  return table;
}

Table FilmFigureTable(const FilmRefinement& refinement) {
  Table table;
  table.caption = fmt::format("NMAE of free runs, begun anew every {:g} s, against {}:",
                              refinement.fitted.horizon,
                              FilmJudge(refinement));
  table.columns = {{"DOF"},
                   {"from PnP poses", true},
                   {"joint", true},
                   {"from PnP poses, held out", true},
                   {"joint, held out", true}};
  for (const Dof dof : refinement.fitted.model.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    const auto text = [&](const std::optional<CoupledPrediction>& prediction, bool is_held_out) {
      if (!prediction) return std::string("diverges");
      const FitFigures& figures = is_held_out ? prediction->held_out[at] : prediction->train[at];
      return ShareText(figures.nmae, 4);
    };
    table.rows.push_back({{std::string(Name(dof)),
                           text(refinement.poses_prediction, false),
                           text(refinement.joint_prediction, false),
                           text(refinement.poses_prediction, true),
                           text(refinement.joint_prediction, true)}});
  }
  return table;
}

namespace {

// Of a DOF's deviation: how far it wanders, where it does.
std::string WanderText(const FilmRefinement& refinement) {
  const ProcessSet& processes = refinement.joint.processes;
  const int freely = Index(refinement.film.structure.dofs.front());
  std::string text;
  for (const Dof dof : kAllDofs) {
    const int i = Index(dof);
    if (i == freely) continue;
    const HeldWander& wander = processes.wander[static_cast<std::size_t>(i < freely ? i : i - 1)];
    if (!wander.IsPresent()) continue;
    text += fmt::format("{}{} wanders by {:.2g} {}",
                        text.empty() ? "" : ", ",
                        Name(dof),
                        wander.std,
                        i < 3 ? "m" : "rad");
  }
  if (processes.model_error > 0.0) {
    text += fmt::format("{}{} is pushed by a force that the model misses",
                        text.empty() ? "" : ", ",
                        Name(refinement.film.structure.dofs.front()));
  }
  return text.empty() ? "No DOF leaves the simulated motion"
                      : "Beside the simulated motion " + text;
}

}  // namespace

std::string FilmJudge(const FilmRefinement& refinement) {
  return refinement.is_judged_by_velocity ? "velocity.csv" : "the derivative of the PnP poses";
}

std::string FilmCornerSentence(const FilmRefinement& refinement) {
  int num_outliers = 0;
  for (const RefinedWindow& window : refinement.joint.windows) num_outliers += window.num_outliers;
  return fmt::format("Corner sigma {:.3g} px; {} of {} detections far off. {}.",
                     refinement.joint.processes.corner_sigma,
                     num_outliers,
                     refinement.joint.num_detections,
                     WanderText(refinement));
}

std::string FormatFilmRefinement(const FilmRefinement& refinement) {
  std::string text;
  if (refinement.of_poses.ladder) text += LadderSentence(*refinement.of_poses.ladder) + "\n";
  text += FormatTable(FilmEntryTable(refinement)) + "\n";
  text += FormatTable(FilmFigureTable(refinement)) + "\n";
  text += FilmCornerSentence(refinement) + "\n";
  for (const std::string& caveat : refinement.fitted.caveats) text += "note: " + caveat + "\n";
  return text;
}

std::string FormatPathErrors(const PathErrors& errors) {
  return fmt::format(
      "Path error over {} frames: {:.4g} m and {:.4g} rad by PnP, {:.4g} m and {:.4g} rad refined: "
      "{:.3f} and {:.3f} of PnP's.\n",
      errors.refined.num_frames,
      errors.of_pnp.position,
      errors.of_pnp.angle,
      errors.refined.position,
      errors.refined.angle,
      errors.refined.position / errors.of_pnp.position,
      errors.refined.angle / errors.of_pnp.angle);
}

}  // namespace fathom
