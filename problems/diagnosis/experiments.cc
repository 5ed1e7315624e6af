// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/experiments.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace fathom {
namespace {

struct Decision {
  std::string_view a, b;  // effects, in either order
  std::string_view experiment;
};

// Pairs that need something special; EFFECTS.md.
constexpr std::array kDecisions = {
    Decision{"sensor_bias",
             "steady_current",
             "No velocity log alone can: the two are identical at every speed. Log poses too."},
    Decision{
        "thruster_lag",
        "time_offset",
        "A square wave of a few seconds' period: a lag rounds the corners, a delay moves them."},
    Decision{"thruster_lag",
             "sensor_lag",
             "Large steps, to speeds where quadratic drag matters: in linear drag lags commute."},
    Decision{
        "sensor_lag",
        "time_offset",
        "A square wave of a few seconds' period: a lag rounds the corners, a delay moves them."},
    Decision{
        "thruster_lag",
        "thrust_slew_limit",
        "Steps of several sizes: a lag takes as long for each, a ramp longer for larger ones."},
    Decision{
        "time_offset",
        "thrust_slew_limit",
        "Steps of several sizes: a delay is the same for each, a ramp longer for larger ones."},
    Decision{"thrust_dead_zone",
             "coulomb_friction",
             "Small commands of both signs while the vehicle still coasts either way."},
    Decision{"thrust_saturation",
             "cubic_damping",
             "Large commands at low speed: short full thrust from rest, both ways."},
    Decision{"thrust_asymmetry",
             "damping_asymmetry",
             "Reversals while moving: full thrust against the motion, both ways."},
    Decision{"coulomb_friction",
             "cubic_damping",
             "A range of speeds held for a while each, from very slow to full."},
    Decision{"buoyancy_step", "buoyancy_drift", "The same run again, longer, with a rest inside."},
    Decision{"position_stiffness",
             "buoyancy_drift",
             "Go out and come back: a spring returns with the position, a drift does not."},
    Decision{"position_stiffness",
             "buoyancy_step",
             "Go out and come back: a spring returns with the position, a step does not."},
};

}  // namespace

std::string DecidingExperiment(const Suspect& cause, const std::vector<Suspect>& rivals) {
  std::set<std::string_view> names = {cause.effect->info().name};
  for (const Suspect& rival : rivals) names.insert(rival.effect->info().name);
  for (const Decision& decision : kDecisions) {
    if (names.contains(decision.a) && names.contains(decision.b)) {
      return std::string(decision.experiment);
    }
  }
  const bool has_partner = cause.effect->info().has_partner ||
                           std::any_of(rivals.begin(), rivals.end(), [](const Suspect& rival) {
                             return rival.effect->info().has_partner;
                           });
  if (has_partner) {
    return "A run in which the other DOF moves without being commanded, and is commanded without "
           "this one.";
  }
  // Of a run and of the vehicle: the same run again tells. Among rivals of the vehicle it does not,
  // and any other run rids of those of this run too.
  const auto is_of_run = [](const Suspect& suspect) {
    return suspect.effect->info().scope == Scope::kRun;
  };
  if (is_of_run(cause) || std::all_of(rivals.begin(), rivals.end(), is_of_run)) {
    return "The same run again: what belonged to this run alone will be gone.";
  }
  return "A multisine from slow to fast with steps of several sizes both ways (10 s square wave, "
         "0.1 to 1.5 rad/s).";
}

}  // namespace fathom
