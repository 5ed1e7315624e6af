// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/helm.h"

#include "fathom/base/input_error.h"
#include "fathom/manoeuvres/logged_track.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/simulate/coupled/steering.h"
#include "fathom/vehicle/files/thruster_shares.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLeastStep = 0.1;        // [s]
constexpr double kStepsOfALength = 60.0;  // while the vehicle moves on by its length
constexpr double kMostSteps = 6000.0;

// The mean force ahead, and what of it makes a race.
void AddForces(const CoupledCommand& command, const CoupledModel& model, ManoeuvreOptions* driven) {
  const double num = static_cast<double>(command.time.size());
  for (std::size_t row = 0; row < command.time.size(); ++row) {
    if (!command.force.empty()) driven->force += command.force[row] / num;
    for (const CommandedThruster& thruster : command.thrusters) {
      const auto gain = model.thrust_gain.find(thruster.name);
      driven->force += (gain == model.thrust_gain.end() ? 1.0 : gain->second) *
                       thruster.thrust[row] * thruster.push / num;
    }
    for (const CommandedFin& fin : command.fins) {
      if (!fin.behind.empty()) {
        driven->thrust = std::max(driven->thrust, 0.0) + RaceThrust(command, fin, row) / num;
        break;
      }
    }
  }
  // Along the track only: no steady turn.
  driven->force.tail<5>().setZero();
}

// The shafts at their mean turns, what they give at the log's first speed, and the race of the
// first fin that stands in one.
void AddMeanShafts(const CoupledCommand& command, const CoupledModel& model, Helm* helm) {
  const double num = static_cast<double>(command.time.size());
  CoupledCommand mean;
  for (const CommandedShaft& shaft : command.shafts) {
    const double turns = std::accumulate(shaft.turns.begin(), shaft.turns.end(), 0.0) / num;
    helm->driven.shafts.push_back(shaft);
    helm->driven.shafts.back().turns = {turns};
  }
  mean.shafts = helm->driven.shafts;
  const Vector6 ahead = helm->driven.ahead * Vector6::Unit(0);
  helm->thrust = helm->driven.force[0] + ShaftForces(mean, 0, ahead, model)[0];
  helm->race = helm->driven.thrust;
  for (const CommandedFin& fin : command.fins) {
    if (fin.behind.empty()) continue;
    for (const std::size_t k : RaceShafts(command, fin)) {
      const CommandedShaft& shaft = mean.shafts[k];
      helm->race += ShaftThrustAt(shaft.shaft, shaft.turns.front(), shaft.push.dot(ahead)).thrust;
    }
    break;
  }
  helm->race = std::max(helm->race, 0.0);
}

// The quickest that any fin ever is; infinite if none moves.
double QuickestFin(const CoupledCommand& command) {
  double quickest = 0.0;
  for (const CommandedFin& fin : command.fins) {
    for (std::size_t row = 1; row < fin.angle.size(); ++row) {
      const double step = command.time[row] - command.time[row - 1];
      quickest = std::max(quickest, std::abs(fin.angle[row] - fin.angle[row - 1]) / step);
    }
  }
  return quickest > 0.0 ? quickest : std::numeric_limits<double>::infinity();
}

}  // namespace

Helm HelmOf(const CoupledModel& model, const Log& log) {
  const Vehicle vehicle = VehicleOf(log).value_or(Vehicle());
  const CoupledData data =
      CoupledDataOf(log, model.dofs, vehicle.thrusters, vehicle.fins, vehicle.shafts);
  Helm helm;
  helm.fins = data.inputs.command.fins;
  ManoeuvreOptions& driven = helm.driven;
  driven.ahead = MeasuredState(data.segments.front(), 0).nu[0];
  if (!(driven.ahead > 0.0)) {
    throw InputError(
        fmt::format("{}: begins at {:.3g} m/s ahead, expected a speed above 0 for a "
                    "manoeuvre.",
                    log.path.string(),
                    driven.ahead));
  }
  AddForces(data.inputs.command, model, &driven);
  AddMeanShafts(data.inputs.command, model, &helm);
  if (vehicle.size) {
    helm.length = vehicle.size->x();
    driven.step = std::max(kLeastStep, *helm.length / driven.ahead / kStepsOfALength);
  }
  driven.longest = kMostSteps * driven.step;
  driven.rudder_rate = QuickestFin(data.inputs.command);
  if (const auto rudder = RudderOf(helm.fins)) {
    helm.logged = LoggedTrack(data, *rudder);
    if (helm.logged) helm.gear = GearOf(*helm.logged);
  }
  if (helm.gear && std::isfinite(helm.gear->rate)) driven.rudder_rate = helm.gear->rate;
  if (helm.gear && helm.gear->IsZigzag()) driven.rudder_delay = helm.gear->delay;
  return helm;
}

}  // namespace fathom
