// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/segment.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>
#include <span>

namespace fathom {

// The range of the measured speeds of `segments` and of the forces commanded meanwhile. Nothing if
// there is no finite speed.
std::optional<DataRange> RangeOf(std::span<const Segment> segments);

}  // namespace fathom
