// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/panel.h"

#include <string>
#include <vector>

namespace fathom {

// One panel as a figure with an SVG in it, which needs no script. What a logarithmic axis cannot
// show is left out.
std::string CurveChartHtml(const CurvePanel& panel);

// Panels beside each other; empty if there are none.
std::string CurveChartsHtml(const std::vector<CurvePanel>& panels);

}  // namespace fathom
