// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/figure.h"

#include "fathom/base/interval95.h"
#include "fathom/report/format_value.h"
#include "fathom/report/gnuplot.h"
#include "fathom/report/palette.h"
#include "fathom/report/parameter_chart.h"
#include "fathom/report/thinning.h"
#include "fathom/report/time_chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

// What all plots share: no box, a pale grid, grey numbers.
constexpr std::string_view kStyle = R"(
set border 3 lc rgb '#9aa3af' lw 0.7
set grid lc rgb '#e2e6ec' lw 0.6 lt 1
set tics nomirror out scale 0.5 textcolor rgb '#5d6776'
)";

// A curve to draw: columns 1 and 2 of a data block.
struct Curve {
  std::string name;
  std::string color;
  double width = 1.0;
  std::vector<double> values;
};

std::string WithUnit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

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
    const std::string color(is_lone ? kLoneColor : palette.ColorOf(response.name));
    curves.push_back({response.name, color, 1.4, response.values});
    if (!panel.measured || !panel.has_residuals) continue;
    residuals.push_back({response.name, color, 0.9, Residual(*panel.measured, response)});
  }

  double first = panel.time.empty() ? 0.0 : panel.time.front();
  double last = panel.time.empty() ? 1.0 : panel.time.back();
  if (first == last) last = first + 1.0;
  const bool has_residuals = !residuals.empty();
  const std::string time_label = "set xlabel 'time [s]' textcolor rgb '#1b2330'\n";

  std::string script(kStyle);
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
                        GnuplotText(WithUnit(panel.quantity, panel.unit)));
  script += PlotCommand("response", panel, curves, true);
  if (has_residuals) {
    script +=
        "unset label 99\nset format x '%g'\nset tmargin at screen 0.36\n"
        "set bmargin at screen 0.13\nset ytics autofreq\n";
    script += time_label;
    script +=
        fmt::format("set ylabel {} offset 0.5,0\n", GnuplotText(WithUnit("residual", panel.unit)));
    script += PlotCommand("residual", panel, residuals, false);
  }
  script += "unset multiplot\n";
  DrawWithGnuplot(script, 1000, has_residuals ? 600 : 380, path);
}

void WriteFigure(const std::vector<ParameterPanel>& panels, const std::filesystem::path& path) {
  constexpr int kColumnWidth = 560;  // [px]
  constexpr int kRowHeight = 26;
  constexpr int kFrameHeight = 92;

  Palette palette;
  std::size_t most_estimates = 1;
  for (const ParameterPanel& panel : panels) {
    most_estimates = std::max(most_estimates, panel.estimates.size());
  }
  const int num_columns = panels.size() > 1 ? 2 : 1;
  const int num_rows =
      std::max(1, (static_cast<int>(panels.size()) + num_columns - 1) / num_columns);
  const int plot_height = kRowHeight * static_cast<int>(most_estimates) + kFrameHeight;
  const int width = num_columns * kColumnWidth;
  const int height = num_rows * plot_height;

  std::string script(kStyle);
  script += "set border 1\nunset key\nset multiplot\nset grid noytics\nset errorbars 0\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const ParameterPanel& panel = panels[i];
    const ChartRange range = RangeOf(panel);
    const std::vector<double> ticks = TicksOf(range);
    const double left = static_cast<double>(i % num_columns) / num_columns;
    const double top = 1.0 - static_cast<double>(i / num_columns) / num_rows;
    const double x_unit = 1.0 / width;
    const double y_unit = 1.0 / height;
    script += fmt::format(
        "unset label\nunset arrow\n"
        "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
        "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
        "set xrange [{:.12g}:{:.12g}]\nset yrange [{}:-0.6]\n",
        left + 130 * x_unit,
        left + (kColumnWidth - 130) * x_unit,
        top - 45 * y_unit,
        top - (plot_height - 40) * y_unit,
        range.from,
        range.to,
        static_cast<double>(panel.estimates.size()) - 0.4);
    script += fmt::format("set label {} at graph 0, graph 1 offset 0,0.9 left\n",
                          GnuplotText(WithUnit(panel.name, panel.unit)));

    std::string tick_labels;
    for (const double tick : ticks) {
      tick_labels += fmt::format("{}{} {:.12g}",
                                 tick_labels.empty() ? "" : ", ",
                                 GnuplotText(TickLabel(tick, ticks[1] - ticks[0])),
                                 tick);
    }
    script += "set xtics (" + tick_labels + ")\n";
    if (panel.reference) {
      script += fmt::format(
          "set arrow from {0:.12g}, graph 0 to {0:.12g}, graph 1 nohead lw 1.2 dt (6,4) lc rgb "
          "'#444d5a' back\n"
          "set label {1} at graph 1, graph 1 offset 0,0.9 right textcolor rgb '#5d6776'\n",
          *panel.reference,
          GnuplotText(panel.reference_name + " " + FormatValue(*panel.reference)));
    }

    std::string names;
    std::string blocks;
    std::string plots = "plot NaN";
    for (std::size_t k = 0; k < panel.estimates.size(); ++k) {
      const Estimate& estimate = panel.estimates[k];
      const std::string color(palette.ColorOf(estimate.name));
      names += fmt::format("{}{} {}", k == 0 ? "" : ", ", GnuplotText(estimate.name), k);
      script += fmt::format("set label {} at graph 1, first {} offset 1,0 left\n",
                            GnuplotText(FormatValue(estimate.value, estimate.std)),
                            k);
      if (!std::isfinite(estimate.value)) continue;
      if (estimate.value < range.from || estimate.value > range.to) {
        const bool is_right = estimate.value > range.to;
        script += fmt::format("set label '{}' at graph {}, first {} {} textcolor rgb '{}'\n",
                              is_right ? "▶" : "◀",
                              is_right ? 1 : 0,
                              k,
                              is_right ? "right" : "left",
                              color);
        continue;
      }
      const double half = std::isfinite(estimate.std) ? kStdsOf95 * estimate.std : 0.0;
      blocks +=
          fmt::format("$estimate{}_{} << END_OF_DATA\n{:.12g} {} {:.12g} {:.12g}\nEND_OF_DATA\n",
                      i,
                      k,
                      estimate.value,
                      k,
                      std::max(estimate.value - half, range.from),
                      std::min(estimate.value + half, range.to));
      plots += fmt::format(
          ", $estimate{0}_{1} using 1:2:3:4 with xerrorbars pt 7 ps 0.9 lw 2.4 lc rgb '{2}'",
          i,
          k,
          color);
    }
    script += "set ytics (" + names + ") scale 0 textcolor rgb '#1b2330'\n" + blocks + plots + "\n";
  }
  script += "unset multiplot\n";
  DrawWithGnuplot(script, width, height, path);
}

}  // namespace fathom
