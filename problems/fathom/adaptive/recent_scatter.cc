// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/recent_scatter.h"

#include "fathom/adaptive/usable_estimate.h"

#include <limits>
#include <utility>

#include <glog/logging.h>

namespace fathom {
namespace {

using Block = RecentScatter::Block;

Block WithEstimate(const Block& block, const ParameterVector& estimate) {
  const ParameterVector off = estimate - block.mean;
  Block more = {block.count + 1, block.mean, block.squares};
  more.mean += off / static_cast<double>(more.count);
  more.squares += off.cwiseProduct(estimate - more.mean);
  return more;
}

Block Joined(const Block& a, const Block& b) {
  const auto num_a = static_cast<double>(a.count), num_b = static_cast<double>(b.count);
  const ParameterVector off = b.mean - a.mean;
  return {a.count + b.count,
          a.mean + num_b / (num_a + num_b) * off,
          a.squares + b.squares + num_a * num_b / (num_a + num_b) * off.cwiseAbs2()};
}

std::vector<Block> JoinedInPairs(const std::vector<Block>& blocks) {
  std::vector<Block> joined;
  for (std::size_t k = 0; k + 1 < blocks.size(); k += 2) {
    joined.push_back(Joined(blocks[k], blocks[k + 1]));
  }
  return joined;
}

}  // namespace

static_assert(RecentScatter::kMostBlocks % 2 == 0, "Full blocks join in pairs.");

RecentScatter::RecentScatter(long block_size, std::vector<Block> blocks)
    : block_size_(block_size), blocks_(std::move(blocks)) {
  CHECK_GT(block_size_, 0);
  CHECK_LE(blocks_.size(), kMostBlocks);
}

void RecentScatter::Add(const ParameterVector& estimate) {
  if (blocks_.empty() || blocks_.back().count == block_size_) {
    if (blocks_.size() == kMostBlocks) {
      blocks_ = JoinedInPairs(blocks_);
      block_size_ *= 2;
    }
    blocks_.emplace_back();
  }
  blocks_.back() = WithEstimate(blocks_.back(), estimate);
}

ParameterVector RecentScatter::StdAbout(const ParameterVector& final) const {
  if (blocks_.empty()) {
    return ParameterVector::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  const long num_before_last = block_size_ * static_cast<long>(blocks_.size() - 1);
  const long num = num_before_last + blocks_.back().count;
  const auto begin = static_cast<long>(BeginOfLastPart(static_cast<std::size_t>(num)));
  const long first = (begin + (block_size_ - 1) / 2) / block_size_;  // the nearest block's
  ParameterVector sum = ParameterVector::Zero();
  double count = 0.0;
  for (auto k = static_cast<std::size_t>(first); k < blocks_.size(); ++k) {
    const auto of_block = static_cast<double>(blocks_[k].count);
    sum += of_block * (blocks_[k].mean - final).cwiseAbs2() + blocks_[k].squares;
    count += of_block;
  }
  return (sum / count).cwiseSqrt();
}

}  // namespace fathom
