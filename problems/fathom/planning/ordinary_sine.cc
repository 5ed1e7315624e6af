// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/ordinary_sine.h"

#include "fathom/planning/kept_limits.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

constexpr int kNumShares = 20;  // of an amplitude, that are tried

HeldCommand SineCommand(double offset, double amplitude, double hold, double duration) {
  HeldCommand command;
  for (int i = 0; i * hold < duration - 1e-9; ++i) {
    command.time.push_back(i * hold);
    command.value.push_back(offset + amplitude * std::sin(kSineFrequency * i * hold));
  }
  return command;
}

}  // namespace

OrdinarySine LargestOrdinarySine(const PlanRequest& request,
                                 double duration,
                                 std::span<const double> stamps) {
  const PlanLimits& limits = request.limits;
  OrdinarySine sine;
  sine.offset = std::clamp(request.model.model.buoyancy, -0.5 * limits.force, 0.5 * limits.force);
  const double greatest = limits.force - std::abs(sine.offset);
  for (double scale = greatest; scale > 1e-6 * greatest; scale /= kNumShares) {
    for (int share = kNumShares; share >= 1; --share) {
      sine.amplitude = scale * share / kNumShares;
      sine.command = SineCommand(sine.offset, sine.amplitude, limits.shortest_hold, duration);
      const auto motion =
          MotionUnder(request.model.Extended(), request.model.dof, sine.command, stamps);
      if (motion && KeepsLimits(*motion, limits)) return sine;
    }
  }
  return sine;
}

HeldCommand SineOfLog(const PlanRequest& request, double duration) {
  constexpr double kPeriod = 0.1;  // of the command [s]
  const double force = request.limits.force;
  const ValueRange range =
      request.model.range ? request.model.range->force : ValueRange{-force, force};
  return SineCommand(
      0.5 * (range.low + range.high), 0.5 * (range.high - range.low), kPeriod, duration);
}

}  // namespace fathom
