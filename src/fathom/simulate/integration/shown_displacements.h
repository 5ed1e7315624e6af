// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/integration/instants.h"
#include "fathom/simulate/integration/run_step.h"
#include "fathom/simulate/integration/scalar_model.h"

#include <cstddef>
#include <vector>

namespace fathom {

// What poses show of a run, from step to step.
template <typename T>
class ShownDisplacements {
 public:
  // All must outlive this. `stamps` in log time [s].
  ShownDisplacements(const ScalarModel<T>& model,
                     const std::vector<double>& stamps,
                     Instants<T>* instants)
      : model_(model),
        stamps_(stamps),
        instants_(*instants),
        pose_delay_(model.effects.PoseDelay()) {}

  // Whether all stamps were passed.
  bool empty() const { return row_ == stamps_.size(); }

  // Calls emit(row, displacement) at every stamp up to the end of `step`, the one after the last
  // given.
  template <typename Emit>
  void Pass(const RunStep<T>& step, const Emit& emit) {
    const T shift = instants_.delay() + pose_delay_;
    for (; row_ < stamps_.size(); ++row_) {
      const double stamp = stamps_[row_];
      if (stamp - Value(shift) > step.end + 1e-9) return;
      const T position = PositionWithin(step, T(stamp - shift - step.begin));
      const T displacement = model_.effects.Displacement(
          T(position - model_.initial_position), [&](std::size_t k) -> const Instant<T>& {
            return instants_.InLogTime(k, T(stamp - pose_delay_));
          });
      emit(row_, T(displacement + model_.initial_position));
    }
  }

 private:
  // `since` [s] the step's begin.
  T PositionWithin(const RunStep<T>& step, const T& since) const {
    const auto at = [&](const auto& x) {
      return Cubic(step.before.position,
                   step.before.velocity,
                   step.after.position,
                   step.after.velocity,
                   step.duration,
                   x);
    };
    if (Value(since) < 0.0) {  // before the start: as it was moving then
      return step.before.position + since * step.before.velocity;
    }
    if (instants_.moves_stamps()) return at(T(since / step.duration));
    if (Value(since) < Value(step.duration) - 1e-9) return at(Value(since) / Value(step.duration));
    return step.after.position;
  }

  const ScalarModel<T>& model_;
  const std::vector<double>& stamps_;
  Instants<T>& instants_;
  const T pose_delay_;  // of the poses' stamps [s]
  std::size_t row_ = 0;
};

}  // namespace fathom
