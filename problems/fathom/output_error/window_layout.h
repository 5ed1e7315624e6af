// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/options.h"
#include "fathom/output_error/shooting_window.h"
#include "fathom/signal/segment.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

// Every segment in windows of about equal duration, at most options.shooting_window. The windows
// point into `segments`.
std::vector<ShootingWindow> LayOutWindows(std::span<const Segment> segments,
                                          const OutputErrorOptions& options);

// True if the window after `index` continues the same segment.
bool Continues(const std::vector<ShootingWindow>& windows, std::size_t index);

}  // namespace fathom
