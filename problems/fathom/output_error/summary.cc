// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/summary.h"

#include <cmath>
#include <utility>

namespace fathom {

std::vector<UncoupledModel<double>> OutputErrorSummary::ModelsIn(
    std::size_t num_segments, const OffsetSharing& sharing) const {
  std::vector<UncoupledModel<double>> models(num_segments, model);
  for (std::size_t s = 0; s < num_segments; ++s) models[s].buoyancy = offsets[sharing.At(s)].value;
  return models;
}

void OutputErrorSummary::Take(ParameterEvidence found) {
  evidence = std::move(found);
  covariance = evidence.covariance;
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    offsets[k].std = std::sqrt(evidence.offset_variance[static_cast<Eigen::Index>(k)]);
  }
}

}  // namespace fathom
