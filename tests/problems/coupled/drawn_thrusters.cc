// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "drawn_thrusters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "plain_simulator.h"

namespace fathom {

std::vector<CommandedThruster> FourThrusters() {
  const auto thruster = [](const char* name, double x, double y, double yaw) {
    CommandedThruster made;
    made.name = name;
    made.push << x, y, 0.0, 0.0, 0.0, yaw;
    return made;
  };
  return {thruster("port", 1.0, 0.0, 0.3),
          thruster("starboard", 1.0, 0.0, -0.3),
          thruster("bow", 0.0, 1.0, 0.4),
          thruster("stern", 0.0, 1.0, -0.4)};
}

CoupledData DrawnThrusterLog(const CoupledModel& model,
                             const std::array<double, 4>& gain,
                             bool holds_heading,
                             const DrawnLogOptions& options,
                             std::mt19937* random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(*random);
  };
  std::normal_distribution<double> normal;
  CoupledData data;
  data.log = "thrusters";
  data.dofs = model.dofs;
  data.force_unit = "N";
  CoupledCommand& command = data.inputs.command;
  command.thrusters = FourThrusters();
  CoupledSegment segment;
  PlainSimulator plain(model);
  const double step = 1.0 / options.rate;
  double surge = 0.0, sway = 0.0, yaw = 0.0, heading = 0.0, next_change = 0.0;
  const int num = static_cast<int>(std::lround(options.duration * options.rate));
  for (int k = 0; k <= num; ++k) {
    const double t = step * k;
    Vector6 measured = plain.nu;
    for (const Dof dof : model.dofs) measured[Index(dof)] += options.noise * normal(*random);
    segment.time.push_back(t);
    segment.velocity.push_back(measured);
    if (t >= next_change - 1e-9) {
      surge = options.force[0] * between(-1.0, 1.0);
      sway = options.force[1] * between(-1.0, 1.0);
      yaw = options.force[5] * between(-1.0, 1.0);
      next_change = t + std::round(between(2.0, 6.0) * options.rate) / options.rate;
    }
    heading += step * plain.nu[5];
    const double moment =
        holds_heading ? std::clamp(-30.0 * heading - 15.0 * plain.nu[5], -15.0, 15.0) : yaw;
    const std::array<double, 4> thrust = {0.5 * surge + moment / 1.2,
                                          0.5 * surge - moment / 1.2,
                                          0.5 * sway + moment / 1.6,
                                          0.5 * sway - moment / 1.6};
    command.time.push_back(t);
    Vector6 tau = Vector6::Zero();
    for (std::size_t i = 0; i < thrust.size(); ++i) {
      command.thrusters[i].thrust.push_back(thrust[i]);
      tau += gain[i] * thrust[i] * command.thrusters[i].push;
    }
    plain.Advance(tau, step, step / 20.0);
  }
  for (const Dof dof : model.dofs) data.has_velocity[static_cast<std::size_t>(Index(dof))] = true;
  data.segments.push_back(segment);
  return data;
}

}  // namespace fathom
