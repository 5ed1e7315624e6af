// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect_stack.h"
#include "fathom/vehicle/uncoupled_model.h"

// A model and a state in one scalar, plain or with derivatives: what EffectRun works on.

namespace fathom {

inline double Value(double x) { return x; }
template <typename J>
double Value(const J& x) {
  return x.a;
}

template <typename T>
struct ScalarModel {
  UncoupledModel<T> baseline;
  EffectStack<T> effects;
  bool depends_on_time = false;  // any of the effects
  T initial_velocity{0.0};
  T initial_position{0.0};
  T initial_reading_excess{0.0};
  T initial_memory_excess{0.0};
};

}  // namespace fathom
