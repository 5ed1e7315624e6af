// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/comparison.h"

#include <utility>
#include <vector>

#include "handmade_identification.h"

namespace fathom {

// Trained on 100 s to 103 s and 150 s to 152 s, held out from 104 s to 106 s.
inline DofComparison HandmadeDof(std::vector<Identification> rows) {
  DofComparison comparison;
  comparison.dof = Dof::kSurge;
  comparison.scored.force_unit = "N";
  comparison.scored.train = {SegmentAtRest(100.0, 31), SegmentAtRest(150.0, 21)};
  comparison.scored.held_out = {SegmentAtRest(104.0, 21)};
  comparison.rows = std::move(rows);
  return comparison;
}

}  // namespace fathom
