// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/mean_thruster_forces.h"

#include "fathom/simulate/integration/memory_before.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace fathom {
namespace {

// The model's effects on the thrusters in a log.
EffectStack<double> ThrusterEffects(const ExtendedModel& model, const std::string& log) {
  std::vector<StackedEffect<double>> effects;
  for (const ActiveEffect& active : model.effects) {
    if (active.effect->info().place != Place::kActuator || !active.setting.ActsIn(log)) continue;
    effects.push_back({&active.effect->law<double>(),
                       active.setting,
                       active.effect->info().has_partner(),
                       active.values});
  }
  return EffectStack<double>(std::move(effects));
}

}  // namespace

std::vector<double> MeanThrusterForces(const EffectInputs& inputs,
                                       const ExtendedModel& model,
                                       std::span<const double> times) {
  std::vector<double> forces;
  if (times.size() < 2) return forces;
  const EffectStack<double> effects = ThrusterEffects(model, inputs.log);
  Instants<double> instants(inputs, effects);
  const std::vector<double>& edges = inputs.command.time;
  double s = times.front() - instants.delay();  // on the command's clock
  ThrusterStates<double> thrust = ThrustBefore(s, inputs.command, effects, &instants);
  std::size_t next_edge = std::upper_bound(edges.begin(), edges.end(), s) - edges.begin();
  for (const double time : times.subspan(1)) {
    const double begin = s, end = time - instants.delay();
    double impulse = 0.0;
    while (s < end) {
      const bool reaches_edge = next_edge < edges.size() && edges[next_edge] <= end;
      const double duration = (reaches_edge ? edges[next_edge] : end) - s;
      const double command = next_edge > 0 ? inputs.command.value[next_edge - 1] : 0.0;
      instants.held_time = s + 0.5 * duration + instants.delay();
      impulse += duration * MeanForce(effects, command, s, duration, &instants, &thrust);
      s += duration;
      if (reaches_edge) s = edges[next_edge++];
    }
    forces.push_back(impulse / (end - begin));
  }
  return forces;
}

}  // namespace fathom
