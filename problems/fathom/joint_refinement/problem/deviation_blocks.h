// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/joint_state.h"

#include <cstddef>
#include <vector>

namespace fathom {

// What Ceres moves of the deviations: the moving coordinates side by side.
struct DeviationBlocks {
  std::vector<std::vector<double>> deviation, rate;  // by segment; n numbers a frame

  void Load(const JointUnknowns& unknowns, const std::vector<int>& moving) {
    deviation.assign(unknowns.segments.size(), {});
    rate = deviation;
    for (size_t r = 0; r < unknowns.segments.size(); ++r) {
      for (size_t k = 0; k < unknowns.segments[r].deviation.size(); ++k) {
        for (const int i : moving) {
          deviation[r].push_back(unknowns.segments[r].deviation[k][i]);
          rate[r].push_back(unknowns.segments[r].rate[k][i]);
        }
      }
    }
  }

  void Store(const std::vector<int>& moving, JointUnknowns* unknowns) const {
    for (size_t r = 0; r < unknowns->segments.size(); ++r) {
      SegmentUnknowns& segment = unknowns->segments[r];
      for (size_t k = 0; k < segment.deviation.size(); ++k) {
        segment.deviation[k] = segment.rate[k] = {};
        for (size_t i = 0; i < moving.size(); ++i) {
          segment.deviation[k][moving[i]] = deviation[r][k * moving.size() + i];
          segment.rate[k][moving[i]] = rate[r][k * moving.size() + i];
        }
      }
    }
  }
};

}  // namespace fathom
