// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/shooting_window.h"
#include "fathom/simulate/simulate.h"

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A segment is simulated a stretch at a time, so that memory does not grow with the log.

// By the parameters and the velocity at the segment's start.
using Derivatives =
    Eigen::Matrix<double, Eigen::Dynamic, Simulation::kNumSensitivities, Eigen::RowMajor>;

// The state at the start of a stretch, and its derivatives.
struct StretchStart {
  InitialState state;
  Derivatives v = Derivatives::Zero(1, Simulation::kNumSensitivities);
  Derivatives x = Derivatives::Zero(1, Simulation::kNumSensitivities);
};

// At the segment's own start.
StretchStart SegmentStart(const InitialState& state);

// The simulated stretch. Positions only where they are the output.
struct Stretch {
  std::vector<double> v, x;
  Derivatives dv, dx;
};

// Simulates a stretch, at the stamps `time`, and moves its start to the last of them. False if the
// simulation diverges.
bool SimulateStretch(const UncoupledModel<double>& model,
                     const HeldCommand& command,
                     std::span<const double> time,
                     FittedOutput output,
                     StretchStart* start,
                     Stretch* stretch);

// Signatures and residuals of samples, both in units of sigma. Columns of J: the parameters, a time
// offset of the command, the initial state.
struct Samples {
  Eigen::MatrixXd J;
  Eigen::ArrayXd residual;
};

// Of the segment's samples `begin` to `end` - 1, which `stretch` begins with.
void FillSamples(const UncoupledModel<double>& model,
                 const Segment& segment,
                 std::size_t begin,
                 std::size_t end,
                 FittedOutput output,
                 double sigma,
                 const Stretch& stretch,
                 Samples* samples);

}  // namespace fathom
