// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/scatter_chart.h"

#include "fathom/report/chart_frame.h"
#include "fathom/report/html_text.h"
#include "fathom/report/scatter_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr int kNumBins = 24;
constexpr std::size_t kFewestInBin = 5;

struct Pair {
  double x;
  double y;
};

std::vector<Pair> FinitePairs(const std::vector<double>& x, const std::vector<double>& y) {
  CHECK_EQ(x.size(), y.size());
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i])) pairs.push_back({x[i], y[i]});
  }
  return pairs;
}

// Points are strokes without length and with round ends: a few bytes each.
std::string PointsSvg(const ChartFrame& frame, const std::vector<Pair>& pairs) {
  const std::size_t every = DrawnEvery(pairs.size());
  std::string path;
  for (std::size_t i = 0; i < pairs.size(); i += every) {
    if (pairs[i].y < frame.y.range.from || pairs[i].y > frame.y.range.to) continue;
    path += fmt::format("M{:.1f} {:.1f}h0", frame.Left(pairs[i].x), frame.Top(pairs[i].y));
  }
  return fmt::format(R"(<path class="points" d="{}"/>)", path);
}

std::string CurveSvg(const ChartFrame& frame,
                     const std::vector<BinMean>& means,
                     const char* kind,
                     std::string_view color) {
  std::vector<double> x, y;
  for (const BinMean& mean : means) {
    x.push_back(mean.x);
    y.push_back(mean.y);
  }
  return fmt::format(
      R"(<path class="{}" style="stroke:{}" d="{}"/>)", kind, color, frame.PathOf(x, y));
}

// Two standard errors about the means, as if a tenth of the bin's points were independent.
std::string SpreadSvg(const ChartFrame& frame,
                      const std::vector<BinMean>& means,
                      std::string_view color) {
  std::vector<double> x, low, high;
  for (const BinMean& mean : means) {
    const double half = 2.0 * mean.spread / std::sqrt(std::max(0.1 * mean.num_points, 1.0));
    x.push_back(mean.x);
    low.push_back(mean.y - half);
    high.push_back(mean.y + half);
  }
  return fmt::format(
      R"(<path class="spread" style="fill:{}" d="{}"/>)", color, frame.AreaOf(x, low, high));
}

// All but the outermost two in a thousand of the points, and every mean.
ChartAxis VerticalAxis(const std::vector<Pair>& pairs,
                       const std::vector<BinMean>& means,
                       const std::vector<BinMean>& second) {
  std::vector<double> values;
  for (const Pair& pair : pairs) values.push_back(pair.y);
  std::ranges::sort(values);
  const auto cut = static_cast<std::size_t>(0.001 * static_cast<double>(values.size()));
  double low = values[cut], high = values[values.size() - 1 - cut];
  for (const auto* list : {&means, &second}) {
    for (const BinMean& mean : *list) {
      low = std::min(low, mean.y);
      high = std::max(high, mean.y);
    }
  }
  return AxisOver(low, high);
}

}  // namespace

std::vector<BinMean> MeansByBins(const std::vector<double>& x,
                                 const std::vector<double>& y,
                                 int num_bins) {
  std::vector<Pair> pairs = FinitePairs(x, y);
  std::ranges::stable_sort(pairs, {}, &Pair::x);
  const std::size_t size =
      std::max(kFewestInBin, (pairs.size() + static_cast<std::size_t>(num_bins) - 1) / num_bins);
  std::vector<BinMean> means;
  for (std::size_t begin = 0; begin < pairs.size();) {
    std::size_t end = std::min(begin + size, pairs.size());
    while (end < pairs.size() && pairs[end].x == pairs[end - 1].x) ++end;
    if (pairs.size() - end < kFewestInBin) end = pairs.size();
    BinMean mean;
    mean.num_points = static_cast<int>(end - begin);
    // From the first point on, so that the mean of equal numbers is that number.
    for (std::size_t i = begin; i < end; ++i) {
      mean.x += (pairs[i].x - pairs[begin].x) / mean.num_points;
      mean.y += (pairs[i].y - pairs[begin].y) / mean.num_points;
    }
    mean.x += pairs[begin].x;
    mean.y += pairs[begin].y;
    for (std::size_t i = begin; i < end; ++i) {
      mean.spread += std::pow(pairs[i].y - mean.y, 2) / mean.num_points;
    }
    mean.spread = std::sqrt(mean.spread);
    means.push_back(mean);
    begin = end;
  }
  return means;
}

