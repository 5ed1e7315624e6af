// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Coupled plans under coloured noise, for docs/plan.md: what fits of the planned run report, and
// what they miss of the truth, divided by what was predicted.
//
//   coupled_noise_table [boats = 3] [runs of each = 12] [correlation = 0.8]

#include "fathom/coupled/coupled_fit.h"
#include "fathom/coupled_planning/plan_coupled.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "boat_trial.h"
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kDuration = 80.0;  // of a plan [s]

double RootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

void PrintBoat(unsigned seed, int num_runs, double colour) {
  const DrawnBoat boat = DrawBoat(seed, colour);
  CoupledPlanRequest request = BoatRequest(boat, kDuration, 0.25);
  const CoupledPlan plan = PlanCoupledExperiment(request);
  request.model.residual_autoregression = {};
  const CoupledPlan as_white = PlanCoupledExperiment(request);
  const MotionStructure structure = StructureOf(StandardStructure::kCoriolis, boat.truth.dofs);
  std::vector<double> reported, missed, missed_as_white;
  for (int run = 1; run <= num_runs; ++run) {
    for (const bool is_white : {false, true}) {
      const CoupledPlan& played = is_white ? as_white : plan;
      const std::vector<CoupledData> next = {PlayedLog(boat.truth,
                                                       played.command,
                                                       played.duration,
                                                       kBoatNoise,
                                                       1000 * seed + static_cast<unsigned>(run),
                                                       colour)};
      const CoupledSummary fit = FitCoupled(next, structure);
      if (!fit.IsUsable()) continue;
      for (std::size_t k = 0; k < fit.entries.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        const double predicted = played.parameters[k].after;
        const double error =
            ValueIn(fit.model, fit.entries[k]) - ValueIn(boat.truth, fit.entries[k]);
        (is_white ? missed_as_white : missed).push_back(error / predicted);
        if (!is_white) reported.push_back(std::sqrt(fit.covariance(at, at)) / predicted);
      }
    }
  }
  std::sort(reported.begin(), reported.end());
  fmt::print("boat {}: reported {:.2f} ({:.2f} to {:.2f}), missed {:.2f}; taken as white {:.2f}\n",
             seed,
             reported[reported.size() / 2],
             reported.front(),
             reported.back(),
             RootMeanSquare(missed),
             RootMeanSquare(missed_as_white));
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  const int num_boats = argc > 1 ? std::atoi(argv[1]) : 3;
  const int num_runs = argc > 2 ? std::atoi(argv[2]) : 12;
  const double colour = argc > 3 ? std::atof(argv[3]) : 0.8;
  for (int boat = 0; boat < num_boats; ++boat) {
    fathom::PrintBoat(21 + static_cast<unsigned>(boat), num_runs, colour);
  }
  return 0;
}
