// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/panel.h"

#include <string>

namespace fathom {

// One panel as a figure with an SVG in it, which needs no script. Its height follows from what it
// shows. Points with a NaN are left out.
std::string PlanChartHtml(const PlanPanel& panel);

}  // namespace fathom
