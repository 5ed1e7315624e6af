// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/adaptive_follower.h"

#include <cstddef>
#include <vector>

namespace fathom {

// The estimates of a stream, evenly thinned: its memory does not grow with the stream.
class EstimateHistory {
 public:
  void Add(const FollowedEstimate& estimate);

  bool IsEmpty() const { return num_estimates_ == 0; }
  std::size_t num_estimates() const { return num_estimates_; }

  // Of the stream: the first one, then each stride()-th, and the last one. At most kMost + 1.
  std::vector<FollowedEstimate> Thinned() const;
  std::size_t stride() const { return stride_; }

  static constexpr std::size_t kMost = 4000;

 private:
  std::vector<FollowedEstimate> kept_;
  FollowedEstimate last_;
  std::size_t num_estimates_ = 0;
  std::size_t stride_ = 1;
};

}  // namespace fathom
