// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "placebo.h"

#include "fathom/diagnosis/diagnosis.h"

#include <algorithm>
#include <vector>

#include "named.h"
#include "surge_run.h"

namespace fathom {
namespace {

SurgeRun RunFor(std::uint64_t seed) {
  const std::vector<std::string> effects = {"",
                                            "thruster_lag:time_constant=0.5",
                                            "thrust_dead_zone:width=10",
                                            "buoyancy_step:jump=8:time=35"};
  SurgeRun run;
  run.input = seed % 3 == 0 ? Steps({50.0, -20.0, 10.0, -50.0, 30.0, 0.0}, 7.0) : Multisine(35.0);
  run.duration = 80.0;
  run.noise_correlation = seed % 2 == 0 ? 0.0 : 0.7;
  run.effects = effects[seed % effects.size()];
  return run;
}

bool IsPlacebo(const std::string& label) {
  return label.ends_with("(sway)") || label.ends_with("(yaw)");
}

}  // namespace

PlaceboLog PlaceboLogOf(std::uint64_t seed) {
  const SurgeRun run = RunFor(seed);
  SurgeRun another = run;
  another.input = seed % 2 == 0 ? Multisine(30.0) : Steps({40.0, 0.0, -40.0, 15.0}, 9.0);
  PlaceboLog made = {LogOf(run, seed), run.effects};
  const Log other = LogOf(another, seed + 100000);
  const auto reversed = [](std::vector<double> values) {
    std::reverse(values.begin(), values.end());
    return values;
  };
  const auto add = [](Stream* stream, const char* column, std::vector<double> values) {
    values.resize(stream->time.size());
    stream->columns.emplace_back(column);
    stream->values.push_back(std::move(values));
  };
  const std::vector<double> command = *made.log.command->Find("tau_surge");
  const std::vector<double> velocity = *made.log.velocity->Find("u");
  add(&*made.log.command, "tau_sway", *other.command->Find("tau_surge"));
  add(&*made.log.command, "tau_yaw", reversed(command));
  add(&*made.log.velocity, "v", *other.velocity->Find("u"));
  add(&*made.log.velocity, "r", reversed(velocity));
  return made;
}

PlaceboResult TryPlacebo(std::uint64_t seed) {
  const PlaceboLog made = PlaceboLogOf(seed);
  const Diagnosis diagnosis = Diagnose(std::vector{made.log}, Dof::kSurge);
  PlaceboResult result;
  result.text = (made.hidden.empty() ? "nothing" : made.hidden) + " -> " + TextOf(diagnosis);
  int num_offered = 0;
  for (const Candidate& candidate : diagnosis.candidates) num_offered += IsPlacebo(candidate.label);
  // Crosstalk and velocity coupling of both, Coriolis coupling, misalignment, lever arm.
  result.is_offered = num_offered == 7;
  for (const NamedGroup& group : GroupsOf(diagnosis)) {
    result.is_named |= IsPlacebo(group.cause);
    for (const std::string& member : group.members) result.is_alternative |= IsPlacebo(member);
  }
  return result;
}

}  // namespace fathom
