// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/film_fit.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/coupled/physical_barrier.h"
#include "fathom/coupled_refinement/deviated_pose.h"
#include "fathom/coupled_refinement/film_motions.h"
#include "fathom/coupled_refinement/film_problem.h"
#include "fathom/coupled_refinement/linear_film.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kFewestFramesOfWindow = 10;
constexpr double kSettledLikelihood = 0.5;
constexpr double kFirstSigma = 1.0;      // of a corner [px], before it is estimated
constexpr double kLeastWander = 1e-4;    // [m] or [rad], where a search for it begins
constexpr double kFirstFrequency = 0.5;  // [rad/s]
constexpr double kFirstDrift = 0.01;     // [m] in ten seconds

void RequireUsableFilm(const CoupledFilm& film, const FilmFitOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError("FilmFitOptions: " + problems.front() + ".");
  }
  if (film.windows.empty()) throw InputError("A joint refinement needs at least one window.");
  const WindowMotion first(film, 0);
  if (const int columns = first.num_shared() + first.num_start(); columns > kMostFilmColumns) {
    throw InputError(
        fmt::format("The structure frees {} numbers of {} DOFs, expected at most {}: refine fewer "
                    "DOFs, or a smaller structure.",
                    film.structure.entries.size(),
                    film.structure.dofs.size(),
                    kMostFilmColumns - columns + static_cast<int>(film.structure.entries.size())));
  }
  for (const FilmWindow& window : film.windows) {
    const std::size_t n = window.time.size();
    if (n < kFewestFramesOfWindow || window.detections.size() != n ||
        window.world_from_body.size() != n) {
      throw InputError(
          fmt::format("A window has {} frames, {} lists of detections and {} poses, expected at "
                      "least {} of each and as many of one as of the other.",
                      n,
                      window.detections.size(),
                      window.world_from_body.size(),
                      kFewestFramesOfWindow));
    }
    for (const auto& detections : window.detections) {
      for (const Detection& detection : detections) {
        const Marker* const marker = film.map.Find(detection.tag_id);
        if (marker != nullptr && marker->is_surveyed) continue;
        throw InputError(
            fmt::format("A detection at {} s is of tag {}, expected a surveyed one of the map.",
                        detection.time,
                        detection.tag_id));
      }
    }
  }
}

bool IsModelled(const CoupledFilm& film, int row) {
  return std::ranges::any_of(film.structure.dofs, [&](Dof dof) { return Index(dof) == row; });
}

// How the held DOFs are off the simulated motion by the PnP poses; the modelled ones follow it.
std::optional<ProcessSet> FirstProcesses(const CoupledFilm& film, const FilmUnknowns& unknowns) {
  FilmMotions motions(film);
  if (!motions.Update(unknowns, false)) return std::nullopt;
  std::array<std::vector<double>, 6> off;
  for (std::size_t w = 0; w < film.windows.size(); ++w) {
    for (std::size_t k = 0; k < film.windows[w].time.size(); ++k) {
      const auto deviation =
          DeviationBetween(motions.at(w).PoseAt(k), film.windows[w].world_from_body[k]);
      for (std::size_t i = 0; i < 6; ++i) off[i].push_back(std::abs(deviation[i]));
    }
  }
  ProcessSet processes;
  processes.corner_sigma = kFirstSigma;
  const int freely = FreelyMoving(film);
  for (int i = 0; i < 6; ++i) {
    if (i == freely || IsModelled(film, i)) continue;
    const auto slot = static_cast<std::size_t>(i < freely ? i : i - 1);
    const double std = 1.5 * Median(std::move(off[static_cast<std::size_t>(i)]));
    processes.wander[slot] = {std::max(std, kLeastWander), kFirstFrequency, 1.0};
  }
  return processes;
}

// All that may be there, where the data have not yet said that it is: a place to begin.
ProcessSet WithAllProcesses(ProcessSet processes) {
  for (HeldWander& wander : processes.wander) {
    if (!wander.IsPresent()) wander = {0.001, kFirstFrequency, 1.0};
  }
  if (!(processes.model_error > 0.0)) {
    processes.model_error = 3.0 * kFirstDrift * kFirstDrift / 1000.0;
  }
  return processes;
}

bool HaveSameProcesses(const ProcessSet& a, const ProcessSet& b) {
  for (std::size_t j = 0; j < a.wander.size(); ++j) {
    if (a.wander[j].IsPresent() != b.wander[j].IsPresent()) return false;
  }
  return (a.model_error > 0.0) == (b.model_error > 0.0);
}

// Robust size of a corner's error about the present poses [px], as in joint_start.cc.
double CornerSigmaAt(const CoupledFilm& film, const FilmUnknowns& unknowns) {
  FilmMotions motions(film);
  std::vector<double> squares;
  if (!motions.Update(unknowns, false)) return kFirstSigma;
  for (std::size_t w = 0; w < film.windows.size(); ++w) {
    for (std::size_t k = 0; k < film.windows[w].time.size(); ++k) {
      const DeviatedPose pose = Deviated(motions.at(w).PoseAt(k), unknowns.windows[w].deviation[k]);
      for (const Detection& detection : film.windows[w].detections[k]) {
        PoseCornerRows rows;
        if (CornersAtPose({film.camera, film.body_from_camera},
                          *film.map.Find(detection.tag_id),
                          detection,
                          pose.world_from_body,
                          1.0,
                          &rows)) {
          squares.push_back(rows.residual.squaredNorm());
        }
      }
    }
  }
  if (squares.empty()) return kFirstSigma;
  return std::max(1e-4, std::sqrt(Median(std::move(squares)) / 7.34));
}

