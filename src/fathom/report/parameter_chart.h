// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/palette.h"
#include "fathom/report/panel.h"

#include <string>
#include <vector>

namespace fathom {

// The stretch of numbers that a chart of estimates shows.
struct ChartRange {
  double from = 0.0;
  double to = 1.0;
};

// The 95 % interval of an estimate as a bar shows it: between the bounds of the panel, unless the
// estimate lies beyond them. Without a finite deviation it is the estimate alone.
ChartRange BarOf(const Estimate& estimate, const ParameterPanel& panel);

// Holds every estimate, its interval and the reference, with a margin. An estimate or an end of an
// interval that lies absurdly far from the others (over 25 times as far as is usual among them) is
// left outside, so that one diverged fit does not squeeze the rest into a point.
ChartRange RangeOf(const ParameterPanel& panel);

// Round numbers inside the range, two to six of them, equally spaced.
std::vector<double> TicksOf(const ChartRange& range);

// A tick as its label shows it, given the distance between ticks.
std::string TickLabel(double tick, double step);

// Dots and bars as HTML that needs no script: the places are percentages.
std::string ParameterChartHtml(const ParameterPanel& panel, Palette& palette);

}  // namespace fathom
