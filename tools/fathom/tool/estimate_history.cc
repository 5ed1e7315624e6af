// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/estimate_history.h"

namespace fathom {

void EstimateHistory::Add(const FollowedEstimate& estimate) {
  last_ = estimate;
  if (num_estimates_++ % stride_ != 0) return;
  kept_.push_back(estimate);
  if (kept_.size() < kMost) return;
  // Every second one goes, here and from now on.
  for (std::size_t k = 0; 2 * k < kept_.size(); ++k) kept_[k] = kept_[2 * k];
  kept_.resize((kept_.size() + 1) / 2);
  stride_ *= 2;
}

std::vector<FollowedEstimate> EstimateHistory::Thinned() const {
  std::vector<FollowedEstimate> estimates = kept_;
  if (!IsEmpty() && estimates.back().t < last_.t) estimates.push_back(last_);
  return estimates;
}

}  // namespace fathom