RefinedWindow RefinedWindowOf(const CoupledFilm& film,
                              const FilmUnknowns& unknowns,
                              const FilmMotions& motions,
                              double corner_sigma,
                              double loss_limit,
                              std::size_t w) {
  RefinedWindow refined;
  for (std::size_t k = 0; k < film.windows[w].time.size(); ++k) {
    const DeviatedPose pose = Deviated(motions.at(w).PoseAt(k), unknowns.windows[w].deviation[k]);
    refined.world_from_body.push_back(pose.world_from_body);
    for (const Detection& detection : film.windows[w].detections[k]) {
      PoseCornerRows rows;
      const bool is_ahead = CornersAtPose({film.camera, film.body_from_camera},
                                          *film.map.Find(detection.tag_id),
                                          detection,
                                          pose.world_from_body,
                                          corner_sigma,
                                          &rows);
      if (!is_ahead || rows.residual.squaredNorm() > loss_limit) ++refined.num_outliers;
    }
  }
  return refined;
}

// One search of the mode. False, with the reason in the summary, if it does not end.
bool FindFilmMode(const CoupledFilm& film,
                  const ProcessSet& processes,
                  const FilmSolveOptions& options,
                  FilmUnknowns* unknowns,
                  FilmSummary* summary) {
  const FilmSolve solve = SolveFilm(film, processes, options, unknowns);
  summary->num_iterations += solve.num_iterations;
  summary->final_cost = solve.cost;
  summary->message = solve.message;
  summary->converged = solve.converged;
  return solve.converged;
}

// The processes and the mode in turn, until the likelihood settles.
bool SearchFilm(const CoupledFilm& film,
                const FilmFitOptions& options,
                ProcessSet* processes,
                FilmUnknowns* unknowns,
                FilmSummary* summary) {
  const FilmSolveOptions near = {
      .max_iterations = options.max_iterations, .loss_limit = options.loss_limit, .is_far = false};
  FilmSolveOptions far = near;
  far.is_far = true;
  // A search from afar need not end: the next one goes on from there.
  FindFilmMode(film, *processes, far, unknowns, summary);
  processes->corner_sigma = CornerSigmaAt(film, *unknowns);
  double before = -std::numeric_limits<double>::infinity();
  for (int round = 1; round <= options.max_rounds; ++round) {
    if (options.on_round) options.on_round(round, options.max_rounds);
    const auto linear = LineariseFilm(film, *unknowns, processes->corner_sigma, options.loss_limit);
    if (!linear) {
      summary->converged = false;
      summary->message = "the simulation diverges, or a marker falls behind the camera.";
      return false;
    }
    const auto fit = FitFilmProcesses(*linear, WithAllProcesses(*processes), FreelyMoving(film));
    if (!fit) {
      summary->converged = false;
      summary->message = "the corners do not determine some unknown.";
      return false;
    }
    const bool is_same = HaveSameProcesses(fit->processes, *processes);
    if (round > 1 && is_same && fit->log_likelihood < before + kSettledLikelihood) {
      summary->settled = true;
      return true;
    }
    before = fit->log_likelihood;
    *processes = fit->processes;
    summary->num_rounds = round;
    if (!FindFilmMode(film, *processes, near, unknowns, summary)) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> FilmFitOptions::Problems() const {
  std::vector<std::string> problems;
  if (!(loss_limit > 0.0)) {
    problems.push_back(fmt::format("loss_limit is {}, expected more than 0", loss_limit));
  }
  if (max_iterations < 1) {
    problems.push_back(fmt::format("max_iterations is {}, expected at least 1", max_iterations));
  }
  if (max_rounds < 1) {
    problems.push_back(fmt::format("max_rounds is {}, expected at least 1", max_rounds));
  }
  return problems;
}

FilmSummary FitFilm(const CoupledFilm& film,
                    const CoupledModel& start,
                    const FilmFitOptions& options) {
  RequireUsableFilm(film, options);
  FilmSummary summary;
  const Vector6 least = Vector6::Constant(1e-9);
  CoupledModel inside = MovedInside(start, film.structure.entries, film.body, least, least, least);
  inside.dofs = film.structure.dofs;
  inside.coriolis = film.structure.coriolis;
  FilmUnknowns unknowns = FilmUnknownsAt(film, inside);
  auto processes = FirstProcesses(film, unknowns);
  if (!processes) {
    summary.message = "the first guess diverges.";
    return summary;
  }
  if (!SearchFilm(film, options, &*processes, &unknowns, &summary)) return summary;
  summary.model = unknowns.Model(film.structure);
  summary.processes = *processes;
  const auto linear = LineariseFilm(film, unknowns, processes->corner_sigma, options.loss_limit);
  auto spread = linear ? FilmSpreadOf(film, unknowns, *linear, *processes) : std::nullopt;
  if (!spread) {
    summary.message = "the corners do not determine some unknown.";
    return summary;
  }
  summary.determined = true;
  summary.message = "converged";
  summary.covariance = spread->entries;
  FilmMotions motions(film);
  motions.Update(unknowns, false);
  for (std::size_t w = 0; w < film.windows.size(); ++w) {
    summary.windows.push_back(
        RefinedWindowOf(film, unknowns, motions, processes->corner_sigma, options.loss_limit, w));
    summary.windows.back().pose_covariance = std::move(spread->of_pose[w]);
    for (const auto& detections : film.windows[w].detections) {
      summary.num_detections += static_cast<int>(detections.size());
    }
  }
  return summary;
}

}  // namespace fathom
