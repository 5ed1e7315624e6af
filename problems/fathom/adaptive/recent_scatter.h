// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/parameters.h"

#include <cstddef>
#include <vector>

namespace fathom {

// The scatter of a stream of estimates over the last third of all that came, without keeping them
// all.
//
// Consecutive estimates stand together in blocks, of which there are at most kMostBlocks: once they
// are full, each two become one. Up to kMostBlocks estimates a block is one estimate, and the
// result is exact; later the third begins at the block whose middle is nearest, so at most n /
// kMostBlocks estimates beside it.
class RecentScatter {
 public:
  static constexpr std::size_t kMostBlocks = 512;

  struct Block {
    long count = 0;                                     // of estimates, above 0
    ParameterVector mean = ParameterVector::Zero();     // of them
    ParameterVector squares = ParameterVector::Zero();  // sum of (estimate - mean)^2
  };

  RecentScatter() = default;

  // As another one was: its blocks, each of `block_size` estimates but for the last one, which has
  // at most that many.
  RecentScatter(long block_size, std::vector<Block> blocks);

  void Add(const ParameterVector& estimate);

  // Square root of the mean of (estimate - final)^2 over the last third; NaN before the first one.
  ParameterVector StdAbout(const ParameterVector& final) const;

  long block_size() const { return block_size_; }
  const std::vector<Block>& blocks() const { return blocks_; }

 private:
  long block_size_ = 1;
  std::vector<Block> blocks_;
};

}  // namespace fathom
