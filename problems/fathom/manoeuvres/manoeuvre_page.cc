// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/manoeuvre_page.h"

#include "fathom/base/quantile.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kRadiansInDegrees = 180.0 / std::numbers::pi;
constexpr double kShownShare = 0.95;         // of the drawn tracks
constexpr std::size_t kMostShownDraws = 95;  // of them
constexpr double kLeastDraws = 20.0;         // for a band
constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
const std::string kPredicted = "predicted", kMeasuredName = "measured";

// What is drawn over time.
using Shown = std::function<double(const ManoeuvreTrack&, std::size_t)>;

PlanCurve PathOf(const std::string& name, const ManoeuvreTrack& track) {
  PlanCurve path;
  path.name = name;
  for (const CoupledState& state : track.state) {
    path.ahead.push_back(state.position[0]);
    path.starboard.push_back(state.position[1]);
  }
  return path;
}

// How far a drawn track goes away from the model's, at most.
double FarthestFrom(const ManoeuvreTrack& track, const ManoeuvreTrack& drawn) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < std::min(track.state.size(), drawn.state.size()); ++k) {
    farthest =
        std::max(farthest, (track.state[k].position - drawn.state[k].position).head<2>().norm());
  }
  return farthest;
}

// Those that stay nearest to the model's track; of so many as can be told apart.
std::vector<PlanCurve> ShownDraws(const ManoeuvrePrediction& report) {
  std::vector<double> farthest;
  for (const ManoeuvreTrack& drawn : report.drawn) {
    farthest.push_back(FarthestFrom(report.track, drawn));
  }
  if (farthest.empty()) return {};
  const double bound = Quantile(farthest, kShownShare);
  std::vector<PlanCurve> shown;
  for (std::size_t k = 0; k < farthest.size() && shown.size() < kMostShownDraws; ++k) {
    if (farthest[k] <= bound) shown.push_back(PathOf("", report.drawn[k]));
  }
  return shown;
}

std::vector<PlanLimit> PlanLimits(const ManoeuvrePrediction& report) {
  std::vector<PlanLimit> limits;
  for (const PredictedFigure& figure : report.figures) {
    if (!figure.limit) continue;
    if (figure.figure.name == "advance") limits.push_back({"IMO: advance", false, *figure.limit});
    if (figure.figure.name == "track_reach") {
      limits.push_back({"IMO: track reach", false, *figure.limit});
    }
    if (figure.figure.name == "tactical_diameter") {
      limits.push_back(
          {"IMO: tactical diameter", true, report.manoeuvre.first_side * *figure.limit});
    }
  }
  return limits;
}

PlanPanel PlanOf(const ManoeuvrePrediction& report) {
  PlanPanel plan;
  plan.title = "Track, seen from above";
  plan.curve = PathOf(kPredicted, report.track);
  if (report.measured) {
    // No longer than what was predicted.
    ManoeuvreTrack measured = *report.measured;
    const auto end = std::ranges::upper_bound(measured.time, report.track.time.back());
    measured.state.resize(static_cast<std::size_t>(end - measured.time.begin()));
    plan.measured = PathOf(kMeasuredName, measured);
  }
  plan.others = ShownDraws(report);
  plan.others_name = "95 % of the drawn models";
  plan.limits = PlanLimits(report);
  return plan;
}

// Half of the 95 % interval of the drawn models at a sample; NaN where too few of them still run.
double HalfWidth(const std::vector<ManoeuvreTrack>& drawn, const Shown& shown, std::size_t k) {
  std::vector<double> values;
  for (const ManoeuvreTrack& track : drawn) {
    if (k < track.time.size()) values.push_back(shown(track, k));
  }
  if (static_cast<double>(values.size()) < kLeastDraws) return kGap;
  return 0.5 * (Quantile(values, 0.975) - Quantile(values, 0.025));
}

// The measured value at the stamps of the prediction, by the nearest sample; a gap beyond its end.
Series MeasuredAt(const ManoeuvreTrack& measured,
                  const std::vector<double>& time,
                  const Shown& shown) {
  Series series;
  series.name = kMeasuredName;
  for (const double t : time) {
    const auto next = std::ranges::lower_bound(measured.time, t);
    series.values.push_back(
        next == measured.time.end()
            ? kGap
            : shown(measured, static_cast<std::size_t>(next - measured.time.begin())));
  }
  return series;
}

