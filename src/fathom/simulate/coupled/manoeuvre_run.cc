// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/manoeuvre_run.h"

#include "fathom/simulate/coupled/attitude_angles.h"
#include "fathom/simulate/coupled/lagged.h"
#include "fathom/simulate/coupled/steering.h"
#include "fathom/simulate/coupled/steering_gear.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

constexpr double kSettleSteps = 100.0;  // over which a steady yaw rate stays
constexpr double kHeldShare = 1.0 / 3.0;
constexpr int kStepsAtOnce = 20;          // of the track, while the rudder stands
constexpr double kStandingRudder = 1e-6;  // from where it ends [rad]
// Then nothing changes but the motion itself, and steady turns alone count: longer steps will do.
constexpr double kStepsOfTrack = 5.0, kShareOfTimeConstant = 0.5;

// What drives the vehicle throughout.
CoupledInputs InputsOf(const CoupledModel& model,
                       const std::vector<CommandedFin>& fins,
                       const Manoeuvre& manoeuvre,
                       const ManoeuvreOptions& options) {
  const bool is_stop = manoeuvre.kind == Manoeuvre::Kind::kStop;
  CoupledInputs inputs;
  CoupledCommand& command = inputs.command;
  command.time = {0.0};
  Vector6 wrench = options.force;
  wrench[0] = is_stop ? -manoeuvre.astern * options.force[0] : options.force[0] - options.thrust;
  command.force = {wrench};
  // All that makes a race, as one thruster of that name.
  command.thrusters = {{"race", Vector6::Unit(0), {is_stop ? 0.0 : options.thrust}}};
  command.shafts = options.shafts;
  for (CommandedShaft& shaft : command.shafts) {
    if (is_stop) shaft.turns = {-std::sqrt(manoeuvre.astern) * shaft.turns.front()};
  }
  command.fins = fins;
  for (CommandedFin& fin : command.fins) {
    fin.angle = {0.0};
    const bool is_of_shaft = std::ranges::any_of(
        command.shafts, [&](const CommandedShaft& one) { return one.shaft.name == fin.behind; });
    if (!fin.behind.empty() && !is_of_shaft) fin.behind = "race";
  }
  const bool has_surge = std::ranges::find(model.dofs, Dof::kSurge) != model.dofs.end();
  if (!has_surge) inputs.measured[0] = {{0.0}, {options.ahead}};
  return inputs;
}

}  // namespace

double RudderRate(const CoupledModel& model,
                  const std::vector<CommandedFin>& fins,
                  const ManoeuvreOptions& options) {
  const auto rudder = RudderOf(fins);
  if (!rudder) return options.rudder_rate;
  const auto limit = model.fin_rate_limit.find(fins[*rudder].name);
  return limit == model.fin_rate_limit.end() ? options.rudder_rate
                                             : std::min(options.rudder_rate, limit->second);
}

std::optional<ManoeuvreTrack> RunManoeuvre(const CoupledModel& model,
                                           const std::vector<CommandedFin>& fins,
                                           const Manoeuvre& manoeuvre,
                                           const ManoeuvreOptions& options) {
  const bool is_stop = manoeuvre.kind == Manoeuvre::Kind::kStop;
  const auto rudder = RudderOf(fins);
  if (!rudder && !is_stop) return std::nullopt;
  // A positive angle turns to the side that the arm says.
  const double to_starboard =
      rudder && fins[*rudder].arms.across[Index(Dof::kYaw)] < 0.0 ? -1.0 : 1.0;
  CoupledInputs inputs = InputsOf(model, fins, manoeuvre, options);
  CoupledModel driven = model;
  // Those of thrusters are in options.force.
  std::erase_if(driven.thrust_gain, [&](const auto& gain) {
    return std::ranges::none_of(
        options.shafts, [&](const CommandedShaft& one) { return one.shaft.name == gain.first; });
  });
  // The rudder's is in the angle of each step; the other fins stay.
  driven.fin_rate_limit.clear();
  // A step is a run of its own and knows nothing of the last: the rudder's lag is below, thrust is
  // steady, and an offset is one of a log's clocks.
  driven.thruster_lag = driven.time_offset = 0.0;
  driven.fin_lag.clear();
  const auto lag = rudder ? model.fin_lag.find(fins[*rudder].name) : model.fin_lag.end();
  const double rudder_lag = lag == model.fin_lag.end() ? 0.0 : lag->second;
  const double rudder_rate = RudderRate(model, fins, options);
  CoupledState state;
  state.nu[0] = options.ahead;
  ManoeuvreTrack track;
  track.fin_sign = to_starboard;
  Helmsman helmsman(manoeuvre,
                    options.step,
                    options.rudder_delay,
                    kSettleSteps * options.step,
                    kHeldShare * options.longest);
  const bool is_held = !HeldOrders(manoeuvre).empty();
  double angle = 0.0, turned = 0.0, heading = 0.0;  // of the gear, and of the rudder behind it
  CoupledStamps one_step, while_it_stands;
  one_step.pose = {options.step};
  for (int k = 1; k <= kStepsAtOnce; ++k) while_it_stands.pose.push_back(options.step * k);
  CoupledOutputs outputs;
  std::size_t next = 0;  // of outputs.pose: the states that come if the rudder stands
  for (int k = 0;; ++k) {
    const double t = options.step * k;
    track.time.push_back(t);
    track.angle.push_back(to_starboard * turned);
    track.heading.push_back(heading);
    track.state.push_back(state);
    helmsman.See({t, state.nu[0], heading, state.nu[5]});
    if (helmsman.IsDone() || (!is_held && t >= options.longest)) break;
    const bool stands =
        is_held && angle == helmsman.Order() && std::abs(turned - angle) <= kStandingRudder;
    if (!stands) next = outputs.pose.size();
    if (!is_stop && !stands) {
      const double wait = std::clamp(helmsman.NextTime() - t, 0.0, options.step);
      const bool turns_within = helmsman.NextTime() < t + options.step;
      GearStep gear = TurnRudder(angle,
                                 turns_within ? helmsman.NextOrder() : helmsman.Order(),
                                 rudder_rate,
                                 turns_within ? wait : 0.0,
                                 options.step);
      const Lagged<double> lagged = {gear.mean, turned, 0.0};
      const double mean = rudder_lag > 0.0
                              ? gear.mean + rudder_lag / options.step *
                                                (turned - lagged.At(options.step, rudder_lag))
                              : gear.mean;
      inputs.command.fins[*rudder].angle = {to_starboard * mean};
      turned = rudder_lag > 0.0 ? lagged.At(options.step, rudder_lag) : gear.end;
      angle = gear.end;
    }
    if (next == outputs.pose.size()) {
      if (stands) inputs.command.fins[*rudder].angle = {to_starboard * angle};
      const CoupledStamps& stamps = stands ? while_it_stands : one_step;
      const CoupledSteps steps =
          stands ? CoupledSteps{kStepsOfTrack * options.step, kShareOfTimeConstant}
                 : CoupledSteps();
      if (!RunCoupled(driven, inputs, state, stamps, &outputs, steps)) return std::nullopt;
      next = 0;
    }
    state = outputs.pose[next++];
    heading = UnwrappedHeading(state, heading);
  }
  track.steady = helmsman.steady();
  return track;
}

}  // namespace fathom
