// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

#include <span>

namespace fathom {

// Fills the damping factors of one segment's samples, docs/residual_noise.md (3): how strongly the
// vehicle is damped over each interval between samples, as a multiple of the usual.
//
//   time       stamps along the motion [s], rising
//   damping    slope of the damping force over the speed there [kg/s] or [kg m^2/s], at least 0
//   usual      the same at a usual speed; not above 0: all factors stay 1
//
// The factor is that of the mean damping since the sample before, in steps of a quarter of an
// octave (so that there are few, 9 % off at most), within three octaves.
void SetDampingFactors(std::span<const double> time,
                       std::span<const double> damping,
                       double usual,
                       std::span<NoiseSample> samples);

}  // namespace fathom
