// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// A marker that from some time on is not where the map has it.
struct MovedMarker {
  int tag_id = -1;
  double time = 0.0;      // of the first frame that shows it elsewhere [s]
  double distance = 0.0;  // from its place in the map [m]
  double distance_std = 0.0;
  double angle = 0.0;  // it has turned by [rad]
};

}  // namespace fathom
