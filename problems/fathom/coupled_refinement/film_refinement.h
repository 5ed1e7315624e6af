// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_identification.h"
#include "fathom/coupled_refinement/coupled_film.h"
#include "fathom/coupled_refinement/film_fit.h"
#include "fathom/joint_refinement/logs/marker_logs.h"
#include "fathom/log/log.h"
#include "fathom/simulate/coupled/coupled_prediction.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

struct FilmRefinementOptions {
  CoupledIdentificationOptions identification;  // of the fit of the poses, where the search begins
  FilmFitOptions fit;
};

struct FilmRefinement {
  bool is_usable = false;
  std::string message;  // why not

  CoupledIdentification of_poses;  // the coupled fit of the PnP poses
  CoupledFilm film;
  FilmSummary joint;
  FittedCoupledModel fitted;  // the joint model, where usable

  // Free runs of both models against velocity.csv, which neither was fitted to; where there is
  // none, against the derivative of the PnP poses.
  std::vector<CoupledData> judges;  // the logs by what judges the models
  std::optional<CoupledPrediction> poses_prediction, joint_prediction;
  bool is_judged_by_velocity = false;

  std::vector<std::string> remarks;
};

// A coupled model and the camera's path together, from logs with markers: the coupled fit of their
// PnP poses, then FitFilm() from there. docs/coupled.md, "Joint refinement". Velocities of the logs
// are not fitted.
//
// Throws InputError as IdentifyCoupled() and FitFilm() do.
FilmRefinement RefineCoupled(const MarkerLogs& logs, const FilmRefinementOptions& options);

// How far a path is from the true one, over the frames of a refinement within the true poses'
// time: root mean squares of the distance [m] and the angle [rad].
struct PathError {
  double position = 0.0, angle = 0.0;
  int num_frames = 0;
};
struct PathErrors {
  PathError of_pnp, refined;
};

// `truth`: a stream as pose.csv, joined between its samples. Throws InputError if it covers no
// frame.
PathErrors PathErrorsOf(const FilmRefinement& refinement, const Stream& truth);

}  // namespace fathom
