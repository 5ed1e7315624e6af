// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/axis_sines.h"

#include "fathom/coupled_planning/kept_wrench.h"
#include "fathom/coupled_planning/wrench_run.h"
#include "fathom/planning/ordinary_sine.h"

#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

constexpr int kSineShares = 20;

CoupledCommand SinesOf(const std::vector<WrenchAxis>& axes,
                       const std::vector<double>& amplitude,
                       double hold,
                       double duration) {
  const double each = duration / static_cast<double>(axes.size());
  CoupledCommand command;
  for (int i = 0; i * hold < duration - 1e-9; ++i) {
    const double t = i * hold;
    Vector6 force = Vector6::Zero();
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const double since = t - static_cast<double>(k) * each;
      const bool is_driven = since >= 0.0 && since < each;
      force[Index(axes[k].dof)] =
          axes[k].holding + (is_driven ? amplitude[k] * std::sin(kSineFrequency * since) : 0.0);
    }
    command.time.push_back(t);
    command.force.push_back(force);
  }
  return command;
}

}  // namespace

AxisSines LargestAxisSines(const CoupledModel& model,
                           const std::vector<WrenchAxis>& axes,
                           const CoupledLimits& limits,
                           const std::optional<WrenchAllocation>& thrusters,
                           double duration) {
  AxisSines sines;
  sines.amplitude.assign(axes.size(), 0.0);
  const double hold = limits.shortest_hold;
  const std::vector<double> stamps = WrenchLimitStamps(limits.shortest_hold, duration);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    for (int share = kSineShares; share >= 0; --share) {
      sines.amplitude[k] = (axes[k].force - std::abs(axes[k].holding)) * share / kSineShares;
      const CoupledCommand command = SinesOf(axes, sines.amplitude, hold, duration);
      if (thrusters && !thrusters->Gives(command)) continue;
      const auto run = WrenchMotion(model, command, stamps);
      if (run && KeepsLimits(*run, limits)) break;
    }
  }
  sines.command = SinesOf(axes, sines.amplitude, hold, duration);
  return sines;
}

}  // namespace fathom
