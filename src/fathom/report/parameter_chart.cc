// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/parameter_chart.h"

#include "fathom/base/interval95.h"
#include "fathom/base/median.h"
#include "fathom/report/format_value.h"
#include "fathom/report/html_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kFarAway = 25.0;
constexpr double kBarMargin = 0.06;

// Per cent from the left end of the range.
double Place(double value, const ChartRange& range) {
  return 100.0 * (value - range.from) / (range.to - range.from);
}

std::string Span(std::string_view kind, double place) {
  return fmt::format(R"(<i class="{}" style="left:{:.2f}%"></i>)", kind, place);
}

std::string Arrow(bool points_right, std::string_view color) {
  return fmt::format(R"(<i class="arrow {}" style="color:{}">{}</i>)",
                     points_right ? "right" : "left",
                     color,
                     points_right ? "&#9654;" : "&#9664;");
}

std::string ValueWithUnit(const std::string& value, const std::string& unit) {
  return unit.empty() ? value : value + " " + UnitText(unit);
}

// Whether an end of a bar stands at a bound of the parameter, short of the interval's.
std::string OpenEnds(const Estimate& estimate, const ChartRange& bar) {
  const double half = kStdsOf95 * estimate.std;
  return std::string(bar.from > estimate.value - half ? " open-left" : "") +
         (bar.to < estimate.value + half ? " open-right" : "");
}

// Bar, dot and the arrows that stand for what lies outside.
std::string MarksHtml(const Estimate& estimate,
                      const ParameterPanel& panel,
                      const ChartRange& range,
                      std::string_view color) {
  if (!std::isfinite(estimate.value)) return R"(<span class="none">no estimate</span>)";
  const ChartRange bar = BarOf(estimate, panel);
  const double left = Place(bar.from, range);
  const double right = Place(bar.to, range);
  const double dot = Place(estimate.value, range);
  std::string html;
  const double shown_left = std::clamp(left, 0.0, 100.0);
  const double shown_right = std::clamp(right, 0.0, 100.0);
  if (shown_right > shown_left) {
    html += fmt::format(R"(<i class="bar{}" style="left:{:.2f}%;width:{:.2f}%;background:{}"></i>)",
                        OpenEnds(estimate, bar),
                        shown_left,
                        shown_right - shown_left,
                        color);
  }
  if (left < 0.0) html += Arrow(false, color);
  if (right > 100.0) html += Arrow(true, color);
  if (dot >= 0.0 && dot <= 100.0) {
    html += fmt::format(R"(<i class="dot" style="left:{:.2f}%;background:{}"></i>)", dot, color);
  }
  return html;
}

std::string HoverText(const Estimate& estimate, const ParameterPanel& panel) {
  if (!std::isfinite(estimate.value)) return estimate.name + ": no estimate";
  std::string text = fmt::format("{}: {:.6g}", estimate.name, estimate.value);
  if (!std::isnan(estimate.std)) {
    const ChartRange bar = BarOf(estimate, panel);
    text += fmt::format(", 95 % interval {:.6g} to {:.6g}", bar.from, bar.to);
  }
  return ValueWithUnit(text, panel.unit);
}

}  // namespace

ChartRange BarOf(const Estimate& estimate, const ParameterPanel& panel) {
  const double value = estimate.value;
  const double half = std::isnan(estimate.std) ? 0.0 : kStdsOf95 * estimate.std;
  ChartRange bar{value - half, value + half};
  if (value >= panel.lower_bound) bar.from = std::max(bar.from, panel.lower_bound);
  if (value <= panel.upper_bound) bar.to = std::min(bar.to, panel.upper_bound);
  return bar;
}

