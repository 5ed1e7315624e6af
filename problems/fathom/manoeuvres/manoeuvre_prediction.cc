// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/manoeuvre_prediction.h"

#include "fathom/base/input_error.h"
#include "fathom/base/parallel_for.h"
#include "fathom/manoeuvres/drawn_figures.h"
#include "fathom/manoeuvres/helm.h"
#include "fathom/manoeuvres/measured_manoeuvre.h"
#include "fathom/manoeuvres/missing_figures.h"
#include "fathom/manoeuvres/straight_track.h"
#include "fathom/simulate/coupled/imo_limit.h"
#include "fathom/simulate/coupled/steering.h"
#include "fathom/vehicle/files/thruster_shares.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

// Figures with the intervals of what drawn models give.
std::vector<PredictedFigure> WithIntervals(const std::vector<ManoeuvreFigure>& figures,
                                           const std::vector<ManoeuvreFigures>& drawn) {
  const std::vector<FigureInterval> intervals = IntervalsOf(drawn, figures.size());
  std::vector<PredictedFigure> predicted;
  for (std::size_t f = 0; f < figures.size(); ++f) {
    predicted.push_back({.figure = figures[f], .low = intervals[f].low, .high = intervals[f].high});
  }
  return predicted;
}

int NumAstray(const std::vector<ManoeuvreFigures>& drawn) {
  return static_cast<int>(std::ranges::count_if(
      drawn, [](const ManoeuvreFigures& figures) { return !figures.has_value(); }));
}

void RequireThrust(const FittedCoupledModel& fitted, const Helm& helm, const Log& log) {
  const std::vector<Dof>& dofs = fitted.model.dofs;
  if (std::ranges::find(dofs, Dof::kSurge) == dofs.end()) {
    throw InputError(
        "--manoeuvre=stop: the model moves no surge, expected one of --dofs=surge,sway,yaw: what "
        "stops a vehicle is its thrust.");
  }
  if (helm.thrust > 0.0) return;
  throw InputError(
      fmt::format("{}: no propulsion: its mean force ahead is {:.3g}, expected one above 0 from "
                  "tau_surge, thrusters or shafts for --manoeuvre=stop.",
                  log.path.string(),
                  helm.thrust));
}

// A warning where the model's offset acts like thrust: logs that never slow down do not tell it
// from resistance.
std::vector<std::string> OffsetSentences(const CoupledModel& model, const Helm& helm) {
  constexpr double kMuch = 0.1;  // of the thrust
  const double offset = -model.offset[0], thrust = helm.thrust;
  if (std::abs(offset) < kMuch * thrust) return {};
  return {fmt::format(
      "The model's offset pushes {} with {:.2g} N throughout, beside a thrust of {:.2g} N. Do not "
      "believe this stop: only logs that speed up and slow down tell the offset from resistance.",
      offset > 0.0 ? "ahead" : "astern",
      std::abs(offset),
      thrust)};
}

// What the log measured of this manoeuvre, beside the figures.
void AddMeasured(const Helm& helm, ManoeuvrePrediction* report) {
  if (!helm.logged) return;
  report->measured = MeasuredManoeuvre(*helm.logged, helm.gear, report->manoeuvre);
  if (!report->measured) return;
  const auto measured = FiguresOf(report->manoeuvre, *report->measured);
  for (std::size_t f = 0; f < measured.size(); ++f) {
    if (std::isfinite(measured[f].value)) report->figures[f].measured = measured[f].value;
  }
}

// "13.2 deg/s".
std::string RateText(double rate) {
  return fmt::format("{:.3g} deg/s", rate * 180.0 / std::numbers::pi);
}

void RequireRudder(const Helm& helm, const Log& log) {
  if (RudderOf(helm.fins)) return;
  throw InputError(fmt::format(
      "{}: no fin turns the vehicle, expected a rudder in its vehicle file and its angle "
      "as fin_<name> in command.csv: docs/fins.md.",
      log.path.string()));
}

// Throws InputError if the rudder does not turn so far.
void RequireReachable(const Manoeuvre& manoeuvre, const CommandedFin& rudder, const Log& log) {
  const Vehicle vehicle = VehicleOf(log).value_or(Vehicle());
  for (const Fin& fin : vehicle.fins) {
    if (fin.name != rudder.name || !fin.largest_angle) continue;
    if (manoeuvre.angle <= *fin.largest_angle) continue;
    throw InputError(
        fmt::format("--manoeuvre: turns the rudder by {:g} degrees, expected at most {:.3g}, the "
                    "`largest_angle` of {} in the vehicle file of {}.",
                    manoeuvre.angle * 180.0 / std::numbers::pi,
                    *fin.largest_angle * 180.0 / std::numbers::pi,
                    fin.name,
                    log.path.string()));
  }
}

