// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/film_problem.h"

#include "fathom/coupled_refinement/barrier_cost.h"
#include "fathom/coupled_refinement/film_corner_cost.h"
#include "fathom/coupled_refinement/film_motions.h"
#include "fathom/joint_refinement/motion/linear_segment.h"
#include "fathom/joint_refinement/problem/linear_cost.h"
#include "fathom/joint_refinement/problem/make_clipped_loss.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <ceres/cost_function.h>
#include <ceres/evaluation_callback.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

namespace fathom {
namespace {

// Simulates every window once per point, before Ceres asks any corner.
class FilmCallback final : public ceres::EvaluationCallback {
 public:
  FilmCallback(const FilmUnknowns* unknowns, FilmMotions* motions)
      : unknowns_(unknowns), motions_(motions) {}

  void PrepareForEvaluation(bool evaluate_jacobians, bool new_evaluation_point) override {
    if (!new_evaluation_point && (has_jacobians_ || !evaluate_jacobians) && is_prepared_) return;
    motions_->Update(*unknowns_, evaluate_jacobians);
    has_jacobians_ = evaluate_jacobians;
    is_prepared_ = true;
  }

 private:
  const FilmUnknowns* const unknowns_;
  FilmMotions* const motions_;
  bool has_jacobians_ = false, is_prepared_ = false;
};

// The deviations that Ceres moves, the moving DOFs side by side, by window.
struct MovingBlocks {
  std::vector<std::vector<double>> deviation, rate;

  MovingBlocks(const FilmUnknowns& unknowns, const std::vector<int>& moving) {
    for (const FilmWindowUnknowns& window : unknowns.windows) {
      auto& n = deviation.emplace_back();
      auto& v = rate.emplace_back();
      for (std::size_t k = 0; k < window.deviation.size(); ++k) {
        for (const int i : moving) {
          n.push_back(window.deviation[k][i]);
          v.push_back(window.rate[k][i]);
        }
      }
    }
  }

  void Store(const std::vector<int>& moving, FilmUnknowns* unknowns) const {
    for (std::size_t w = 0; w < deviation.size(); ++w) {
      FilmWindowUnknowns& window = unknowns->windows[w];
      for (std::size_t k = 0; k < window.deviation.size(); ++k) {
        window.deviation[k] = window.rate[k] = {};
        for (std::size_t i = 0; i < moving.size(); ++i) {
          window.deviation[k][moving[i]] = deviation[w][k * moving.size() + i];
          window.rate[k][moving[i]] = rate[w][k * moving.size() + i];
        }
      }
    }
  }
};

// How the deviations of a window go from frame to frame.
void AddWindowChain(const FilmWindow& window,
                    const ProcessSet& processes,
                    int freely,
                    const std::vector<int>& moving,
                    std::vector<double>* deviation,
                    std::vector<double>* rate,
                    ceres::Problem* problem) {
  LinearSegment layout;
  LayOutDurations(window.time, &layout);
  std::vector<ceres::CostFunction*> steps;
  for (const double duration : layout.durations) {
    steps.push_back(MakeStepCost(processes, freely, moving, duration).release());
  }
  const std::size_t n = moving.size();
  for (std::size_t k = 0; k + 1 < window.time.size(); ++k) {
    problem->AddResidualBlock(steps[static_cast<std::size_t>(layout.duration_after[k])],
                              nullptr,
                              &(*deviation)[k * n],
                              &(*rate)[k * n],
                              &(*deviation)[(k + 1) * n],
                              &(*rate)[(k + 1) * n]);
  }
  problem->AddResidualBlock(
      MakeFirstCost(processes, freely, moving).release(), nullptr, deviation->data(), rate->data());
}

ceres::Solver::Options SearchOptions(int max_iterations) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = max_iterations;
  options.num_threads = 1;
  options.initial_trust_region_radius = 1e8;
  // A step beyond the barrier, or one whose simulation diverges, is refused and shortened.
  options.max_num_consecutive_invalid_steps = 50;
  options.function_tolerance = 1e-9;
  options.parameter_tolerance = 1e-10;
  options.gradient_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

int FreelyMoving(const CoupledFilm& film) { return Index(film.structure.dofs.front()); }

FilmSolve SolveFilm(const CoupledFilm& film,
                    const ProcessSet& processes,
                    const FilmSolveOptions& options,
                    FilmUnknowns* unknowns) {
  const int freely = FreelyMoving(film);
  std::vector<int> moving;
  for (int i = 0; i < 6; ++i) {
    if (processes.Of(i, freely).IsPresent()) moving.push_back(i);
  }
  MovingBlocks blocks(*unknowns, moving);
  FilmMotions motions(film);
  FilmCallback callback(unknowns, &motions);
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = &callback;
  problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::HuberLoss far(std::sqrt(options.loss_limit));
  const auto near = MakeClippedLoss(options.loss_limit);
  ceres::LossFunction* const loss =
      options.is_far ? static_cast<ceres::LossFunction*>(&far) : near.get();
  ceres::Problem problem(problem_options);
  for (std::size_t w = 0; w < film.windows.size(); ++w) {
    const FilmWindow& window = film.windows[w];
    for (std::size_t k = 0; k < window.time.size(); ++k) {
      std::vector<double*> list;
      if (!moving.empty()) list.push_back(&blocks.deviation[w][k * moving.size()]);
      list.insert(list.end(), {unknowns->shared.data(), unknowns->windows[w].start.data()});
      for (const Detection& detection : window.detections[k]) {
        auto cost =
            MakeFilmCornerCost({film, motions, moving, processes.corner_sigma, w, k, detection});
        problem.AddResidualBlock(cost.release(), loss, list);
      }
    }
    if (moving.empty()) continue;
    AddWindowChain(
        window, processes, freely, moving, &blocks.deviation[w], &blocks.rate[w], &problem);
  }
  problem.AddResidualBlock(
      MakeBarrierCost(film, *unknowns).release(), nullptr, unknowns->shared.data());
  ceres::Solver::Summary summary;
  ceres::Solve(SearchOptions(options.max_iterations), &problem, &summary);
  blocks.Store(moving, unknowns);
  return {.converged = summary.termination_type == ceres::CONVERGENCE,
          .message = summary.message,
          .num_iterations = static_cast<int>(summary.iterations.size()),
          .initial_cost = summary.initial_cost,
          .cost = summary.final_cost};
}

}  // namespace fathom
