// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/plan_chart.h"

#include "fathom/report/chart_columns.h"
#include "fathom/report/html_text.h"
#include "fathom/report/line_svg.h"
#include "fathom/report/parameter_chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kPlanWidth = 900.0, kPlanLeft = 58.0, kPlanRight = 24.0;  // [px]
constexpr double kPlanTop = 10.0, kPlanBottom = 40.0;
constexpr double kLeastHeight = 120.0, kMostHeight = 560.0;  // of what is inside the axes
constexpr double kPlanMargin = 0.05;                         // of the larger range
constexpr std::size_t kPlanPoints = 400;                     // of a curve, at most

// The stretches of both directions and where they stand.
struct PlanFrame {
  ChartRange ahead, starboard;
  double scale = 1.0;  // [px/m]

  double Left(double value) const { return kPlanLeft + scale * (value - ahead.from); }
  double Top(double value) const { return kPlanTop + scale * (value - starboard.from); }
  double Height() const { return scale * (starboard.to - starboard.from); }
};

void Widen(ChartRange* range, double value) {
  if (!std::isfinite(value)) return;
  range->from = std::min(range->from, value);
  range->to = std::max(range->to, value);
}

void Widen(const PlanCurve& curve, PlanFrame* frame) {
  CHECK_EQ(curve.ahead.size(), curve.starboard.size());
  for (const double value : curve.ahead) Widen(&frame->ahead, value);
  for (const double value : curve.starboard) Widen(&frame->starboard, value);
}

// About its middle, to a length.
ChartRange Stretched(const ChartRange& range, double length) {
  const double middle = 0.5 * (range.from + range.to);
  return {middle - 0.5 * length, middle + 0.5 * length};
}

PlanFrame FrameOf(const PlanPanel& panel) {
  PlanFrame frame = {{0.0, 0.0}, {0.0, 0.0}};
  Widen(panel.curve, &frame);
  if (panel.measured) Widen(*panel.measured, &frame);
  for (const PlanCurve& other : panel.others) Widen(other, &frame);
  for (const PlanLimit& limit : panel.limits) {
    Widen(limit.is_along ? &frame.starboard : &frame.ahead, limit.at);
  }
  double along = frame.ahead.to - frame.ahead.from;
  double across = frame.starboard.to - frame.starboard.from;
  const double margin = 2.0 * kPlanMargin * std::max({along, across, 1e-3});
  along += margin;
  across += margin;
  const double width = kPlanWidth - kPlanLeft - kPlanRight;
  const double height = std::clamp(width * across / along, kLeastHeight, kMostHeight);
  frame.scale = std::min(width / along, height / across);
  frame.ahead = Stretched(frame.ahead, width / frame.scale);
  frame.starboard = Stretched(frame.starboard, height / frame.scale);
  return frame;
}

std::string Text(
    std::string_view kind, double x, double y, std::string_view anchor, std::string_view text) {
  return fmt::format(R"(<text class="{}" x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)",
                     kind,
                     x,
                     y,
                     anchor,
                     HtmlText(text));
}

double StepOf(const std::vector<double>& ticks) {
  return ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
}

