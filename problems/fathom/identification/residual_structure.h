// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"
#include "fathom/signal/filters/autocorrelation.h"
#include "fathom/signal/filters/spectrum.h"
#include "fathom/signal/signals.h"
#include "fathom/vehicle/extended_model.h"

#include <optional>

namespace fathom {

// What the free runs of a model leave of the measured velocity, over training and held-out data
// together: docs/comparison.md.
struct ResidualStructure {
  Autocorrelation autocorrelation;  // up to 30 s; empty if there is nothing to compute it from
  Spectrum spectrum;                // the same

  // Where the command has 90 % of its power, without the 5 % at either end [Hz]. Nothing of a
  // command that never changes.
  std::optional<TimeInterval> excited;
};

// A segment whose run diverges is left out.
ResidualStructure StructureOfResidual(const ExtendedModel& model, const Signals& scored);

// Share of the lags at which the autocorrelation is outside of its bounds; white noise has 0.05.
double ShareOutside(const Autocorrelation& autocorrelation);

// Shares of the power below, within and above a band.
struct PowerShares {
  double below = 0.0, within = 0.0, above = 0.0;
};
PowerShares SharesAbout(const TimeInterval& band, const Spectrum& spectrum);

// The share within that white noise would have.
double WhiteShareWithin(const TimeInterval& band, const Spectrum& spectrum);

}  // namespace fathom
