// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/signals.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/parameters.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace ceres {
class CostFunction;
}

namespace fathom {

// What the simulation is compared with. The position is used where poses are the measurement: no
// derivative then stands between data and model.
enum class FittedOutput { kVelocity, kPosition };

// The parameters that all logs share as the search carries them: the logarithm of the inertia,
// which keeps it positive, and both dampings. The last parameter, the buoyancy, has a block of its
// own: an offset may belong to a log.
static_assert(kBuoyancy == kNumParameters - 1);
using VehicleBlock = std::array<double, kBuoyancy>;
VehicleBlock BlockOf(const UncoupledModel<double>& model);
UncoupledModel<double> ModelOf(const double* vehicle, double buoyancy);

// Length of the state block: the initial velocity, and the initial position where it is observed.
constexpr int StateSize(FittedOutput output) { return output == FittedOutput::kVelocity ? 1 : 2; }

// Memory for one simulation with its derivatives, reused from window to window.
struct SimulationScratch {
  std::vector<double> velocity, position;
  std::vector<double> velocity_sensitivity, position_sensitivity;
};

// One stretch of a segment, simulated from a free initial state.
struct ShootingWindow {
  const Segment* segment = nullptr;
  size_t begin = 0;  // index of its first sample
  size_t end = 0;    // one past its last
  FittedOutput output = FittedOutput::kVelocity;
  std::size_t offset = 0;  // which of WindowUnknowns::offsets acts in it

  // Standard deviation of the measurement [unit of the output], and from how many of them on a
  // residual counts linearly (infinite: never).
  double sigma = 1.0;
  double huber_k = std::numeric_limits<double>::infinity();

  // Above 0: the simulation runs on to the next window's first sample, and what it misses that
  // window's initial state by is a residual with this standard deviation (of the velocity [m/s]; of
  // the position it is this times one second).
  double continuity_sigma = 0.0;
};

// The window's residuals, whitened: one per sample, (simulated - measured) / sigma made robust
// (docs/output_error.md (2), (3)), then the misses at the end, if any (4).
//
// The samples' residuals r and their Jacobian J reach Ceres as an orthogonal transformation of them
// with as many rows as J has columns and one more: R and q with R'R = J'J and R'q = J'r, and what
// no parameter can change, sqrt(r'r - q'q). Cost, gradient and Gauss-Newton matrix are the same,
// and memory does not grow with the log (docs/output_error.md (9)).
//
// Parameter blocks: the VehicleBlock, the buoyancy, the window's initial state, and with
// continuity_sigma > 0 the next window's. Evaluation fails (returns false) where the simulation
// diverges. `window.segment` must outlive the result. Not for several threads at once: windows made
// with the same `scratch` share it.
std::unique_ptr<ceres::CostFunction> MakeWindowCost(const ShootingWindow& window,
                                                    std::shared_ptr<SimulationScratch> scratch);

// The window's residuals sample by sample, simulated - measured [unit of the output]; empty if the
// simulation diverges.
std::vector<double> WindowMisses(const ShootingWindow& window,
                                 const UncoupledModel<double>& model,
                                 const InitialState& state);

}  // namespace fathom
