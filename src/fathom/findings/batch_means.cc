// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/batch_means.h"

#include <cmath>
#include <limits>

namespace fathom {

double ErrorOfMean(const Eigen::ArrayXd& values) {
  constexpr int kNumBatches = 16;
  const Eigen::Index n = values.size() / kNumBatches;
  if (n < 2) return std::numeric_limits<double>::infinity();
  Eigen::ArrayXd batches(kNumBatches);
  for (Eigen::Index k = 0; k < kNumBatches; ++k) batches[k] = values.segment(k * n, n).mean();
  return std::sqrt((batches - batches.mean()).square().sum() / (kNumBatches * (kNumBatches - 1.0)));
}

}  // namespace fathom
