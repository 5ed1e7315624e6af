// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/active_set.h"

#include <string>
#include <utility>
#include <vector>

#include <ceres/problem.h>
#include <ceres/solver.h>

namespace fathom {

// Holds the entries of a block whose std is 0, and those in `also`.
void Hold(double* block,
          const std::vector<double>& std,
          std::vector<int> also,
          ceres::Problem* problem);

// What Ceres did over all its searches.
struct SearchCounts {
  double initial_cost = 0.0;
  int num_iterations = 0;
  double seconds_per_iteration = 0.0;  // of the last search
};

// The search of the joint problem with dampings held or free.
class DampingSearch final : public BoundedSearch {
 public:
  // `model`: its block. Counts and times go to `counts`.
  DampingSearch(const ceres::Solver::Options& options,
                std::vector<double> model_std,
                double* model,
                ceres::Problem* problem,
                SearchCounts* counts)
      : options_(options),
        model_std_(std::move(model_std)),
        model_(model),
        problem_(problem),
        counts_(counts) {
    problem->GetParameterBlocks(&blocks_);
  }

  Optimum Solve(const std::vector<int>& held) override;
  double Value(int unknown) const override { return model_[unknown]; }
  void SetToZero(int unknown) override { model_[unknown] = 0.0; }
  std::vector<double> Point() const override;
  void GoTo(const std::vector<double>& point) override;

 private:
  const ceres::Solver::Options options_;
  const std::vector<double> model_std_;
  double* const model_;
  ceres::Problem* const problem_;
  SearchCounts* const counts_;
  std::vector<double*> blocks_;
};

}  // namespace fathom
