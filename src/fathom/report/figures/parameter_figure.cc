// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/chart_frame.h"
#include "fathom/report/figures/figure.h"
#include "fathom/report/figures/figure_style.h"
#include "fathom/report/figures/gnuplot.h"
#include "fathom/report/format_value.h"
#include "fathom/report/palette.h"
#include "fathom/report/parameter_chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

// The sizes of a parameter figure [px].
constexpr int kPlotWidth = 300;
constexpr int kValueMargin = 130;  // right of a plot, for values and intervals
constexpr int kLeastNameMargin = 130;
constexpr int kCharacterWidth = 7;  // at most, of a name in kFigureStyle's font
constexpr int kRowHeight = 26;
constexpr int kFrameHeight = 92;

struct Grid {
  int num_columns = 1;
  int num_rows = 1;
  int plot_height = 0;  // [px]
  int name_margin = 0;  // left of a plot, for the longest name of an estimate [px]

  int column_width() const { return name_margin + kPlotWidth + kValueMargin; }
  int width() const { return num_columns * column_width(); }
  int height() const { return num_rows * plot_height; }
};

Grid GridOf(const std::vector<ParameterPanel>& panels) {
  std::size_t most_estimates = 1, longest_name = 0;
  for (const ParameterPanel& panel : panels) {
    most_estimates = std::max(most_estimates, panel.estimates.size());
    for (const Estimate& estimate : panel.estimates) {
      longest_name = std::max(longest_name, estimate.name.size());
    }
  }
  Grid grid;
  grid.num_columns = panels.size() > 1 ? 2 : 1;
  grid.num_rows =
      std::max(1, (static_cast<int>(panels.size()) + grid.num_columns - 1) / grid.num_columns);
  grid.plot_height = kRowHeight * static_cast<int>(most_estimates) + kFrameHeight;
  grid.name_margin =
      std::max(kLeastNameMargin, kCharacterWidth * (static_cast<int>(longest_name) + 2));
  return grid;
}

// Margins, ranges and title of plot `i`.
std::string FrameCommands(const ParameterPanel& panel,
                          const ChartRange& range,
                          const Grid& grid,
                          std::size_t i) {
  const double left = static_cast<double>(i % grid.num_columns) / grid.num_columns;
  const double top = 1.0 - static_cast<double>(i / grid.num_columns) / grid.num_rows;
  const double x_unit = 1.0 / grid.width();
  const double y_unit = 1.0 / grid.height();
  std::string script = fmt::format(
      "unset label\nunset arrow\n"
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
      "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
      "set xrange [{:.12g}:{:.12g}]\nset yrange [{}:-0.6]\n",
      left + grid.name_margin * x_unit,
      left + (grid.name_margin + kPlotWidth) * x_unit,
      top - 45 * y_unit,
      top - (grid.plot_height - 40) * y_unit,
      range.from,
      range.to,
      static_cast<double>(panel.estimates.size()) - 0.4);
  return script + fmt::format("set label {} at graph 0, graph 1 offset 0,0.9 left\n",
                              GnuplotText(NameWithUnit(panel.name, panel.unit)));
}

std::string TickCommands(const ChartRange& range) {
  const std::vector<double> ticks = TicksOf(range);
  std::string labels;
  for (const double tick : ticks) {
    labels += fmt::format("{}{} {:.12g}",
                          labels.empty() ? "" : ", ",
                          GnuplotText(TickLabel(tick, ticks[1] - ticks[0])),
                          tick);
  }
  return "set xtics (" + labels + ")\n";
}

std::string ReferenceCommands(const ParameterPanel& panel) {
  if (!panel.reference) return "";
  return fmt::format(
      "set arrow from {0:.12g}, graph 0 to {0:.12g}, graph 1 nohead lw 1.2 dt (6,4) lc rgb "
      "'#444d5a' back\n"
      "set label {1} at graph 1, graph 1 offset 0,0.9 right textcolor rgb '#5d6776'\n",
      *panel.reference,
      GnuplotText(panel.reference_name + " " + FormatValue(*panel.reference)));
}

// An arrowhead at the edge, in row `k`, for an estimate beyond the range.
std::string BeyondRange(bool is_right, std::size_t k, const std::string& color) {
  return fmt::format("set label '{}' at graph {}, first {} {} textcolor rgb '{}'\n",
                     is_right ? "▶" : "◀",
                     is_right ? 1 : 0,
                     k,
                     is_right ? "right" : "left",
                     color);
}

// The estimates of plot `i`, each in a row of its own with its name, value and interval.
std::string EstimateCommands(const ParameterPanel& panel,
                             const ChartRange& range,
                             std::size_t i,
                             Palette* palette) {
  std::string labels;
  std::string names;
  std::string blocks;
  std::string plots = "plot NaN";
  for (std::size_t k = 0; k < panel.estimates.size(); ++k) {
    const Estimate& estimate = panel.estimates[k];
    const std::string color(palette->ColorOf(estimate.name));
    names += fmt::format("{}{} {}", k == 0 ? "" : ", ", GnuplotText(estimate.name), k);
    labels += fmt::format("set label {} at graph 1, first {} offset 1,0 left\n",
                          GnuplotText(FormatValue(estimate.value, estimate.std)),
                          k);
    if (!std::isfinite(estimate.value)) continue;
    if (estimate.value < range.from || estimate.value > range.to) {
      labels += BeyondRange(estimate.value > range.to, k, color);
      continue;
    }
    const ChartRange bar = BarOf(estimate, panel);
    blocks +=
        fmt::format("$estimate{}_{} << END_OF_DATA\n{:.12g} {} {:.12g} {:.12g}\nEND_OF_DATA\n",
                    i,
                    k,
                    estimate.value,
                    k,
                    std::max(bar.from, range.from),
                    std::min(bar.to, range.to));
    plots += fmt::format(
        ", $estimate{0}_{1} using 1:2:3:4 with xerrorbars pt 7 ps 0.9 lw 2.4 lc rgb '{2}'",
        i,
        k,
        color);
  }
  return labels + "set ytics (" + names + ") scale 0 textcolor rgb '#1b2330'\n" + blocks + plots +
         "\n";
}

}  // namespace

void WriteFigure(const std::vector<ParameterPanel>& panels, const std::filesystem::path& path) {
  const Grid grid = GridOf(panels);
  Palette palette;
  std::string script(kFigureStyle);
  script += "set border 1\nunset key\nset multiplot\nset grid noytics\nset errorbars 0\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const ChartRange range = RangeOf(panels[i]);
    script += FrameCommands(panels[i], range, grid, i) + TickCommands(range) +
              ReferenceCommands(panels[i]) + EstimateCommands(panels[i], range, i, &palette);
  }
  script += "unset multiplot\n";
  DrawWithGnuplot(script, grid.width(), grid.height(), path);
}

}  // namespace fathom
