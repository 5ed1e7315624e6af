// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/coupled_film.h"
#include "fathom/geometry/pose_increment.h"
#include "fathom/joint_refinement/motion/linear_segment.h"
#include "fathom/joint_refinement/processes/process_set.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The most numbers that one window depends on: what is shared, and its start.
inline constexpr int kMostFilmColumns = kClockColumn;

// The corners of each window linearised about `unknowns`, weighted by the loss at `corner_sigma`
// [px]; the columns are what is shared, then the start. Nothing if a simulation diverges or a
// corner falls behind the camera. Takes at most kMostFilmColumns columns.
std::optional<std::vector<LinearSegment>> LineariseFilm(const CoupledFilm& film,
                                                        const FilmUnknowns& unknowns,
                                                        double corner_sigma,
                                                        double loss_limit);

// The processes under which linearised windows are likeliest, all else being as it
// is. All wanders of `start`, and its model error, are tried; those that the data do not ask for
// are left out. Nothing if the data do not determine them.
struct FilmProcesses {
  bool converged = false;
  ProcessSet processes;
  double log_likelihood = 0.0;
};
std::optional<FilmProcesses> FitFilmProcesses(std::span<const LinearSegment> windows,
                                              const ProcessSet& start,
                                              int freely);

// What the linear problem leaves in doubt, everything else unknown.
struct FilmSpread {
  Eigen::MatrixXd entries;                           // covariance
  std::vector<std::vector<PoseCovariance>> of_pose;  // of each frame of each window
};

// Nothing if some number leaves no trace.
std::optional<FilmSpread> FilmSpreadOf(const CoupledFilm& film,
                                       const FilmUnknowns& unknowns,
                                       std::span<const LinearSegment> windows,
                                       const ProcessSet& processes);

}  // namespace fathom
