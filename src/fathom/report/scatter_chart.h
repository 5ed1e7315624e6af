// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/palette.h"
#include "fathom/report/panel.h"

#include <string>
#include <vector>

namespace fathom {

// The mean of what falls into one bin.
struct BinMean {
  double x = 0.0;       // mean of the bin's x
  double y = 0.0;       // mean of the bin's y
  double spread = 0.0;  // standard deviation of the bin's y
  int num_points = 0;
};

// Means over bins that hold equally many points, in the order of x; points of equal x stay in one
// bin. `num_bins` at most, and none of fewer than five points unless there are fewer in all. Pairs
// with a NaN are left out.
std::vector<BinMean> MeansByBins(const std::vector<double>& x,
                                 const std::vector<double>& y,
                                 int num_bins);

// Share of the variance of y that lies between the bins, 0 to 1: how far y follows x in any shape
// (the correlation ratio). NaN if nothing varies.
double ShareBetweenBins(const std::vector<double>& x, const std::vector<double>& y, int num_bins);

// One panel as a figure with an SVG in it, which needs no script. The mean has the colour of its
// y_name, the second mean that of its second_name, as curves over time have.
std::string ScatterChartHtml(const ScatterPanel& panel, Palette& palette);

// Panels beside each other, under one key; empty if there are none.
std::string ScatterChartsHtml(const std::vector<ScatterPanel>& panels, Palette& palette);

}  // namespace fathom
