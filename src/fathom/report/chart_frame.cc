// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/chart_frame.h"

#include "fathom/report/format_value.h"
#include "fathom/report/html_text.h"
#include "fathom/report/line_svg.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kMargin = 0.04;  // of the range, at either end

std::string Label(double x, double y, std::string_view anchor, std::string_view text) {
  return fmt::format(
      R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor, HtmlText(text));
}

struct Tick {
  double value;
  std::string label;
};

std::vector<Tick> LabelledTicks(const ChartAxis& axis) {
  const std::vector<double> values = axis.is_log ? LogTicksOf(axis.range) : TicksOf(axis.range);
  const double step = values.size() > 1 ? values[1] - values[0] : 1.0;
  std::vector<Tick> ticks;
  for (const double value : values) {
    ticks.push_back({value, axis.is_log ? LogTickLabel(value) : TickLabel(value, step)});
  }
  return ticks;
}

bool ShowsZero(const ChartAxis& axis) {
  return !axis.is_log && axis.range.from < 0.0 && axis.range.to > 0.0;
}

std::string AxesSvg(const ChartFrame& frame) {
  const double right = ChartFrame::kWidth - ChartFrame::kRight;
  const double bottom = ChartFrame::kHeight - ChartFrame::kBottom;
  std::string svg;
  for (const auto& [value, label] : LabelledTicks(frame.x)) {
    const double at = frame.Left(value);
    svg += LineSvg("grid", at, ChartFrame::kTop, at, bottom);
    svg += Label(at, bottom + 15.0, "middle", label);
  }
  for (const auto& [value, label] : LabelledTicks(frame.y)) {
    const double at = frame.Top(value);
    svg += LineSvg("grid", ChartFrame::kLeft, at, right, at);
    svg += Label(ChartFrame::kLeft - 6.0, at + 4.0, "end", label);
  }
  if (ShowsZero(frame.x)) {
    svg += LineSvg("zero", frame.Left(0.0), ChartFrame::kTop, frame.Left(0.0), bottom);
  }
  if (ShowsZero(frame.y)) {
    svg += LineSvg("zero", ChartFrame::kLeft, frame.Top(0.0), right, frame.Top(0.0));
  }
  return svg;
}

// "⁻⁵".
std::string Raised(int exponent) {
  static constexpr std::array<std::string_view, 10> kDigits = {
      "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char digit : std::to_string(exponent)) {
    text += digit == '-' ? "⁻" : kDigits[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

}  // namespace

double ChartAxis::PlaceOf(double value) const {
  if (!is_log) return (value - range.from) / (range.to - range.from);
  return std::log(value / range.from) / std::log(range.to / range.from);
}

ChartAxis AxisOver(double least, double most, bool is_log) {
  if (is_log) {
    CHECK_GT(least, 0.0);
    const double margin = most > least ? std::pow(most / least, kMargin) : 1.5;
    return {{least / margin, most * margin}, true};
  }
  const double margin = most > least   ? kMargin * (most - least)
                        : least == 0.0 ? 1.0
                                       : 0.1 * std::abs(least);
  return {{least - margin, most + margin}};
}

std::vector<double> LogTicksOf(const ChartRange& range) {
  const int first = static_cast<int>(std::ceil(std::log10(range.from) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(range.to) + 1e-9));
  std::vector<double> ticks;
  if (last - first >= 2) {
    const int stride = 1 + (last - first) / 6;
    for (int power = first; power <= last; power += stride) ticks.push_back(std::pow(10.0, power));
    return ticks;
  }
  for (int power = first - 1; power <= last; ++power) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tick = factor * std::pow(10.0, power);
      if (tick >= range.from && tick <= range.to) ticks.push_back(tick);
    }
  }
  return ticks;
}

std::string LogTickLabel(double tick) {
  if (tick > 0.9e-3 && tick < 1.1e3) return fmt::format("{:g}", tick);
  const int power = static_cast<int>(std::floor(std::log10(tick) + 1e-9));
  const double factor = std::round(tick / std::pow(10.0, power));
  return fmt::format("{}10{}", factor > 1.0 ? fmt::format("{:g}·", factor) : "", Raised(power));
}

double ChartFrame::Left(double value) const {
  return kLeft + x.PlaceOf(value) * (kWidth - kLeft - kRight);
}

double ChartFrame::Top(double value) const {
  const double shown = std::clamp(value, y.range.from, y.range.to);
  return kHeight - kBottom - y.PlaceOf(shown) * (kHeight - kTop - kBottom);
}

std::string ChartFrame::Svg(std::string_view label,
                            std::string_view x_name,
                            const std::string& content) const {
  return fmt::format(R"(<svg viewBox="0 0 {:.0f} {:.0f}" role="img" aria-label="{}">)",
                     kWidth,
                     kHeight,
                     HtmlText(label)) +
         AxesSvg(*this) + content +
         Label(0.5 * (kLeft + kWidth - kRight), kHeight - 6.0, "middle", x_name) + "</svg>";
}

std::string ChartFrame::PathOf(const std::vector<double>& at,
                               const std::vector<double>& values) const {
  std::string path;
  bool is_drawing = false;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (std::isfinite(values[i])) {
      path += fmt::format("{}{:.1f} {:.1f}", is_drawing ? "L" : "M", Left(at[i]), Top(values[i]));
    }
    is_drawing = std::isfinite(values[i]);
  }
  return path;
}

std::string ChartFrame::AreaOf(const std::vector<double>& at,
                               const std::vector<double>& low,
                               const std::vector<double>& high) const {
  const std::vector<double> back(at.rbegin(), at.rend());
  const std::vector<double> below(low.rbegin(), low.rend());
  std::string area = PathOf(at, high);
  std::string rest = PathOf(back, below);
  if (!rest.empty()) rest.front() = 'L';
  return area + rest + "Z";
}

std::string NameWithUnit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, UnitText(unit));
}

}  // namespace fathom
