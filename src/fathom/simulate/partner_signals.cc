// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/partner_signals.h"

#include <vector>

namespace fathom {
namespace {

// The last i with time[i] <= t, or 0: found from the last one found.
std::size_t PlaceOf(const std::vector<double>& time, double t, std::size_t place) {
  while (place > 0 && time[place] > t) --place;
  while (place + 1 < time.size() && time[place + 1] <= t) ++place;
  return place;
}

}  // namespace

SignalLine LineAt(const SampledSignal& signal, double t, std::size_t* place) {
  const std::vector<double>& time = signal.time;
  if (time.empty()) return {};
  *place = PlaceOf(time, t, *place);
  const std::size_t i = *place;
  if (t <= time.front() || i + 1 == time.size()) return {signal.value[i], 0.0};
  const double slope = (signal.value[i + 1] - signal.value[i]) / (time[i + 1] - time[i]);
  return {signal.value[i] + slope * (t - time[i]), slope};
}

PartnerSignals::PartnerSignals(const EffectInputs& inputs, const EffectSetting& setting)
    : velocity_(&inputs.velocity[Index(setting.partner)]),
      yaw_rate_(&inputs.velocity[Index(Dof::kYaw)]),
      force_(&inputs.force[Index(setting.partner)]) {}

double PartnerSignals::HeldAt(double t) {
  if (force_->time.empty() || t < force_->time.front()) return 0.0;
  force_place_ = PlaceOf(force_->time, t, force_place_);
  return force_->value[force_place_];
}

}  // namespace fathom
