// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/manoeuvre_prediction.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quantile.h"
#include "fathom/base/random_stream.h"
#include "fathom/report/format_value.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/simulate/coupled/steering.h"
#include "fathom/solve/covariance_factor.h"
#include "fathom/vehicle/files/thruster_shares.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kEnoughDraws = 0.8;    // of all, for an interval
constexpr double kFreshWater = 1000.0;  // [kg/m^3], as docs/fins.md (1)

// How the log drives the vehicle in the mean: forces, and what of them makes a race.
ManoeuvreOptions DrivenAs(const CoupledData& data, const CoupledModel& model) {
  ManoeuvreOptions options;
  const CoupledCommand& command = data.inputs.command;
  const double num = static_cast<double>(command.time.size());
  for (std::size_t row = 0; row < command.time.size(); ++row) {
    if (!command.force.empty()) options.force += command.force[row] / num;
    for (const CommandedThruster& thruster : command.thrusters) {
      const auto gain = model.thrust_gain.find(thruster.name);
      options.force += (gain == model.thrust_gain.end() ? 1.0 : gain->second) *
                       thruster.thrust[row] * thruster.push / num;
    }
    for (const CommandedFin& fin : command.fins) {
      if (!fin.behind.empty()) {
        options.thrust = std::max(options.thrust, 0.0) + RaceThrust(command, fin, row) / num;
        break;
      }
    }
  }
  // Along the track only: no steady turn.
  options.force.tail<5>().setZero();
  double quickest = 0.0;
  for (const CommandedFin& fin : command.fins) {
    for (std::size_t row = 1; row < fin.angle.size(); ++row) {
      const double step = command.time[row] - command.time[row - 1];
      quickest = std::max(quickest, std::abs(fin.angle[row] - fin.angle[row - 1]) / step);
    }
  }
  if (quickest > 0.0) options.rudder_rate = quickest;
  options.ahead = MeasuredState(data.segments.front(), 0).nu[0];
  return options;
}

CoupledModel Drawn(const FittedCoupledModel& fitted,
                   const Eigen::MatrixXd& root,
                   RandomStream* random) {
  Eigen::VectorXd normal(root.cols());
  for (double& value : normal) value = random->Normal();
  const Eigen::VectorXd move = root * normal;
  CoupledModel model = fitted.model;
  for (std::size_t k = 0; k < fitted.entries.size(); ++k) {
    const FreeEntry& entry = fitted.entries[k];
    SetValue(entry, ValueIn(model, entry) + move[static_cast<Eigen::Index>(k)], &model);
  }
  return model;
}

// How a log's vehicle is steered and driven.
struct Helm {
  std::vector<CommandedFin> fins;
  ManoeuvreOptions driven;
};

Helm HelmOf(const CoupledModel& model, const Log& log) {
  const Vehicle vehicle = VehicleOf(log).value_or(Vehicle());
  const CoupledData data = CoupledDataOf(log, model.dofs, vehicle.thrusters, vehicle.fins);
  Helm helm = {data.inputs.command.fins, DrivenAs(data, model)};
  if (!(helm.driven.ahead > 0.0)) {
    throw InputError(
        fmt::format("{}: begins at {:.3g} m/s ahead, expected a speed above 0 for a "
                    "manoeuvre.",
                    log.path.string(),
                    helm.driven.ahead));
  }
  return helm;
}

using Figures = std::optional<std::vector<ManoeuvreFigure>>;

// The figures of a model, which it has, with the intervals of models drawn from its covariance.
ManoeuvrePrediction WithIntervals(const FittedCoupledModel& fitted,
                                  const std::function<Figures(const CoupledModel&)>& figures_of,
                                  int num_draws,
                                  std::uint64_t seed) {
  ManoeuvrePrediction report;
  report.num_draws = num_draws;
  std::vector<std::vector<double>> drawn;
  const Figures of_model = figures_of(fitted.model);
  for (const ManoeuvreFigure& figure : *of_model) {
    report.figures.push_back({figure});
    drawn.emplace_back();
  }
  const Eigen::MatrixXd root = CovarianceFactor(fitted.covariance);
  RandomStream random(seed, "manoeuvre");
  for (int i = 0; i < num_draws; ++i) {
    const Figures figures = figures_of(Drawn(fitted, root, &random));
    if (!figures) {
      ++report.num_astray;
      continue;
    }
    for (std::size_t f = 0; f < figures->size(); ++f) {
      if (std::isfinite((*figures)[f].value)) drawn[f].push_back((*figures)[f].value);
    }
  }
  for (std::size_t f = 0; f < drawn.size(); ++f) {
    PredictedFigure& prediction = report.figures[f];
    prediction.low = prediction.high = std::numeric_limits<double>::quiet_NaN();
    if (static_cast<double>(drawn[f].size()) < kEnoughDraws * num_draws || drawn[f].empty())
      continue;
    prediction.low = Quantile(drawn[f], 0.025);
    prediction.high = Quantile(drawn[f], 0.975);
  }
  return report;
}

