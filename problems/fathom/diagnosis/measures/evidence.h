// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"

#include <Eigen/Core>

namespace fathom {

// How far the data carry what is said of them.
struct Evidence {
  // Share of the motion below which no cause is looked for: finer than any sensor shows it, and
  // than the uncoupled model can be true. docs/diagnosis.md, "Verdict".
  static constexpr double kNegligible = 1e-3;

  double inertia = 0.0, inertia_std = 0.0;  // of the baseline [kg] or [kg m^2]

  // The baseline's residual over the motion: of the speed, and of the way made in a second. The
  // larger of the two.
  double share_left = 0.0;

  Tone command_tone = {};

  bool IsNegligible() const { return share_left < kNegligible; }
};

Evidence EvidenceOf(const TrainingData& data, const StructureFit& baseline);

// Whether a fit leaves less than Evidence::kNegligible: nothing that a sensor could show.
bool LeavesNothing(const TrainingData& data, const StructureFit& fit);

// RMS of a residual of the velocity (of the displacement where there is none) over what of it
// scatters from sample to sample.
double WanderRatio(const TrainingData& data, const Eigen::VectorXd& residual);

}  // namespace fathom
