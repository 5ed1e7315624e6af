// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/manoeuvre_prediction.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quantile.h"
#include "fathom/base/random_stream.h"
#include "fathom/report/format_value.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/solve/covariance_factor.h"
#include "fathom/vehicle/files/thruster_shares.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kEnoughDraws = 0.8;  // of all, for an interval

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

}  // namespace

ManoeuvrePrediction PredictManoeuvre(const FittedCoupledModel& fitted,
                                     const Log& log,
                                     const Manoeuvre& manoeuvre,
                                     int num_draws,
                                     std::uint64_t seed) {
  const Vehicle vehicle = VehicleOf(log).value_or(Vehicle());
  const CoupledData data = CoupledDataOf(log, fitted.model.dofs, vehicle.thrusters, vehicle.fins);
  const std::vector<CommandedFin>& fins = data.inputs.command.fins;
  const ManoeuvreOptions options = DrivenAs(data, fitted.model);
  if (!(options.ahead > 0.0)) {
    throw InputError(
        fmt::format("{}: begins at {:.3g} m/s ahead, expected a speed above 0 for a "
                    "manoeuvre.",
                    log.path.string(),
                    options.ahead));
  }
  const auto track = RunManoeuvre(fitted.model, fins, manoeuvre, options);
  if (!track) {
    throw InputError(
        fmt::format("{}: no manoeuvre: the log holds no fin that turns the vehicle, or the model "
                    "diverges in it.",
                    log.path.string()));
  }
  ManoeuvrePrediction report = {*track, {}, num_draws, 0, options.ahead, options.rudder_rate};
  std::vector<std::vector<double>> drawn;
  for (const ManoeuvreFigure& figure : FiguresOf(manoeuvre, *track)) {
    report.figures.push_back({figure});
    drawn.emplace_back();
  }
  const Eigen::MatrixXd root = CovarianceFactor(fitted.covariance);
  RandomStream random(seed, "manoeuvre");
  for (int i = 0; i < num_draws; ++i) {
    const CoupledModel model = Drawn(fitted, root, &random);
    const auto run = RunManoeuvre(model, fins, manoeuvre, options);
    if (!run) {
      ++report.num_astray;
      continue;
    }
    const std::vector<ManoeuvreFigure> figures = FiguresOf(manoeuvre, *run);
    for (std::size_t f = 0; f < figures.size(); ++f) {
      if (std::isfinite(figures[f].value)) drawn[f].push_back(figures[f].value);
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

Table ManoeuvreTable(const ManoeuvrePrediction& report) {
  Table table;
  table.columns = {{"figure"}, {"value", true}, {"unit"}, {"95 % interval", true}};
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