// The largest angle of the rudder in the log [rad].
double LoggedAngleOf(const Helm& helm) {
  const auto rudder = RudderOf(helm.fins);
  if (!rudder) return 0.0;
  double largest = 0.0;
  for (const double angle : helm.fins[*rudder].angle) {
    largest = std::max(largest, std::abs(angle));
  }
  return largest;
}

}  // namespace

ManoeuvrePrediction PredictManoeuvre(const FittedCoupledModel& fitted,
                                     const Log& log,
                                     const Manoeuvre& manoeuvre,
                                     const ManoeuvreDraws& draws,
                                     std::optional<double> rudder_delay) {
  Helm helm = HelmOf(fitted.model, log);
  if (manoeuvre.kind == Manoeuvre::Kind::kStop) {
    RequireThrust(fitted, helm, log);
  } else {
    RequireRudder(helm, log);
    RequireReachable(manoeuvre, helm.fins[*RudderOf(helm.fins)], log);
  }
  if (rudder_delay) helm.driven.rudder_delay = *rudder_delay;
  auto track = RunManoeuvre(fitted.model, helm.fins, manoeuvre, helm.driven);
  if (!track) {
    throw InputError(
        fmt::format("{}: no manoeuvre: the model diverges in it. Try a smaller angle, or fit the "
                    "model to a log that holds such turns.",
                    log.path.string()));
  }
  const std::vector<CoupledModel> models = DrawModels(fitted, draws.count, draws.seed);
  const bool keeps_tracks = HeldOrders(manoeuvre).empty();
  std::vector<ManoeuvreFigures> drawn(models.size());
  std::vector<ManoeuvreTrack> tracks(models.size());
  ParallelFor(draws.count, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    auto run = RunManoeuvre(models[k], helm.fins, manoeuvre, helm.driven);
    if (!run) return;
    drawn[k] = FiguresOf(manoeuvre, *run);
    if (keeps_tracks) tracks[k] = std::move(*run);
  });
  std::erase_if(tracks, [](const ManoeuvreTrack& one) { return one.time.empty(); });

  ManoeuvrePrediction report;
  report.manoeuvre = manoeuvre;
  const auto figures = FiguresOf(manoeuvre, *track);
  report.figures = WithIntervals(figures, drawn);
  report.sentences = StraightTrackSentences(manoeuvre, figures, drawn);
  if (manoeuvre.kind == Manoeuvre::Kind::kStop) {
    report.sentences = OffsetSentences(fitted.model, helm);
  }
  for (std::string& sentence : MissingFigureSentences(manoeuvre, *track, figures)) {
    report.sentences.insert(report.sentences.begin(), std::move(sentence));
  }
  report.track = std::move(*track);
  report.drawn = std::move(tracks);
  report.gear = helm.gear;
  report.num_draws = draws.count;
  report.num_astray = NumAstray(drawn);
  report.ahead = helm.driven.ahead;
  report.rudder_rate = RudderRate(fitted.model, helm.fins, helm.driven);
  report.rudder_delay = helm.driven.rudder_delay;
  report.logged_angle = LoggedAngleOf(helm);
  report.length = helm.length;
  AddMeasured(helm, &report);
  if (helm.length) {
    for (PredictedFigure& figure : report.figures) {
      figure.limit = ImoLimit(manoeuvre, figure.figure.name, *helm.length, report.ahead);
    }
  }
  return report;
}

