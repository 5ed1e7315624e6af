// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/chart_frame.h"
#include "fathom/report/figures/figure.h"
#include "fathom/report/figures/figure_style.h"
#include "fathom/report/figures/gnuplot.h"
#include "fathom/report/palette.h"
#include "fathom/report/thinning.h"
#include "fathom/report/time_chart_json.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

// A curve to draw: columns 1 and 2 of a data block.
struct Curve {
  std::string name;
  std::string color;
  double width = 1.0;
  std::vector<double> values;
};

// The points of a curve; an empty line stands for a gap and breaks the line.
std::string DataBlock(const std::string& name,
                      const std::vector<double>& time,
                      const std::vector<double>& values,
                      const std::vector<std::size_t>& indices) {
  std::string text = "$" + name + " << END_OF_DATA\n";
  for (const std::size_t i : indices) {
    text += std::isfinite(values[i]) ? fmt::format("{:.12g} {:.9g}\n", time[i], values[i]) : "\n";
  }
  return text + "END_OF_DATA\n";
}

// Data blocks and the plot command of one plot. A curve without any finite value, which gnuplot
// refuses, is left out of the plot but not of the key.
std::string PlotCommand(const std::string& prefix,
                        const TimePanel& panel,
                        const std::vector<Curve>& curves,
                        bool has_key) {
  std::vector<std::vector<double>> values;
  for (const Curve& curve : curves) values.push_back(curve.values);
  const auto indices = ThinnedIndices(values, panel.time.size(), kMostStamps);

  std::string blocks;
  std::string plots;
  bool has_points = false;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve& curve = curves[i];
    const bool is_empty =
        std::ranges::none_of(curve.values, [](double v) { return std::isfinite(v); });
    const std::string block = fmt::format("{}{}", prefix, i);
    if (!is_empty) blocks += DataBlock(block, panel.time, curve.values, indices);
    has_points = has_points || !is_empty;
    plots += fmt::format("{} {} with {} lw {} lc rgb '{}' {}",
                         plots.empty() ? "plot" : ",",
                         is_empty ? "NaN" : "$" + block + " using 1:2",
                         panel.is_stepped ? "steps" : "lines",
                         curve.width,
                         curve.color,
                         has_key ? "title " + GnuplotText(curve.name) : "notitle");
  }
  if (curves.empty()) plots = "plot NaN notitle";
  return blocks + (has_points ? "set yrange [*:*]\n" : "set yrange [-1:1]\n") + plots + "\n";
}

std::string HeldOutRectangles(const TimePanel& panel) {
  std::string text;
  for (const TimeInterval& interval : panel.held_out) {
    text += fmt::format(
        "set object rectangle from {0:.12g}, graph 0 to {1:.12g}, graph 1 fc rgb '#f6efdc' fs "
        "solid "
        "noborder behind\n"
        "set label 'held out' at {0:.12g}, graph 1 offset 0.6,-0.8 left textcolor rgb '#7a6322' "
        "front\n",
        interval.from,
        interval.to);
  }
  return text;
}

}  // namespace

void WriteFigure(const TimePanel& panel, const std::filesystem::path& path) {
  CheckPanel(panel);
  Palette palette;
  const bool is_lone = !panel.measured && panel.responses.size() == 1;
  std::vector<Curve> curves;
  std::vector<Curve> residuals;
  if (panel.measured) {
    curves.push_back(
        {panel.measured->name, std::string(kMeasuredColor), 2.2, panel.measured->values});
  }
  for (const Series& response : panel.responses) {
    const std::string color(is_lone ? kLoneColor : palette.ColorOf(response.ColorName()));
    curves.push_back({response.name, color, 1.4, response.values});
    if (!panel.measured || !panel.has_residuals) continue;
    residuals.push_back({response.name, color, 0.9, Residual(*panel.measured, response)});
  }

  double first = panel.time.empty() ? 0.0 : panel.time.front();
  double last = panel.time.empty() ? 1.0 : panel.time.back();
  if (first == last) last = first + 1.0;
  const bool has_residuals = !residuals.empty();
  const std::string time_label = "set xlabel 'time [s]' textcolor rgb '#1b2330'\n";

  std::string script(kFigureStyle);
  script += "set multiplot\nset lmargin at screen 0.095\nset rmargin at screen 0.975\n";
  script += fmt::format("set xrange [{:.12g}:{:.12g}]\n", first, last);
  script += HeldOutRectangles(panel);
  script += "set key at screen 0.095, screen 0.945 left top horizontal Left reverse samplen 1.6\n";
  if (!panel.title.empty()) {
    script += fmt::format("set label 99 {} at screen 0.095, screen 0.965 left\n",
                          GnuplotText(panel.title));
  }
  script += "set tmargin at screen 0.87\n";
  script += fmt::format("set bmargin at screen {}\n", has_residuals ? 0.40 : 0.14);
  script += has_residuals ? "set format x ''\n" : time_label;
  script += fmt::format("set ylabel {} offset 0.5,0\n",
                        GnuplotText(NameWithUnit(panel.quantity, panel.unit)));
  script += PlotCommand("response", panel, curves, true);
  if (has_residuals) {
    script +=
        "unset label 99\nset format x '%g'\nset tmargin at screen 0.36\n"
        "set bmargin at screen 0.13\nset ytics autofreq\n";
    script += time_label;
    script += fmt::format("set ylabel {} offset 0.5,0\n",
                          GnuplotText(NameWithUnit("residual", panel.unit)));
    script += PlotCommand("residual", panel, residuals, false);
  }
  script += "unset multiplot\n";
  DrawWithGnuplot(script, 1000, has_residuals ? 600 : 380, path);
}

}  // namespace fathom