double ShareBetweenBins(const std::vector<double>& x, const std::vector<double>& y, int num_bins) {
  double count = 0.0, sum = 0.0, within = 0.0, between = 0.0;
  const std::vector<BinMean> means = MeansByBins(x, y, num_bins);
  const double first = means.empty() ? 0.0 : means.front().y;
  for (const BinMean& mean : means) {
    count += mean.num_points;
    sum += mean.num_points * (mean.y - first);
  }
  for (const BinMean& mean : means) {
    within += mean.num_points * mean.spread * mean.spread;
    between += mean.num_points * std::pow(mean.y - first - sum / count, 2);
  }
  return within + between > 0.0 ? between / (within + between)
                                : std::numeric_limits<double>::quiet_NaN();
}

std::string ScatterChartHtml(const ScatterPanel& panel, Palette& palette) {
  const std::vector<Pair> pairs = FinitePairs(panel.x, panel.y);
  std::string html =
      fmt::format("<figure class=\"scatter\" data-columns=\"{}\"><figcaption><b>{}</b>",
                  HtmlText(ScatterColumnsJson(panel)),
                  HtmlText(panel.x_name));
  if (!panel.note.empty()) html += fmt::format("<em>{}</em>", HtmlText(panel.note));
  html += "</figcaption>\n";
  if (pairs.empty()) return html + "<p class=\"hint\">No data.</p></figure>\n";

  const std::vector<BinMean> means = MeansByBins(panel.x, panel.y, kNumBins);
  std::vector<BinMean> second;
  if (!panel.second_y.empty()) second = MeansByBins(panel.x, panel.second_y, kNumBins);
  const auto [least, most] = std::ranges::minmax_element(pairs, {}, &Pair::x);
  const ChartFrame frame = {AxisOver(least->x, most->x), VerticalAxis(pairs, means, second)};

  std::string content = PointsSvg(frame, pairs);
  if (means.size() > 1) {
    const std::string_view color = palette.ColorOf(panel.y_name);
    content += SpreadSvg(frame, means, color) + CurveSvg(frame, means, "means", color);
    if (second.size() > 1) {
      content += CurveSvg(frame, second, "second", palette.ColorOf(panel.second_name));
    }
  }
  return html +
         frame.Svg(panel.y_name + " over " + panel.x_name,
                   NameWithUnit(panel.x_name, panel.x_unit),
                   content) +
         "</figure>\n";
}

std::string ScatterChartsHtml(const std::vector<ScatterPanel>& panels, Palette& palette) {
  if (panels.empty()) return "";
  const ScatterPanel& first = panels.front();
  std::string html = fmt::format(
      "<div class=\"scatter-key\"><span><i class=\"point\" style=\"color:{}\"></i>{}</span>"
      "<span><i style=\"color:{}\"></i>mean, with two standard errors</span>",
      kMeasuredColor,
      HtmlText(NameWithUnit(first.y_name, first.y_unit)),
      palette.ColorOf(first.y_name));
  const bool has_second = std::ranges::any_of(
      panels, [](const ScatterPanel& panel) { return !panel.second_y.empty(); });
  if (has_second) {
    html += fmt::format("<span><i style=\"color:{};border-top-style:dashed\"></i>{}, mean</span>",
                        palette.ColorOf(first.second_name),
                        HtmlText(first.second_name));
  }
  html += "</div>\n<div class=\"scatters\">\n";
  for (const ScatterPanel& panel : panels) html += ScatterChartHtml(panel, palette);
  return html + "</div>\n";
}

}  // namespace fathom
