// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/scatter_chart.h"

#include "fathom/report/format_value.h"
#include "fathom/report/html_text.h"
#include "fathom/report/parameter_chart.h"
#include "fathom/report/scatter_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

// Of the drawing [px]; the axes' labels stand left and below.
constexpr double kWidth = 340.0, kHeight = 230.0;
constexpr double kLeft = 52.0, kRight = 6.0, kTop = 6.0, kBottom = 38.0;

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

ChartRange RangeOfValues(double low, double high) {
  const double margin = high > low ? 0.04 * (high - low) : low == 0.0 ? 1.0 : 0.1 * std::abs(low);
  return {low - margin, high + margin};
}

// Between the axes.
struct Frame {
  ChartRange x, y;

  double Left(double value) const {
    return kLeft + (value - x.from) / (x.to - x.from) * (kWidth - kLeft - kRight);
  }
  double Top(double value) const {
    return kHeight - kBottom - (value - y.from) / (y.to - y.from) * (kHeight - kTop - kBottom);
  }
};

std::string Line(std::string_view kind, double x1, double y1, double x2, double y2) {
  return fmt::format(R"(<line class="{}" x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>)",
                     kind,
                     x1,
                     y1,
                     x2,
                     y2);
}

std::string Label(double x, double y, std::string_view anchor, const std::string& text) {
  return fmt::format(
      R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor, HtmlText(text));
}

std::string AxesSvg(const Frame& frame) {
  const double right = kWidth - kRight, bottom = kHeight - kBottom;
  std::string svg;
  const auto step_of = [](const std::vector<double>& ticks) {
    return ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  };
  const std::vector<double> x_ticks = TicksOf(frame.x), y_ticks = TicksOf(frame.y);
  for (const double tick : x_ticks) {
    const double at = frame.Left(tick);
    svg += Line("grid", at, kTop, at, bottom);
    svg += Label(at, bottom + 15.0, "middle", TickLabel(tick, step_of(x_ticks)));
  }
  for (const double tick : y_ticks) {
    const double at = frame.Top(tick);
    svg += Line("grid", kLeft, at, right, at);
    svg += Label(kLeft - 6.0, at + 4.0, "end", TickLabel(tick, step_of(y_ticks)));
  }
  if (frame.x.from < 0.0 && frame.x.to > 0.0) {
    svg += Line("zero", frame.Left(0.0), kTop, frame.Left(0.0), bottom);
  }
  if (frame.y.from < 0.0 && frame.y.to > 0.0) {
    svg += Line("zero", kLeft, frame.Top(0.0), right, frame.Top(0.0));
  }
  return svg;
}

// Points are strokes without length and with round ends: a few bytes each.
std::string PointsSvg(const Frame& frame, const std::vector<Pair>& pairs) {
  const std::size_t every = DrawnEvery(pairs.size());
  std::string path;
  for (std::size_t i = 0; i < pairs.size(); i += every) {
    if (pairs[i].y < frame.y.from || pairs[i].y > frame.y.to) continue;
    path += fmt::format("M{:.1f} {:.1f}h0", frame.Left(pairs[i].x), frame.Top(pairs[i].y));
  }
  return fmt::format(R"(<path class="points" d="{}"/>)", path);
}

std::string CurveSvg(const Frame& frame,
                     const std::vector<BinMean>& means,
                     const char* kind,
                     std::string_view color) {
  std::string path;
  for (const BinMean& mean : means) {
    path += fmt::format(
        "{}{:.1f} {:.1f}", path.empty() ? "M" : "L", frame.Left(mean.x), frame.Top(mean.y));
  }
  return fmt::format(R"(<path class="{}" style="stroke:{}" d="{}"/>)", kind, color, path);
}

// Two standard errors about the means, as if a tenth of the bin's points were independent.
std::string SpreadSvg(const Frame& frame,
                      const std::vector<BinMean>& means,
                      std::string_view color) {
  std::string path;
  const auto half = [](const BinMean& mean) {
    return 2.0 * mean.spread / std::sqrt(std::max(0.1 * mean.num_points, 1.0));
  };
  const auto add = [&](const BinMean& mean, double y) {
    path += fmt::format("{}{:.1f} {:.1f}",
                        path.empty() ? "M" : "L",
                        frame.Left(mean.x),
                        frame.Top(std::clamp(y, frame.y.from, frame.y.to)));
  };
  for (const BinMean& mean : means) add(mean, mean.y + half(mean));
  for (auto mean = means.rbegin(); mean != means.rend(); ++mean) add(*mean, mean->y - half(*mean));
  return fmt::format(R"(<path class="spread" style="fill:{}" d="{}Z"/>)", color, path);
}

// All but the outermost two in a thousand of the points, and every mean.
ChartRange VerticalRange(const std::vector<Pair>& pairs,
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
  return RangeOfValues(low, high);
}

std::string WithUnit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, UnitText(unit));
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
  const Frame frame = {RangeOfValues(least->x, most->x), VerticalRange(pairs, means, second)};

  html += fmt::format(R"(<svg viewBox="0 0 {:.0f} {:.0f}" role="img" aria-label="{}">)",
                      kWidth,
                      kHeight,
                      HtmlText(panel.y_name + " over " + panel.x_name));
  html += AxesSvg(frame) + PointsSvg(frame, pairs);
  if (means.size() > 1) {
    const std::string_view color = palette.ColorOf(panel.y_name);
    html += SpreadSvg(frame, means, color) + CurveSvg(frame, means, "means", color);
    if (second.size() > 1) {
      html += CurveSvg(frame, second, "second", palette.ColorOf(panel.second_name));
    }
  }
  html += Label(0.5 * (kLeft + kWidth - kRight),
                kHeight - 6.0,
                "middle",
                WithUnit(panel.x_name, panel.x_unit));
  return html + "</svg></figure>\n";
}

std::string ScatterChartsHtml(const std::vector<ScatterPanel>& panels, Palette& palette) {
  if (panels.empty()) return "";
  const ScatterPanel& first = panels.front();
  std::string html = fmt::format(
      "<div class=\"scatter-key\"><span><i class=\"point\" style=\"color:{}\"></i>{}</span>"
      "<span><i style=\"color:{}\"></i>mean, with two standard errors</span>",
      kMeasuredColor,
      HtmlText(WithUnit(first.y_name, first.y_unit)),
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
