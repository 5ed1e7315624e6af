// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/solve/active_set.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace fathom {
namespace {

std::vector<int> Without(std::vector<int> set, int unknown) {
  set.erase(std::remove(set.begin(), set.end(), unknown), set.end());
  return set;
}

// Holds at 0 what is below. False if nothing is.
bool HoldNegative(const std::vector<int>& bounded, BoundedSearch* search, std::vector<int>* held) {
  bool is_feasible = true;
  for (const int unknown : bounded) {
    if (search->Value(unknown) >= 0.0) continue;
    search->SetToZero(unknown);
    held->push_back(unknown);
    is_feasible = false;
  }
  std::sort(held->begin(), held->end());
  return !is_feasible;
}

// Solves, and again with what comes out negative held at 0, until nothing does: at most once for
// each bounded unknown.
BoundedOptimum SolveFeasible(const std::vector<int>& bounded,
                             std::vector<int> held,
                             BoundedSearch* search) {
  while (true) {
    BoundedSearch::Optimum optimum = search->Solve(held);
    BoundedOptimum result = {
        optimum.converged, optimum.cost, std::move(optimum.message), std::move(held)};
    if (!result.converged) return result;
    held = result.held;
    if (!HoldNegative(bounded, search, &held)) return result;
  }
}

}  // namespace

BoundedOptimum SearchActiveSet(const std::vector<int>& bounded,
                               double resolution,
                               BoundedSearch* search) {
  const std::vector<double> start = search->Point();
  BoundedOptimum best = SolveFeasible(bounded, {}, search);
  if (!best.converged) {
    if (bounded.empty()) return best;
    // Far from its optimum a model without bounds may run off to where nothing can be simulated.
    // The bounds keep it back: all held, to be let go one by one.
    search->GoTo(start);
    for (const int unknown : bounded) search->SetToZero(unknown);
    BoundedOptimum from_bounds = SolveFeasible(bounded, bounded, search);
    if (!from_bounds.converged) return best;
    best = std::move(from_bounds);
  }
  std::vector<double> best_point = search->Point();
  for (std::size_t next = 0; next < best.held.size();) {
    const int unknown = best.held[next++];
    search->GoTo(best_point);
    const BoundedSearch::Optimum released = search->Solve(Without(best.held, unknown));
    // It presses, also where the way down is so long that the search ran out of iterations.
    const bool is_lower = released.converged || released.cost < best.cost;
    if (is_lower && search->Value(unknown) <= 0.0) continue;
    std::vector<int> held = Without(best.held, unknown);
    BoundedOptimum trial = {released.converged, released.cost, released.message, held};
    if (trial.converged && HoldNegative(bounded, search, &held)) {
      trial = SolveFeasible(bounded, held, search);
    }
    const double least_gain = resolution * best.cost;
    if (trial.converged && std::abs(trial.cost - best.cost) <= least_gain) continue;  // the same
    if (!trial.converged || trial.cost > best.cost) {
      search->GoTo(best_point);
      best.converged = false;
      best.message = trial.converged
                         ? "releasing the parameters held at zero gives no better feasible optimum."
                         : "after releasing the parameters held at zero: " + trial.message;
      return best;
    }
    best = std::move(trial);
    best_point = search->Point();
    next = 0;
  }
  search->GoTo(best_point);
  return best;
}

}  // namespace fathom