TimePanel OverTime(const ManoeuvrePrediction& report,
                   const std::string& quantity,
                   const std::string& unit,
                   const Shown& shown) {
  TimePanel panel;
  panel.quantity = quantity;
  panel.unit = unit;
  panel.time = report.track.time;
  panel.has_residuals = false;
  panel.is_low = true;
  if (report.measured) panel.measured = MeasuredAt(*report.measured, panel.time, shown);
  Series& predicted = panel.responses.emplace_back();
  predicted.name = kPredicted;
  for (std::size_t k = 0; k < panel.time.size(); ++k) {
    predicted.values.push_back(shown(report.track, k));
  }
  if (report.drawn.size() < static_cast<std::size_t>(kLeastDraws)) return panel;
  for (std::size_t k = 0; k < panel.time.size(); ++k) {
    const double half = HalfWidth(report.drawn, shown, k);
    predicted.half_width.push_back(std::isfinite(half) ? half : 0.0);
  }
  return panel;
}

// The headings that overshoots within the limits stay below.
void AddOvershootLimits(const ManoeuvrePrediction& report, TimePanel* panel) {
  double side = report.manoeuvre.first_side;
  for (const PredictedFigure& figure : report.figures) {
    if (!figure.figure.name.ends_with("_overshoot")) continue;
    if (figure.limit) {
      Series limit;
      limit.name = "IMO: " + figure.figure.name;
      std::ranges::replace(limit.name, '_', ' ');
      limit.values.assign(panel->time.size(),
                          side * (report.manoeuvre.heading * kRadiansInDegrees + *figure.limit));
      panel->responses.push_back(limit);
    }
    side = -side;
  }
}

std::vector<TimePanel> TimePanels(const ManoeuvrePrediction& report) {
  const auto heading = [](const ManoeuvreTrack& track, std::size_t k) {
    return track.heading[k] * kRadiansInDegrees;
  };
  const auto rudder = [](const ManoeuvreTrack& track, std::size_t k) {
    return track.fin_sign * track.angle[k] * kRadiansInDegrees;
  };
  const auto rate = [](const ManoeuvreTrack& track, std::size_t k) {
    return track.state[k].nu[5] * kRadiansInDegrees;
  };
  const auto speed = [](const ManoeuvreTrack& track, std::size_t k) {
    return track.state[k].nu[0];
  };
  std::vector<TimePanel> panels;
  const bool is_stop = report.manoeuvre.kind == Manoeuvre::Kind::kStop;
  if (is_stop) panels.push_back(OverTime(report, "speed ahead", "m/s", speed));
  panels.push_back(OverTime(report, "heading", "deg", heading));
  if (report.manoeuvre.kind == Manoeuvre::Kind::kZigzag) {
    AddOvershootLimits(report, &panels.back());
  }
  if (!is_stop) {
    panels.push_back(OverTime(report, "rudder", "deg", rudder));
    panels.back().responses.front().half_width.clear();  // jumps: no band tells it
    panels.push_back(OverTime(report, "yaw rate", "deg/s", rate));
    panels.push_back(OverTime(report, "speed ahead", "m/s", speed));
  }
  return panels;
}

// The yaw rate over the rudder, there and back.
CurvePanel LoopOf(const ManoeuvreTrack& track) {
  CurvePanel panel;
  panel.x_name = "rudder, to starboard";
  panel.x_unit = "deg";
  panel.y_name = "steady yaw rate";
  panel.y_unit = "deg/s";
  for (const SteadyTurn& turn : track.steady) {
    panel.x.push_back(turn.angle * kRadiansInDegrees);
    panel.y.push_back(turn.rate * kRadiansInDegrees);
  }
  return panel;
}

