// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/marker_trajectory/bundle/bundle_corners.h"

namespace fathom {

// What the corners tell about the poses of `end`, the bundle at the end of its adjustment: the
// noise of the corners, the frames' rms and the covariances; docs/marker_trajectory.md (1). Says in
// the message what they do not determine; otherwise the summary becomes usable.
void SetCovariances(const Bundle& end, BundleAdjustmentSummary* summary);

}  // namespace fathom
