// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/line_svg.h"

#include <fmt/format.h>

namespace fathom {

std::string LineSvg(std::string_view kind, double x1, double y1, double x2, double y2) {
  return fmt::format(R"(<line class="{}" x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>)",
                     kind,
                     x1,
                     y1,
                     x2,
                     y2);
}

}  // namespace fathom
