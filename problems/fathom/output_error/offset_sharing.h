// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Whether several logs have one offset (the buoyancy), or each its own.
enum class OffsetScope { kShared, kPerLog };

// "shared", "per_log".
std::string_view Name(OffsetScope scope);

// Throws InputError, listing the names, in the form of ParseDof().
OffsetScope ParseOffsetScope(const std::string& name);

// Which offset (the buoyancy) acts in which segment: one in all, or, where the trim or the thrust's
// zero changes between logs, one per log. Inertia and dampings are the vehicle's in all.
struct OffsetSharing {
  std::vector<std::size_t>
      offset_of;  // by segment, numbered from 0 without a gap; empty: one in all

  bool IsOneInAll() const { return offset_of.empty(); }
  std::size_t At(std::size_t segment) const { return IsOneInAll() ? 0 : offset_of[segment]; }
  std::size_t Count() const {
    return IsOneInAll() ? 1 : 1 + *std::max_element(offset_of.begin(), offset_of.end());
  }
};

// One offset for each log. `log_of`: the index of each segment's log.
OffsetSharing OneOffsetPerLog(std::span<const std::size_t> log_of);

}  // namespace fathom
