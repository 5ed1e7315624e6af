// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace fathom {

// Counts the samples of a channel and keeps their smallest and largest stamp.
class ChannelStamps {
 public:
  // NaN: a sample without a stamp.
  void Add(double time) {
    ++count_;
    if (std::isnan(time)) return;
    first_ = std::min(first_, time);
    last_ = std::max(last_, time);
  }

  // The samples of another part of the channel.
  void Add(const ChannelStamps& other) {
    count_ += other.count_;
    first_ = std::min(first_, other.first_);
    last_ = std::max(last_, other.last_);
  }

  void WriteTo(Channel* channel) const {
    channel->count = count_;
    if (first_ > last_) return;
    channel->first = first_;
    channel->last = last_;
  }

 private:
  std::uint64_t count_ = 0;
  double first_ = std::numeric_limits<double>::infinity();
  double last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace fathom
