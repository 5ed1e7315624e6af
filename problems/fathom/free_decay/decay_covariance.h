// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/free_decay/decay_search.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The covariance of the rates at an optimum, docs/free_decay.md (4): A^-1 B A^-1 with residuals
// coloured like an autoregression of at most `max_order`, clipped at `clip`, or like white noise
// and noise that fades exponentially, by their restricted likelihood: whichever is wider. Rates
// that the data do not tell have infinite variances, those of `fixed` 0.
Eigen::Matrix4d DecayCovariance(std::span<const DecayStretch> stretches,
                                const DecayResiduals& residuals,
                                const std::vector<int>& fixed,
                                double clip,
                                int max_order);

}  // namespace fathom
