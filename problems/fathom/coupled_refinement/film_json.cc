// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/film_json.h"

#include "fathom/base/files/json_text.h"
#include "fathom/coupled_refinement/film_text.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/figures_entry.h"

#include <cstddef>

#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

// A model file, and its free runs against what judges both.
Json JsonOf(const FittedCoupledModel& fitted, const std::optional<CoupledPrediction>& prediction) {
  Json train = nullptr, held_out = nullptr;  // of runs that diverge
  if (prediction) {
    train = held_out = Json::object();
    for (const Dof dof : fitted.model.dofs) {
      const auto at = static_cast<std::size_t>(Index(dof));
      train[std::string(Name(dof))] = JsonOfFigures<Json>(prediction->train[at]);
      held_out[std::string(Name(dof))] = JsonOfFigures<Json>(prediction->held_out[at]);
    }
  }
  return {{"model", Json::parse(FormatCoupledModel(fitted))},
          {"free_runs", {{"train", train}, {"held_out", held_out}}}};
}

Json JsonOf(const PathError& error) {
  return {{"position", error.position}, {"angle", error.angle}, {"frames", error.num_frames}};
}

}  // namespace

std::string FormatFilmRefinementJson(const FilmRefinement& refinement,
                                     const std::optional<PathErrors>& path) {
  int num_outliers = 0;
  for (const RefinedWindow& window : refinement.joint.windows) num_outliers += window.num_outliers;
  Json json = {{"schema", "fathom-film-refinement-1"},
               {"judged_by", FilmJudge(refinement)},
               {"of_poses", JsonOf(refinement.of_poses.fitted, refinement.poses_prediction)},
               {"joint", JsonOf(refinement.fitted, refinement.joint_prediction)},
               {"corner_sigma", refinement.joint.processes.corner_sigma},
               {"detections", refinement.joint.num_detections},
               {"outliers", num_outliers},
               {"remarks", refinement.remarks}};
  if (path) json["path"] = {{"of_pnp", JsonOf(path->of_pnp)}, {"refined", JsonOf(path->refined)}};
  return JsonText(json);
}

}  // namespace fathom
