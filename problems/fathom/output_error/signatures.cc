// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/signatures.h"

#include "fathom/output_error/reduced_normal.h"

#include <span>
#include <vector>

namespace fathom {
namespace {

// Derivatives by the parameters and the velocity at the start of a stretch, turned into those by
// the parameters and the velocity at the start of the segment; `start` is how the former velocity
// follows the latter ones.
Derivatives Chained(const Derivatives& by_stretch, const Derivatives& start) {
  Derivatives by_segment = by_stretch.col(kNumParameters) * start;
  by_segment.leftCols(kNumParameters) += by_stretch.leftCols(kNumParameters);
  return by_segment;
}

}  // namespace

StretchStart SegmentStart(const InitialState& state) {
  StretchStart start = {.state = state};
  start.v(kNumParameters) = 1.0;
  return start;
}

bool SimulateStretch(const UncoupledModel<double>& model,
                     const HeldCommand& command,
                     std::span<const double> time,
                     FittedOutput output,
                     StretchStart* start,
                     Stretch* stretch) {
  auto& [v, x, dv, dx] = *stretch;
  const bool is_velocity = output == FittedOutput::kVelocity;
  const size_t num_positions = is_velocity ? 0 : time.size();
  v.resize(time.size());
  x.resize(num_positions);
  dv.resize(static_cast<Eigen::Index>(time.size()), Simulation::kNumSensitivities);
  dx.resize(static_cast<Eigen::Index>(num_positions), Simulation::kNumSensitivities);
  if (!Simulation(command, time)
           .RunWithSensitivities(model,
                                 start->state,
                                 v,
                                 x,
                                 {dv.data(), time.size() * Simulation::kNumSensitivities},
                                 {dx.data(), num_positions * Simulation::kNumSensitivities})) {
    return false;
  }
  dx = Chained(dx, start->v).rowwise() + start->x.row(0);
  dv = Chained(dv, start->v);
  start->state = {v.back(), is_velocity ? 0.0 : x.back()};
  start->v = dv.bottomRows(1);
  if (!is_velocity) start->x = dx.bottomRows(1);
  return true;
}

void FillSamples(const UncoupledModel<double>& model,
                 const Segment& segment,
                 size_t begin,
                 size_t end,
                 FittedOutput output,
                 double sigma,
                 const Stretch& stretch,
                 Samples* samples) {
  auto& [J, residual] = *samples;
  const bool is_velocity = output == FittedOutput::kVelocity;
  const auto n = static_cast<Eigen::Index>(end - begin);
  const Derivatives& dy = is_velocity ? stretch.dv : stretch.dx;
  J.setOnes(n, kSharedColumns + StateSize(output));  // the last column: of the initial position
  J.leftCols(kNumParameters) = dy.topLeftCorner(n, kNumParameters);
  J.col(kSharedColumns) = dy.col(kNumParameters).head(n);
  residual.resize(n);
  const std::vector<double> force =
      segment.command.At(std::span(segment.time).subspan(begin, end - begin));
  for (Eigen::Index i = 0; i < n; ++i) {
    const size_t k = begin + i;
    const double v = stretch.v[i];
    // A command that comes later shifts the response: d y / d offset = -dy/dt.
    J(i, kNumParameters) = is_velocity ? -model.Acceleration(v, force[i]) : -v;
    residual[i] = is_velocity ? v - segment.velocity[k] : stretch.x[i] - segment.position[k];
  }
  J /= sigma;
  residual /= sigma;
}

}  // namespace fathom