ParameterPanel FigurePanel(const PredictedFigure& figure) {
  ParameterPanel panel;
  panel.name = figure.figure.name;
  std::ranges::replace(panel.name, '_', ' ');
  panel.unit = figure.figure.unit;
  const double std = (figure.high - figure.low) / (2.0 * 1.96);
  panel.estimates.push_back({kPredicted, figure.figure.value, std > 0.0 ? std : kGap});
  if (figure.measured) panel.estimates.push_back({kMeasuredName, *figure.measured, kGap});
  panel.reference = figure.limit;
  panel.reference_name = "IMO: at most";
  return panel;
}

// "first overshoot 11.6 deg (10.6 to 12.7), measured 12.0".
std::string FigureText(const PredictedFigure& figure) {
  std::string name = figure.figure.name;
  std::ranges::replace(name, '_', ' ');
  if (!std::isfinite(figure.figure.value)) return name + " not reached";
  const double half = 0.5 * (figure.high - figure.low);
  const bool is_known = std::isfinite(half) && half > 0.0;
  const int decimals = is_known ? DecimalsFor(half) : 2;
  std::string text =
      fmt::format("{} {} {}", name, RoundedAt(figure.figure.value, decimals), figure.figure.unit);
  if (is_known) {
    text += fmt::format(
        " ({} to {})", RoundedAt(figure.low, decimals), RoundedAt(figure.high, decimals));
  }
  if (figure.measured) text += ", measured " + RoundedAt(*figure.measured, decimals);
  return text;
}

std::string LeadOf(const ManoeuvrePrediction& report) {
  const bool is_stop = report.manoeuvre.kind == Manoeuvre::Kind::kStop;
  if (!is_stop && !report.sentences.empty()) return report.sentences.front();
  std::string text;
  for (const PredictedFigure& figure : report.figures) {
    const std::string& name = figure.figure.name;
    const bool is_main = name == "tactical_diameter" || name == "advance" ||
                         name == "track_reach" || name.ends_with("_overshoot");
    if (is_main) text += (text.empty() ? "" : "; ") + FigureText(figure);
  }
  text += ".";
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

}  // namespace

Page ManoeuvrePage(const ManoeuvrePrediction& report,
                   const std::string& name,
                   const std::string& log) {
  Page page;
  page.title = name;
  page.subtitle = fmt::format("predicted, beginning as {}", log);
  page.lead = {LeadOf(report)};
  for (const std::string& sentence :
       {NoIntervalSentence(report), GearSentence(report), BeyondTheLogSentence(report)}) {
    if (!sentence.empty()) page.lead.push_back(sentence);
  }
  page.facts = {{"speed at the begin", fmt::format("{:.3g} m/s", report.ahead)},
                {"drawn models", fmt::format("{}", report.num_draws - report.num_astray)}};
  if (report.length) page.facts.push_back({"length", fmt::format("{:.4g} m", *report.length)});
  if (report.num_astray > 0) {
    page.warnings.push_back(
        fmt::format("{} of {} drawn models cannot be or diverge; the intervals are of the rest.",
                    report.num_astray,
                    report.num_draws));
  }
  if (report.manoeuvre.kind == Manoeuvre::Kind::kStop) {
    page.warnings.insert(page.warnings.end(), report.sentences.begin(), report.sentences.end());
  }
  PageSection motion;
  motion.heading = "The manoeuvre";
  motion.text = {"Angles and rates to starboard are above 0."};
  if (report.manoeuvre.kind == Manoeuvre::Kind::kSpiral) {
    motion.curve_panels.push_back(LoopOf(report.track));
  } else {
    motion.plan_panels.push_back(PlanOf(report));
  }
  motion.time_panels = TimePanels(report);
  PageSection figures;
  figures.heading = "Figures";
  figures.tables.push_back(ManoeuvreTable(report));
  for (const PredictedFigure& figure : report.figures) {
    if (std::isfinite(figure.figure.value)) figures.parameter_panels.push_back(FigurePanel(figure));
  }
  page.sections = {std::move(motion), std::move(figures)};
  page.footer =
      "Bands and bars are 95 % intervals, drawn from the covariance of the model's numbers. What "
      "the "
      "model lacks is not in them: waves, wind, shallow water.";
  return page;
}

}  // namespace fathom
