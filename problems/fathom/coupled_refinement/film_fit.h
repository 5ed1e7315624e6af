// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/coupled_film.h"
#include "fathom/geometry/pose_increment.h"
#include "fathom/joint_refinement/processes/process_set.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

struct FilmFitOptions {
  // Squared norm of a detection's eight whitened residuals from which on it counts by its
  // logarithm. Above 0.
  double loss_limit = 26.1;

  int max_iterations = 50;  // of each search, above 0
  int max_rounds = 6;       // how often the processes are estimated at most, above 0

  // Called before each round with its number from 1 on; may be empty.
  std::function<void(int round, int max_rounds)> on_round = {};

  // One line for each rule that is broken; empty if these options can be used.
  std::vector<std::string> Problems() const;
};

// A window as refined.
struct RefinedWindow {
  std::vector<Pose> world_from_body;            // of each frame
  std::vector<PoseCovariance> pose_covariance;  // of each, everything else unknown as well
  int num_outliers = 0;                         // detections that the loss does not take in full
};

// Numbers that were not computed are NaN, never zero.
struct FilmSummary {
  // True if the search converged to a model that the corners determine.
  bool IsUsable() const { return converged && determined; }

  std::string message = "FitFilm() was not called.";
  bool converged = false;
  bool determined = false;
  bool settled = false;  // the estimate of the processes
  int num_iterations = 0;
  int num_rounds = 0;
  double final_cost = std::numeric_limits<double>::quiet_NaN();

  CoupledModel model;
  Eigen::MatrixXd covariance;  // of the structure's entries, in their order

  // Of the held DOFs by ProcessSet::wander; the first modelled DOF has the model error, the other
  // modelled ones a wander.
  ProcessSet processes;
  std::vector<RefinedWindow> windows;
  int num_detections = 0;
};

// The coupled model's free entries and every camera pose together, from the corners themselves, as
// one problem: docs/coupled.md, "Joint refinement". The search starts at `start`.
//
// Throws InputError if the options or the film cannot be used. A poor fit does not throw: see the
// summary.
FilmSummary FitFilm(const CoupledFilm& film,
                    const CoupledModel& start,
                    const FilmFitOptions& options = {});

}  // namespace fathom
