// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/experiments.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

struct Decision {
  std::string_view a, b;  // effects, in either order
  std::string_view experiment;
  bool decides = true;  // DecidingRun::decides
};

// Steps of one size would leave the ramp open.
constexpr std::string_view kSteps =
    "Steps of several sizes both ways, some seconds each: a lag rounds the corners, a delay moves "
    "them, a ramp takes longer for larger steps.";

// Pairs that need something special; EFFECTS.md.
constexpr std::array kDecisions = {
    Decision{"sensor_bias",
             "steady_current",
             "No velocity log alone can: the two are identical at every speed. Log poses too.",
             false},
    Decision{"thruster_lag", "time_offset", kSteps},
    Decision{
        "thruster_lag",
        "sensor_lag",
        "Poses too, which come without the speed sensor's lag, or large steps, to speeds where "
        "quadratic drag matters: in linear drag lags commute."},
    Decision{"sensor_lag", "time_offset", kSteps},
    Decision{"thruster_lag", "thrust_slew_limit", kSteps},
    Decision{"sensor_lag", "thrust_slew_limit", kSteps},
    Decision{"time_offset", "thrust_slew_limit", kSteps},
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

DecidingRun DecidingExperiment(const Suspect& cause, const std::vector<Suspect>& rivals) {
  const std::string_view name = cause.effect->info().name;
  std::vector<std::string_view> experiments;
  bool any_decides = true;  // as the first of them says
  for (const Decision& decision : kDecisions) {
    const bool decides = std::any_of(rivals.begin(), rivals.end(), [&](const Suspect& rival) {
      const std::string_view other = rival.effect->info().name;
      return (decision.a == name && decision.b == other) ||
             (decision.a == other && decision.b == name);
    });
    const bool is_new =
        std::find(experiments.begin(), experiments.end(), decision.experiment) == experiments.end();
    if (!decides || !is_new) continue;
    if (experiments.empty()) any_decides = decision.decides;
    experiments.push_back(decision.experiment);
  }
  if (!experiments.empty()) {
    return {fmt::format("{}", fmt::join(experiments, " ")), any_decides};
  }
  const bool has_partner = cause.effect->info().has_partner ||
                           std::any_of(rivals.begin(), rivals.end(), [](const Suspect& rival) {
                             return rival.effect->info().has_partner;
                           });
  if (has_partner) {
    return {
        "A run in which the other DOF moves without being commanded, and is commanded without "
        "this one."};
  }
  // Of a run and of the vehicle: the same run again tells. Among rivals of the vehicle it does not,
  // and any other run rids of those of this run too.
  const auto is_of_run = [](const Suspect& suspect) {
    return suspect.effect->info().scope == Scope::kRun;
  };
  if (is_of_run(cause) || std::all_of(rivals.begin(), rivals.end(), is_of_run)) {
    return {"The same run again: what belonged to this run alone will be gone."};
  }
  return {
      "A multisine from slow to fast with steps of several sizes both ways (10 s square wave, "
      "0.1 to 1.5 rad/s)."};
}

}  // namespace fathom
