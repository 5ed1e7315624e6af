// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/signal/segment.h"

#include <optional>
#include <span>

namespace fathom {

// Pulse widths of a motor controller, which stops at about 1500 us, in place of forces: the warning
// `pulse_widths` if every command lies within 800 to 2200. The buoyancy of a model would take the
// 1500 in. Forces come near 0 or change their sign.
std::optional<Finding> CheckPulseWidths(std::span<const Segment> segments);

}  // namespace fathom