// `length`: of the vehicle [m]; then all are divided by rho/2 and powers of length and speed.
std::vector<ManoeuvreFigure> DerivativesOf(const SteeringEquations& equations,
                                           double ahead,
                                           std::optional<double> length) {
  std::vector<ManoeuvreFigure> figures;
  const auto add = [&](std::string name,
                       double value,
                       std::string unit,
                       int power_of_length,
                       int power_of_speed,
                       double density = 0.5 * kFreshWater) {
    if (length) {
      value /= density * std::pow(*length, power_of_length) * std::pow(ahead, power_of_speed);
      name = name.find(' ') == std::string::npos ? name + "'" : "(" + name + ")'";
      unit = "-";
    }
    figures.push_back({std::move(name), value, std::move(unit)});
  };
  const Eigen::MatrixXd &M = equations.inertia, &F = equations.force;
  const Eigen::Index yaw = M.rows() - 1;
  if (equations.HasSway()) {
    add("Y_v", F(0, 0), "kg/s", 2, 1);
    add("Y_r - m u", F(0, yaw), "kg m/s", 3, 1);
    add("Y_delta", equations.rudder[0], "N/rad", 2, 2);
    add("N_v", F(yaw, 0), "kg m/s", 3, 1);
  }
  add("N_r - m x_G u", F(yaw, yaw), "kg m^2/s", 4, 1);
  add("N_delta", equations.rudder[yaw], "N m/rad", 3, 2);
  if (equations.HasSway()) {
    add("m - Y_vdot", M(0, 0), "kg", 3, 0);
    add("m x_G - Y_rdot", M(0, yaw), "kg m", 4, 0);
  }
  add("I_z - N_rdot", M(yaw, yaw), "kg m^2", 5, 0);
  const Nomoto nomoto = NomotoOf(equations);
  add("K", nomoto.K, "1/s", -1, 1, 1.0);
  add("T", nomoto.T, "s", 1, -1, 1.0);
  add("growth_rate", nomoto.growth_rate, "1/s", -1, 1, 1.0);
  return figures;
}

}  // namespace

ManoeuvrePrediction PredictManoeuvre(const FittedCoupledModel& fitted,
                                     const Log& log,
                                     const Manoeuvre& manoeuvre,
                                     int num_draws,
                                     std::uint64_t seed) {
  const Helm helm = HelmOf(fitted.model, log);
  const auto track = RunManoeuvre(fitted.model, helm.fins, manoeuvre, helm.driven);
  if (!track) {
    throw InputError(
        fmt::format("{}: no manoeuvre: the log holds no fin that turns the vehicle, or the model "
                    "diverges in it.",
                    log.path.string()));
  }
  ManoeuvrePrediction report = WithIntervals(
      fitted,
      [&](const CoupledModel& model) -> Figures {
        const auto run = RunManoeuvre(model, helm.fins, manoeuvre, helm.driven);
        if (!run) return {};
        return FiguresOf(manoeuvre, *run);
      },
      num_draws,
      seed);
  report.track = *track;
  report.ahead = helm.driven.ahead;
  report.rudder_rate = helm.driven.rudder_rate;
  if (const auto vehicle = VehicleOf(log); vehicle && vehicle->size) {
    for (PredictedFigure& figure : report.figures) {
      figure.limit = ImoLimit(manoeuvre, figure.figure.name, vehicle->size->x(), report.ahead);
    }
  }
  return report;
}

SteeringUnits ParseSteeringUnits(std::string_view text) {
  if (text == "si") return SteeringUnits::kSi;
  if (text == "prime") return SteeringUnits::kPrime;
  throw InputError(fmt::format("--table: is '{}', expected si or prime.", text));
}

ManoeuvrePrediction PredictSteering(const FittedCoupledModel& fitted,
                                    const Log& log,
                                    SteeringUnits units,
                                    int num_draws,
                                    std::uint64_t seed) {
  const Helm helm = HelmOf(fitted.model, log);
  std::optional<double> length;
  if (units == SteeringUnits::kPrime) {
    const auto vehicle = VehicleOf(log);
    if (!vehicle || !vehicle->size) {
      throw InputError(
          fmt::format("{}: its vehicle has no `size`, expected one for --table=prime: forces are "
                      "divided by its length.",
                      log.path.string()));
    }
    length = vehicle->size->x();
  }
  const double ahead = helm.driven.ahead;
  const auto figures = [&](const CoupledModel& model) -> Figures {
    const auto equations = SteeringOf(model, helm.fins, ahead, helm.driven.thrust);
    if (!equations) return {};
    return DerivativesOf(*equations, ahead, length);
  };
  if (!figures(fitted.model)) {
    throw InputError(
        fmt::format("{}: no derivatives: the log holds no fin that turns the vehicle, or the model "
                    "moves no yaw.",
                    log.path.string()));
  }
  ManoeuvrePrediction report = WithIntervals(fitted, figures, num_draws, seed);
  report.ahead = ahead;
  return report;
}

Table ManoeuvreTable(const ManoeuvrePrediction& report) {
  Table table;
  table.columns = {{"figure"}, {"value", true}, {"unit"}, {"95 % interval", true}};
  const bool has_limit = std::ranges::any_of(
      report.figures, [](const PredictedFigure& figure) { return figure.limit.has_value(); });
  if (has_limit) table.columns.push_back({"IMO: at most", true});
  for (const PredictedFigure& prediction : report.figures) {
    const double half = 0.5 * (prediction.high - prediction.low);
    const bool is_known = std::isfinite(half) && half > 0.0;
    const int decimals = is_known ? DecimalsFor(half) : 3;
    const auto text = [&](double value) {
      return std::isfinite(value) ? RoundedAt(value, decimals) : std::string("-");
    };
    table.rows.push_back(
        {{prediction.figure.name,
          text(prediction.figure.value),
          prediction.figure.unit,
          is_known ? fmt::format("{} ... {}", text(prediction.low), text(prediction.high)) : "-"}});
    if (has_limit) {
      table.rows.back().cells.push_back(prediction.limit ? fmt::format("{:.1f}", *prediction.limit)
                                                         : "-");
    }
  }
  return table;
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
