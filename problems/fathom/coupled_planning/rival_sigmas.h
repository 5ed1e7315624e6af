// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/entry_rival.h"

#include <vector>

#include <Eigen/Core>

namespace fathom {

// Two causes by their rows in the information of a run: one true, the other assumed.
struct PlacedRival {
  Eigen::Index truth = 0, assumed = 0;
  double value = 0.0;  // of the true one
};

// The rows of pairs. `entries`: those of a model, behind which the missing ones of the pairs are
// put.
std::vector<PlacedRival> PlaceRivals(const std::vector<EntryRival>& rivals,
                                     std::vector<FreeEntry>* entries);

// By how many standard deviations a run tells each true cause from the assumed one, to first order.
// The effect of the true one is its value times its sensitivity s; what the model's other numbers S
// and the assumed cause r imitate of it counts for nothing:
//
//   lambda^2 = min over a, b of value^2 |s - S a - r b|^2                    docs/plan.md (11)
//
// `information`: of the run, in the order of the entries; the first `num_of_model` are the model's.
std::vector<double> SigmasOf(const std::vector<PlacedRival>& rivals,
                             Eigen::Index num_of_model,
                             const Eigen::MatrixXd& information);

// The pairs, and behind them each the other way round: the rival true, of the size at which it
// imitates the named cause best in a run of this information, which stands for the log so far.
std::vector<PlacedRival> BothWays(const std::vector<PlacedRival>& rivals,
                                  Eigen::Index num_of_model,
                                  const Eigen::MatrixXd& information);

// What separations are worth to a search: -ln of the sum of 1 / (1 + lambda^2). The least one
// leads, and one that nothing can raise leaves the others their worth.
double WorthOfSigmas(const std::vector<double>& sigmas);

}  // namespace fathom
