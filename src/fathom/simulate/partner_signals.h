// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/held_command.h"
#include "fathom/log/sampled_signal.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/vehicle/effect_law.h"

#include <cstddef>

namespace fathom {

// A signal and its slope at `t` [s], in line between its samples and level beyond; 0 without any.
// `place`: where it was found the last time, to be found sooner.
struct SignalLine {
  double value = 0.0;
  double slope = 0.0;
};
SignalLine LineAt(const SampledSignal& signal, double t, std::size_t* place);

// What an effect sees of its partner, looked up at times that mostly increase. Without a partner's
// streams: nothing, and all zero.
class PartnerSignals {
 public:
  PartnerSignals() = default;
  PartnerSignals(const EffectInputs& inputs, const EffectSetting& setting);

  bool empty() const { return velocity_ == nullptr; }

  // `t` in log time [s], with `plain_t` its plain value. The partner's command is the one held at
  // `held_t`, so that one step sees one command.
  template <typename T>
  PartnerReading<T> At(const T& t, double plain_t, double held_t) {
    const SignalLine velocity = LineAt(*velocity_, plain_t, &velocity_place_);
    const SignalLine yaw_rate = LineAt(*yaw_rate_, plain_t, &yaw_rate_place_);
    return {velocity.value + velocity.slope * (t - plain_t),
            yaw_rate.value + yaw_rate.slope * (t - plain_t),
            T(HeldAt(held_t))};
  }

 private:
  double HeldAt(double t);

  const SampledSignal* velocity_ = nullptr;
  const SampledSignal* yaw_rate_ = nullptr;
  const HeldCommand* force_ = nullptr;
  std::size_t velocity_place_ = 0, yaw_rate_place_ = 0, force_place_ = 0;
};

}  // namespace fathom
