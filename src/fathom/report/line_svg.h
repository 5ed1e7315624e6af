// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// A straight line of a drawing from one point to another [px]. `kind`: its class in the page's
// style, such as "grid".
std::string LineSvg(std::string_view kind, double x1, double y1, double x2, double y2);

}  // namespace fathom
