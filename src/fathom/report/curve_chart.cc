// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/curve_chart.h"

#include "fathom/report/chart_columns.h"
#include "fathom/report/chart_frame.h"
#include "fathom/report/html_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

// The rows of the panel that its axes can show.
CurvePanel ShownPart(const CurvePanel& panel) {
  CHECK_EQ(panel.x.size(), panel.y.size());
  CHECK_EQ(panel.low.size(), panel.high.size());
  const auto can_show = [](double value, bool is_log) {
    return std::isfinite(value) && (!is_log || value > 0.0);
  };
  const bool has_band = !panel.low.empty();
  CurvePanel shown = panel;
  for (auto* list : {&shown.x, &shown.y, &shown.low, &shown.high}) list->clear();
  for (std::size_t i = 0; i < panel.x.size(); ++i) {
    if (!can_show(panel.x[i], panel.is_log_x) || !can_show(panel.y[i], panel.is_log_y)) continue;
    if (has_band && !can_show(panel.low[i], panel.is_log_y)) continue;
    shown.x.push_back(panel.x[i]);
    shown.y.push_back(panel.y[i]);
    if (!has_band) continue;
    shown.low.push_back(panel.low[i]);
    shown.high.push_back(panel.high[i]);
  }
  return shown;
}

ChartFrame FrameOf(const CurvePanel& panel) {
  const auto [first, last] = std::ranges::minmax(panel.x);
  auto [least, most] = std::ranges::minmax(panel.y);
  for (const double value : panel.low) least = std::min(least, value);
  for (const double value : panel.high) most = std::max(most, value);
  return {AxisOver(first, last, panel.is_log_x), AxisOver(least, most, panel.is_log_y)};
}

std::string PathSvg(const char* kind, const std::string& path) {
  return fmt::format(R"(<path class="{}" d="{}"/>)", kind, path);
}

// The stretch of x from top to bottom, as far as it is shown.
std::string MarkedSvg(const ChartFrame& frame, const TimeInterval& marked) {
  const ChartRange& x = frame.x.range;
  const double left = frame.Left(std::clamp(marked.from, x.from, x.to));
  const double right = frame.Left(std::clamp(marked.to, x.from, x.to));
  return fmt::format(
      R"(<rect class="marked" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)",
      left,
      ChartFrame::kTop,
      std::max(right - left, 1.0),
      ChartFrame::kHeight - ChartFrame::kTop - ChartFrame::kBottom);
}

std::string ColumnsOf(const CurvePanel& panel) {
  std::vector<ChartColumn> columns = {{NameWithUnit(panel.x_name, panel.x_unit), panel.x},
                                      {NameWithUnit(panel.y_name, panel.y_unit), panel.y}};
  if (!panel.low.empty()) {
    columns.push_back({NameWithUnit(panel.band_name + ", low", panel.y_unit), panel.low});
    columns.push_back({NameWithUnit(panel.band_name + ", high", panel.y_unit), panel.high});
  }
  return ColumnsJson(columns);
}

std::string KeyHtml(const char* kind, const std::string& name) {
  return fmt::format(R"(<span><i class="{}"></i>{}</span>)", kind, HtmlText(name));
}

}  // namespace

std::string CurveChartHtml(const CurvePanel& panel) {
  const CurvePanel shown = ShownPart(panel);
  std::string html =
      fmt::format(R"(<figure class="scatter curve" data-columns="{}"><figcaption><b>{}</b>)",
                  HtmlText(ColumnsOf(shown)),
                  HtmlText(NameWithUnit(panel.y_name, panel.y_unit)));
  if (!panel.note.empty()) html += fmt::format("<em>{}</em>", HtmlText(panel.note));
  html += "</figcaption>\n";
  if (shown.x.empty()) return html + "<p class=\"hint\">No data.</p></figure>\n";

  const ChartFrame frame = FrameOf(shown);
  std::string content, keys;
  if (panel.marked) {
    content += MarkedSvg(frame, *panel.marked);
    keys += KeyHtml("marked", panel.marked_name);
  }
  if (!shown.low.empty()) {
    content += PathSvg("band", frame.AreaOf(shown.x, shown.low, shown.high));
    keys += KeyHtml("band", panel.band_name);
  }
  content += PathSvg("line", frame.PathOf(shown.x, shown.y));
  if (!keys.empty()) html += "<div class=\"curve-key\">" + keys + "</div>\n";
  return html +
         frame.Svg(panel.y_name + " over " + panel.x_name,
                   NameWithUnit(panel.x_name, panel.x_unit),
                   content) +
         "</figure>\n";
}

std::string CurveChartsHtml(const std::vector<CurvePanel>& panels) {
  if (panels.empty()) return "";
  std::string html = "<div class=\"scatters\">\n";
  for (const CurvePanel& panel : panels) html += CurveChartHtml(panel);
  return html + "</div>\n";
}

}  // namespace fathom
