// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Drawn boats with a weak effect: what a verdict leaves open, what a plan and sines of the
// same length foretell of it, and what the ladder names of each, played by the hidden truth.
//
//   rival_scores [boats] [seconds]

#include "fathom/coupled_planning/plan_coupled.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <cstdlib>
#include <string>

#include "ambiguous_boat.h"
#include <fmt/format.h>

namespace fathom {
namespace {

// Weak, so that a first log leaves some of them open.
constexpr HiddenCause kHidden[] = {{"cubic_damping.sway", 50.0, 150.0},
                                   {"coulomb_friction.sway", 0.3, 0.8}};

// "cubic_damping.sway 8.1 (or coulomb_friction.sway)", the number in standard deviations.
std::string NamedWords(const Ladder& ladder) {
  std::string words;
  for (const NamedEntry& named : ladder.named) {
    words += fmt::format(" {} {:.1f}", NameOf(named.entry), named.value / named.std);
    for (const FreeEntry& other : named.not_told_apart) {
      words += fmt::format(" (or {})", NameOf(other));
    }
  }
  return words;
}

void ScoreBoat(const HiddenCause& hidden, unsigned seed, double duration) {
  const AmbiguousBoat boat = DrawAmbiguousBoat(hidden, seed);
  const CoupledPlanRequest request = RivalRequest(boat, duration, 1.0);
  if (request.rivals.empty()) return;
  const CoupledPlan plan = PlanCoupledExperiment(request);
  fmt::print("{} {}: {}\n", hidden.entry, seed, plan.IsUsable() ? "" : plan.message);
  for (const PlannedSeparation& pair : plan.separations) {
    fmt::print(
        "  {} against {}: {:.1f} ({:.1f})\n", pair.truth, pair.assumed, pair.sigmas, pair.sine);
  }
  if (!plan.IsUsable()) return;
  fmt::print("  plan: {}\n",
             NamedWords(LadderOfPlayed(boat.truth, plan.command, plan.duration, seed)));
  fmt::print("  sines:{}\n",
             NamedWords(LadderOfPlayed(boat.truth, plan.sine, plan.duration, seed)));
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  const int num_boats = argc > 1 ? std::atoi(argv[1]) : 5;
  const double duration = argc > 2 ? std::atof(argv[2]) : 120.0;
  for (const fathom::HiddenCause& hidden : fathom::kHidden) {
    for (int k = 1; k <= num_boats; ++k) {
      fathom::ScoreBoat(hidden, 7000 + static_cast<unsigned>(k), duration);
    }
  }
  return 0;
}
