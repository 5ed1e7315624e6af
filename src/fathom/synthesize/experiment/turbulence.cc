// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/turbulence.h"

#include "fathom/synthesize/experiment/correlated_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glog/logging.h>

namespace fathom {

Turbulence::Turbulence(const TurbulenceSpec& spec, double duration, RandomStream random)
    : step_(spec.correlation_time / kStepsPerCorrelationTime) {
  CHECK_GT(spec.correlation_time, 0.0);
  if (spec.force == 0.0) return;
  CorrelatedNoise noise(random, std::exp(-1.0 / kStepsPerCorrelationTime));
  const auto num_points = static_cast<std::size_t>(std::ceil(duration / step_)) + 2;
  force_.reserve(num_points);
  for (std::size_t k = 0; k < num_points; ++k) force_.push_back(spec.force * noise.Next());
}

double Turbulence::At(double t) const {
  const double place = std::clamp(t / step_, 0.0, static_cast<double>(force_.size() - 2));
  const auto k = static_cast<std::size_t>(place);
  return force_[k] + (t / step_ - static_cast<double>(k)) * (force_[k + 1] - force_[k]);
}

}  // namespace fathom
