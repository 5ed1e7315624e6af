// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/uncoupled_model.h"

#include <cstddef>
#include <string>

namespace fathom {

// Index of the first of `num_samples` samples that the scatter of an estimate is taken over: the
// last third of the pass; docs/adaptive.md, "Intervals".
std::size_t BeginOfLastPart(std::size_t num_samples);

// Why an estimate of the adaptive law means nothing, a sentence; empty if it can be used. Either
// alpha stayed at its lower bound, or the inertia scatters by more than half its value:
// `inertia_std` [kg] or [kg m^2], over the last part of the pass.
std::string WhyUnusable(const UncoupledModel<double>& model, double inertia_std);

}  // namespace fathom
