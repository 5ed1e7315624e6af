// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/force_along_run.h"

#include "fathom/simulate/partner_signals.h"

namespace fathom {

bool IsForceInWater(const Effect& effect) {
  const EffectLaw<double>& law = effect.law<double>();
  return law.resistance && !law.memory_rate && !law.relative_speed;
}

std::vector<double> ForceAlong(std::span<const RunPoint> points,
                               std::span<const MeasuredSegment> segments,
                               const UncoupledModel<double>& baseline,
                               const ActiveEffect& active) {
  std::vector<double> force;
  force.reserve(points.size());
  PartnerSignals partner;
  int segment = -1;
  double time_zero = 0.0;
  bool acts = true;
  for (const RunPoint& point : points) {
    if (point.segment != segment) {
      segment = point.segment;
      acts = active.setting.ActsIn(segments[segment].log);
      const EffectInputs& inputs = *segments[segment].inputs;
      if (active.effect->info().has_partner()) partner = PartnerSignals(inputs, active.setting);
      time_zero = inputs.command.time.front();
    }
    if (!acts) {
      force.push_back(0.0);
      continue;
    }
    Instant<double> now;
    now.time = point.time - time_zero;
    if (!partner.empty()) now.partner = partner.At(point.time, point.time, point.time);
    if (active.setting.dof == Dof::kYaw) now.partner.yaw_rate = point.velocity;
    const WaterState<double> water = {point.velocity,
                                      point.velocity,
                                      point.position,
                                      point.velocity,
                                      baseline.quadratic_damping,
                                      baseline.linear_damping};
    force.push_back(-active.effect->law<double>().resistance(active.values.data(), water, now));
  }
  return force;
}

}  // namespace fathom
