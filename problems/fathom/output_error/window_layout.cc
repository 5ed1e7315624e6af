// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/window_layout.h"

#include <algorithm>
#include <cmath>

namespace fathom {

std::vector<ShootingWindow> LayOutWindows(std::span<const Segment> segments,
                                          const OutputErrorOptions& options) {
  std::vector<ShootingWindow> windows;
  for (size_t s = 0; s < segments.size(); ++s) {
    const Segment& segment = segments[s];
    const double duration = segment.time.back() - segment.time.front();
    const double num_windows = std::clamp(std::ceil(duration / options.shooting_window),
                                          1.0,
                                          static_cast<double>(segment.time.size()));
    size_t begin = 0;
    for (int k = 1; k <= num_windows; ++k) {
      const double t_end = segment.time.front() + duration * k / num_windows;
      size_t end = segment.time.size();
      if (k < num_windows) {
        end = std::lower_bound(segment.time.begin(), segment.time.end(), t_end) -
              segment.time.begin();
      }
      if (end <= begin) continue;  // a gap as long as a window
      windows.push_back({.segment = &segment,
                         .begin = begin,
                         .end = end,
                         .output = options.output,
                         .offset = options.offsets.At(s)});
      begin = end;
    }
  }
  return windows;
}

bool Continues(const std::vector<ShootingWindow>& windows, size_t index) {
  return index + 1 < windows.size() && windows[index + 1].segment == windows[index].segment;
}

}  // namespace fathom