ChartRange RangeOf(const ParameterPanel& panel) {
  std::vector<double> values;
  std::vector<double> halves;
  for (const Estimate& estimate : panel.estimates) {
    if (!std::isfinite(estimate.value)) continue;
    values.push_back(estimate.value);
    if (std::isfinite(estimate.std)) halves.push_back(kStdsOf95 * estimate.std);
  }
  if (panel.reference) values.push_back(*panel.reference);
  if (values.empty()) return {};

  const double center = Median(values);
  std::vector<double> distances;
  for (const double value : values) distances.push_back(std::abs(value - center));
  const double usual = std::max(Median(distances), halves.empty() ? 0.0 : Median(halves));
  const double farthest = usual > 0.0 ? kFarAway * usual : std::numeric_limits<double>::infinity();

  ChartRange range{center, center};
  const auto include = [&](double value) {
    if (std::abs(value - center) > farthest) return;
    range.from = std::min(range.from, value);
    range.to = std::max(range.to, value);
  };
  for (const Estimate& estimate : panel.estimates) {
    if (!std::isfinite(estimate.value)) continue;
    include(estimate.value);
    if (!std::isfinite(estimate.std)) continue;
    const ChartRange bar = BarOf(estimate, panel);
    include(bar.from);
    include(bar.to);
  }
  if (panel.reference) include(*panel.reference);

  double margin = kBarMargin * (range.to - range.from);
  if (!(margin > 0.0)) margin = center == 0.0 ? 1.0 : 0.1 * std::abs(center);
  return {range.from - margin, range.to + margin};
}

std::vector<double> TicksOf(const ChartRange& range) {
  const double least_step = (range.to - range.from) / 5.0;
  const double power = std::pow(10.0, std::floor(std::log10(least_step)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= least_step) step = factor * power;
  }
  std::vector<double> ticks;
  for (double count = std::ceil(range.from / step); count * step <= range.to; count += 1.0) {
    ticks.push_back(count * step);
  }
  return ticks;
}

std::string TickLabel(double tick, double step) {
  if (std::abs(tick) < 1e-9 * step) return "0";
  if (step >= 1e-4 && std::abs(tick) < 1e6) {
    return fmt::format(
        "{:.{}f}", tick, std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9))));
  }
  // As many digits as tell one tick from the next.
  const double digits = std::floor(std::log10(std::abs(tick))) - std::floor(std::log10(step)) + 1.0;
  return fmt::format("{:.{}g}", tick, static_cast<int>(std::clamp(digits, 4.0, 15.0)));
}

std::string ParameterChartHtml(const ParameterPanel& panel, Palette& palette) {
  const ChartRange range = RangeOf(panel);
  const std::vector<double> ticks = TicksOf(range);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : range.to - range.from;

  std::string lines;
  for (const double tick : ticks) lines += Span("tick", Place(tick, range));
  if (panel.reference) {
    const double place = Place(*panel.reference, range);
    if (place >= 0.0 && place <= 100.0) lines += Span("reference", place);
  }

  std::string html = fmt::format(
      R"(<figure class="parameter" aria-label="estimates of {0}"><figcaption><b>{0}</b>)",
      HtmlText(panel.name));
  if (!panel.unit.empty()) {
    html += fmt::format(" <span>[{}]</span>", HtmlText(UnitText(panel.unit)));
  }
  if (panel.reference) {
    html += fmt::format(R"(<em>{} {}</em>)",
                        HtmlText(panel.reference_name),
                        HtmlText(FormatValue(*panel.reference)));
  }
  html += "</figcaption>\n<div class=\"rows\">\n";
  for (const Estimate& estimate : panel.estimates) {
    html += fmt::format(
        R"(<span class="name" title="{0}">{1}</span><span class="track" title="{0}">{2}{3}</span><span class="value">{4}</span>)"
        "\n",
        HtmlText(HoverText(estimate, panel)),
        HtmlText(estimate.name),
        lines,
        MarksHtml(estimate, panel, range, palette.ColorOf(estimate.name)),
        HtmlText(FormatValue(estimate.value, estimate.std)));
  }
  html += R"(<span></span><span class="axis">)";
  for (const double tick : ticks) {
    html +=
        fmt::format(R"(<i style="left:{:.2f}%">{}</i>)", Place(tick, range), TickLabel(tick, step));
  }
  return html + "</span><span></span>\n</div></figure>\n";
}

}  // namespace fathom
