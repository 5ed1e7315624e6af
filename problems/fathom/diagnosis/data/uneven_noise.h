// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

namespace fathom {

// The variance of each sample's white noise over its median, where that changes over the segment by
// more than four to one (between its tenth and its ninth decile), as that of poses does with the
// distance to the marker; otherwise empty: all alike. Powers of two from 2^-12 to 2^12.
//
// From the fourth differences within 61 samples, by their median size: what is smooth over five
// samples leaves nothing in them, single wild samples and steps little. Differences across a gap
// (a step of over twice the usual) are left out. `time` [s], not decreasing.
std::vector<double> VarianceOverUsual(std::span<const double> time, std::span<const double> values);

}  // namespace fathom
