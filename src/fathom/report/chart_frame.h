// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/parameter_chart.h"

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// One axis of a drawing: what it shows and how.
struct ChartAxis {
  ChartRange range;
  bool is_log = false;  // then the range lies above 0

  // Where a value stands, 0 at the beginning of the range and 1 at its end.
  double PlaceOf(double value) const;
};

// From the least to the largest value with a margin, of a logarithmic axis in the logarithm.
ChartAxis AxisOver(double least, double most, bool is_log = false);

// Powers of ten within the range, and where these are fewer than three twice and five times them;
// of many decades every second, third or further one.
std::vector<double> LogTicksOf(const ChartRange& range);

// "0.02", "100", and beyond a thousand either way "2·10⁻⁵", "10⁴".
std::string LogTickLabel(double tick);

// The drawing of a chart without script: an SVG with its axes. Lengths are in px.
struct ChartFrame {
  static constexpr double kWidth = 340.0, kHeight = 230.0;
  static constexpr double kLeft = 52.0, kRight = 6.0, kTop = 6.0, kBottom = 38.0;

  ChartAxis x, y;

  double Left(double value) const;
  double Top(double value) const;  // values outside of the range stand at its ends

  // The SVG up to its grid, with the name of x below it, then `content`.
  std::string Svg(std::string_view label,
                  std::string_view x_name,
                  const std::string& content) const;

  // A line through the points, and an area between two lines, as the `d` of a path.
  std::string PathOf(const std::vector<double>& at, const std::vector<double>& values) const;
  std::string AreaOf(const std::vector<double>& at,
                     const std::vector<double>& low,
                     const std::vector<double>& high) const;
};

// "force [N]"; the name alone of what has no unit.
std::string NameWithUnit(const std::string& name, const std::string& unit);

}  // namespace fathom