std::string PlanAxesSvg(const PlanFrame& frame) {
  const double right = kPlanWidth - kPlanRight, bottom = kPlanTop + frame.Height();
  // One distance for both directions: squares.
  const ChartRange& longer =
      frame.Height() > kPlanWidth - kPlanLeft - kPlanRight ? frame.starboard : frame.ahead;
  // About as many again: the frame is wider than those of other charts.
  const double step = 0.5 * StepOf(TicksOf(longer));
  std::string svg;
  for (double at = std::ceil(frame.ahead.from / step) * step; at <= frame.ahead.to; at += step) {
    const double shown = std::abs(at) < 1e-9 * step ? 0.0 : at;
    svg += LineSvg("grid", frame.Left(at), kPlanTop, frame.Left(at), bottom);
    svg += Text("", frame.Left(at), bottom + 15.0, "middle", TickLabel(shown, step));
  }
  // A flat frame has smaller steps across: one number alone would tell no distance.
  const double step_across = std::min(step, StepOf(TicksOf(frame.starboard)));
  const double first = std::ceil(frame.starboard.from / step_across) * step_across;
  for (double at = first; at <= frame.starboard.to; at += step_across) {
    const double shown = std::abs(at) < 1e-9 * step_across ? 0.0 : at;
    svg += LineSvg("grid", kPlanLeft, frame.Top(at), right, frame.Top(at));
    svg += Text("", kPlanLeft - 6.0, frame.Top(at) + 4.0, "end", TickLabel(shown, step_across));
  }
  svg += Text("", 0.5 * (kPlanLeft + right), bottom + 33.0, "middle", "ahead [m]");
  const double middle = kPlanTop + 0.5 * frame.Height();
  return svg + fmt::format(R"(<text x="12" y="{0:.1f}" text-anchor="middle" )"
                           R"svg(transform="rotate(-90 12 {0:.1f})">to starboard [m]</text>)svg",
                           middle);
}

std::string PathSvg(std::string_view kind, const PlanFrame& frame, const PlanCurve& curve) {
  const std::size_t size = curve.ahead.size();
  const std::size_t stride = std::max<std::size_t>(1, size / kPlanPoints);
  std::string path;
  for (std::size_t k = 0; k < size;
       k += k + stride < size || k + 1 == size ? stride : size - 1 - k) {
    if (!std::isfinite(curve.ahead[k]) || !std::isfinite(curve.starboard[k])) continue;
    path += fmt::format("{}{:.1f} {:.1f}",
                        path.empty() ? "M" : "L",
                        frame.Left(curve.ahead[k]),
                        frame.Top(curve.starboard[k]));
  }
  return fmt::format(R"(<path class="{}" d="{}"/>)", kind, path);
}

std::string LimitSvg(const PlanFrame& frame, const PlanLimit& limit) {
  const double right = kPlanWidth - kPlanRight, bottom = kPlanTop + frame.Height();
  if (limit.is_along) {
    const double at = frame.Top(limit.at);
    return LineSvg("limit", kPlanLeft, at, right, at) +
           Text("limit-name", right - 4.0, at - 5.0, "end", limit.name);
  }
  const double at = frame.Left(limit.at);
  return LineSvg("limit", at, kPlanTop, at, bottom) +
         Text("limit-name", at - 5.0, kPlanTop + 13.0, "end", limit.name);
}

std::string PlanKeyHtml(std::string_view kind, std::string_view name) {
  return fmt::format(R"(<span><i class="{}"></i>{}</span>)", kind, HtmlText(name));
}

}  // namespace

std::string PlanChartHtml(const PlanPanel& panel) {
  const PlanFrame frame = FrameOf(panel);
  std::string keys = PlanKeyHtml("path", panel.curve.name), content;
  if (panel.measured) keys += PlanKeyHtml("logged", panel.measured->name);
  if (!panel.others.empty()) keys += PlanKeyHtml("drawn", panel.others_name);
  if (!panel.limits.empty()) keys += PlanKeyHtml("limit", "limit");
  for (const PlanCurve& other : panel.others) content += PathSvg("drawn", frame, other);
  for (const PlanLimit& limit : panel.limits) content += LimitSvg(frame, limit);
  content += PathSvg("path", frame, panel.curve);
  if (panel.measured) content += PathSvg("logged", frame, *panel.measured);
  const std::vector<ChartColumn> columns = {{"ahead [m]", panel.curve.ahead},
                                            {"to starboard [m]", panel.curve.starboard}};
  return fmt::format(
      "<figure class=\"scatter plan\" data-columns=\"{}\"><figcaption><b>{}</b></figcaption>\n"
      "<div class=\"plan-key\">{}</div>\n"
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">{}{}</svg></figure>\n",
      HtmlText(ColumnsJson(columns)),
      HtmlText(panel.title),
      keys,
      kPlanWidth,
      kPlanTop + frame.Height() + kPlanBottom,
      HtmlText(panel.title),
      PlanAxesSvg(frame),
      content);
}

}  // namespace fathom
