// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/vehicle/extended_model.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A model by linear regression of the momentum along the measured motion.
struct MomentumFit {
  ExtendedModel model;
  double squared_error = 0.0;  // of the velocity
  int num_samples = 0;
};

// The momentum along the measured motion: over pieces of a few seconds, each with a start of its
// own,
//
//   m v(t) = m v(0) + int f - d_Q int v|v| - d_L int v - b t        docs/diagnosis.md (3a)
//
// Biased by noise in v, so only where a search starts. But it is linear, and needs no model whose
// run is near the data: with a spring, or friction that holds the vehicle, there is no such
// baseline.
class MomentumBalance {
 public:
  // Pieces of 2 s: long ones average noise, short ones are right where the motion is quick against
  // them. `segments` must outlive this.
  explicit MomentumBalance(std::span<const MeasuredSegment> segments);

  // The baseline. Where no positive inertia comes of it (a spring carries most of the motion), an
  // inertia whose speed changes by as much as the forces push, and little damping; nothing if no
  // force ever acted.
  std::optional<MomentumFit> Fit() const;

  // The baseline and one effect, whose amounts (Search::kAmount) are fitted, from a probe that is
  // not their null; its other parameters stay. Nothing if no positive inertia comes of it, or if
  // HasForce() is false.
  std::optional<MomentumFit> FitWith(const ActiveEffect& effect) const;

  // True if all that an effect does is a force that the measured motion tells.
  static bool HasForce(const Effect& effect);

 private:
  // Measured, without a rest.
  struct Piece {
    const MeasuredSegment* segment = nullptr;
    std::vector<double> time, velocity, position;
  };
  std::vector<double> ForceOf(const Piece& piece, const ActiveEffect* effect) const;
  Eigen::MatrixXd ColumnsOf(const Piece& piece,
                            const ActiveEffect* base,
                            const ActiveEffect* probe,
                            std::span<const std::size_t> amounts) const;
  std::optional<MomentumFit> Solve(const ActiveEffect* effect) const;
  std::optional<MomentumFit> FitInertiaAlone() const;

  std::vector<Piece> pieces_;
};

}  // namespace fathom
