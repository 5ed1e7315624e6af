// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/integration/scalar_model.h"
#include "fathom/simulate/partner_signals.h"
#include "fathom/vehicle/effect_stack.h"
#include "fathom/vehicle/extended_model.h"

#include <array>
#include <cstddef>

namespace fathom {

// What the effects of a run are told of an instant: the time since the first command, and what was
// measured of their partners. Numbers with derivatives are large: each is made in its place.
template <typename T>
class Instants {
 public:
  // Both must outlive this.
  Instants(const EffectInputs& inputs, const EffectStack<T>& effects)
      : time_zero_(inputs.command.time.empty() ? 0.0 : inputs.command.time.front()),
        delay_(effects.Delay()),
        moves_stamps_(effects.Has(&EffectLaw<T>::delay) || effects.Has(&EffectLaw<T>::pose_delay)) {
    for (std::size_t k = 0; k < effects.size(); ++k) {
      if (effects[k].has_partner) partners_[k] = PartnerSignals(inputs, effects[k].setting);
    }
  }

  // Whether outputs move against the steps.
  bool moves_stamps() const { return moves_stamps_; }

  // Of the command [s]: log time less this is the time on its clock.
  const T& delay() const { return delay_; }

  // When partners' commands are looked up, in log time [s]: one for each step of a run, so that it
  // sees one command.
  double held_time = 0.0;

  // Of effect `k` at `t` in log time [s].
  const Instant<T>& InLogTime(std::size_t k, const T& t) {
    now_[k].time = t - time_zero_;
    if (!partners_[k].empty()) now_[k].partner = partners_[k].At(t, Value(t), held_time);
    return now_[k];
  }

  // The same at `s` on the command's clock [s].
  const Instant<T>& OnCommandClock(std::size_t k, const T& s) {
    return moves_stamps_ ? InLogTime(k, T(s + delay_)) : InLogTime(k, s);
  }

 private:
  double time_zero_;  // of the effects' time, in log time [s]
  T delay_;
  bool moves_stamps_;
  std::array<PartnerSignals, kMostEffects> partners_;
  std::array<Instant<T>, kMostEffects> now_;
};

}  // namespace fathom
