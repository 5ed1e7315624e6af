// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Simulates a thrust step, then identifies the model from what the simulation gave. Returns 0 if
// both are right.

#include "fathom/output_error/output_error.h"
#include "fathom/signal/signals.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <cmath>
#include <cstdio>

int main() {
  const fathom::UncoupledModel<double> truth = {
      .inertia = 20.0, .quadratic_damping = 30.0, .linear_damping = 5.0, .buoyancy = 0.0};
  fathom::Segment segment;
  for (int i = 0; i <= 400; ++i) segment.time.push_back(0.1 * i);
  segment.command = {.time = {0.0, 15.0, 25.0}, .value = {12.0, -7.0, 3.0}};
  segment.velocity.resize(segment.time.size());
  const fathom::Simulation simulation(segment.command, segment.time);
  if (!simulation.Run(truth, {}, segment.velocity, {})) {
    std::puts("The simulation diverged.");
    return 1;
  }

  // At 15 s drag and thrust balance but for exp(-15 s / 0.5 s): d_Q v^2 + d_L v = tau.
  const double top_speed = (-5.0 + std::sqrt(5.0 * 5.0 + 4.0 * 30.0 * 12.0)) / (2.0 * 30.0);
  if (!(std::abs(segment.velocity[150] - top_speed) < 1e-6)) {
    std::printf("Top speed is %.9f, expected %.9f m/s.\n", segment.velocity[150], top_speed);
    return 1;
  }

  const auto summary = fathom::FitOutputError({&segment, 1});
  if (!summary.IsUsable() || !(std::abs(summary.model.inertia - truth.inertia) < 1e-3)) {
    std::printf("Inertia is %.9f, expected %.9f kg. %s\n",
                summary.model.inertia,
                truth.inertia,
                summary.message.c_str());
    return 1;
  }
  return 0;
}