ManoeuvrePrediction PredictSteering(const FittedCoupledModel& fitted,
                                    const Log& log,
                                    SteeringUnits units,
                                    const ManoeuvreDraws& draws) {
  const Helm helm = HelmOf(fitted.model, log);
  RequireRudder(helm, log);
  std::optional<double> length;
  if (units == SteeringUnits::kPrime) {
    if (!helm.length) {
      throw InputError(
          fmt::format("{}: its vehicle has no `size`, expected one for --table=prime: forces are "
                      "divided by its length.",
                      log.path.string()));
    }
    length = helm.length;
  }
  const double ahead = helm.driven.ahead;
  const auto figures_of = [&](const CoupledModel& model) -> ManoeuvreFigures {
    const auto equations = SteeringOf(model, helm.fins, ahead, helm.race);
    if (!equations) return {};
    return DerivativesOf(*equations, ahead, length);
  };
  const ManoeuvreFigures figures = figures_of(fitted.model);
  if (!figures) {
    throw InputError(fmt::format(
        "{}: no derivatives: the model moves no yaw, expected one that does.", log.path.string()));
  }
  std::vector<ManoeuvreFigures> drawn;
  for (const CoupledModel& model : DrawModels(fitted, draws.count, draws.seed)) {
    drawn.push_back(figures_of(model));
  }
  ManoeuvrePrediction report;
  report.figures = WithIntervals(*figures, drawn);
  if (fitted.force_unit != "N") {
    report.sentences.push_back(
        fmt::format("No force of this log is in newtons: for N read units of fin_force.{}. Ratios "
                    "hold, and so do K and T.",
                    fitted.force_unit));
  }
  const std::vector<Dof>& modelled = fitted.model.dofs;
  if (std::ranges::find(modelled, Dof::kSway) == modelled.end()) {
    report.sentences.push_back(
        "Sway is not in this model: K and T hold for a vessel that hardly drifts. A ship's K can "
        "come out at less than half. Where sway is measured, identify --dofs=surge,sway,yaw.");
  }
  report.num_draws = draws.count;
  report.num_astray = NumAstray(drawn);
  report.ahead = ahead;
  return report;
}

std::string GearSentence(const ManoeuvrePrediction& report) {
  if (report.manoeuvre.kind == Manoeuvre::Kind::kStop || report.track.time.empty()) return "";
  std::string text = std::isfinite(report.rudder_rate)
                         ? fmt::format("The rudder turns at {}", RateText(report.rudder_rate))
                         : std::string("The rudder turns at once");
  // Of ships 2 to 5 deg/s are usual, of small boats 30.
  constexpr double kQuickestGear = 60.0 * std::numbers::pi / 180.0;
  const std::string_view on_gear =
      report.rudder_rate > kQuickestGear
          ? " This is how quickly the log's commands change. A real steering gear is slower, and "
            "overshoots will be larger."
          : "";
  if (report.manoeuvre.kind != Manoeuvre::Kind::kZigzag) return fmt::format("{}.{}", text, on_gear);
  text += fmt::format(", {:.2f} s after the heading reaches the order", report.rudder_delay);
  if (report.gear && report.gear->IsZigzag() && report.rudder_delay == report.gear->delay) {
    text += fmt::format(" (measured: {} strokes at {:g} degrees, {:.2f} to {:.2f} s)",
                        report.gear->num_strokes,
                        report.gear->heading * 180.0 / std::numbers::pi,
                        report.gear->least_delay,
                        report.gear->most_delay);
  }
  return fmt::format("{}.{}", text, on_gear);
}

std::string NoIntervalSentence(const ManoeuvrePrediction& report) {
  const bool all_have_one = std::ranges::all_of(report.figures, [](const PredictedFigure& figure) {
    return std::isnan(figure.figure.value) || std::isfinite(figure.low);
  });
  if (all_have_one || report.num_draws == 0) return "";
  return fmt::format(
      "A figure has no interval where fewer than {:g} % of the {} drawn models come so far: the "
      "log "
      "leaves too much open.",
      100.0 * kEnoughDraws,
      report.num_draws);
}

std::string BeyondTheLogSentence(const ManoeuvrePrediction& report) {
  constexpr double kBeyond = 1.1;  // of the log's: less is noise
  if (report.manoeuvre.angle <= kBeyond * report.logged_angle) return "";
  return fmt::format(
      "The log's rudder goes to {:.3g} degrees. Beyond it the model extrapolates, which the "
      "intervals do not count.",
      report.logged_angle * 180.0 / std::numbers::pi);
}

std::string ManoeuvreCsv(const ManoeuvrePrediction& report) {
  std::string csv = "t,x,y,heading,rudder,u,v,r\n";
  const ManoeuvreTrack& track = report.track;
  for (std::size_t k = 0; k < track.time.size(); ++k) {
    const CoupledState& state = track.state[k];
    csv += fmt::format("{},{},{},{},{},{},{},{}\n",
                       track.time[k],
                       state.position[0],
                       state.position[1],
                       track.heading[k],
                       track.angle[k],
                       state.nu[0],
                       state.nu[1],
                       state.nu[5]);
  }
  return csv;
}

}  // namespace fathom
