// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "drawn_vehicle.h"

#include <cmath>
#include <cstddef>

#include "plain_simulator.h"

namespace fathom {

CoupledModel DrawnPlanarVehicle(std::mt19937* random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(*random);
  };
  CoupledModel model;
  model.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  model.inertia(0, 0) = between(25.0, 60.0);
  model.inertia(1, 1) = between(40.0, 90.0);
  model.inertia(5, 5) = between(3.0, 8.0);
  model.linear_damping(0, 0) = between(4.0, 12.0);
  model.linear_damping(1, 1) = between(6.0, 20.0);
  model.linear_damping(5, 5) = between(1.0, 4.0);
  model.quadratic_damping(0, 0) = between(15.0, 50.0);
  model.quadratic_damping(1, 1) = between(40.0, 90.0);
  model.quadratic_damping(5, 5) = between(2.0, 8.0);
  model.offset << between(-1.0, 1.0), between(-1.0, 1.0), 0.0, 0.0, 0.0, between(-0.2, 0.2);
  model.coriolis = true;
  return model;
}

CoupledData DrawnLog(const CoupledModel& model,
                     const DrawnLogOptions& options,
                     std::mt19937* random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(*random);
  };
  std::normal_distribution<double> normal;
  CoupledData data;
  data.log = data.inputs.log = "drawn";
  data.dofs = model.dofs;
  data.force_unit = "N";
  CoupledCommand& command = data.inputs.command;
  CoupledSegment segment;
  PlainSimulator plain(model);
  plain.current = options.current;
  const double step = 1.0 / options.rate;
  Vector6 noise = Vector6::Zero(), tau = Vector6::Zero();
  for (int i = 0; i < 6; ++i) noise[i] = options.noise * normal(*random);
  double next_change = 0.0;
  const int num = static_cast<int>(std::lround(options.duration * options.rate));
  for (int k = 0; k <= num; ++k) {
    const double t = step * k;
    segment.time.push_back(t);
    segment.velocity.push_back(plain.nu + noise);
    segment.pose_time.push_back(t);
    segment.attitude.emplace_back(plain.world_from_body);
    segment.position.push_back(plain.position);
    const double fresh = options.noise * std::sqrt(1.0 - options.colour * options.colour);
    for (int i = 0; i < 6; ++i) noise[i] = options.colour * noise[i] + fresh * normal(*random);
    if (t >= next_change - 1e-9) {
      for (const Dof dof : model.dofs)
        tau[Index(dof)] = options.force[Index(dof)] * between(-1.0, 1.0);
      command.time.push_back(t);
      command.force.push_back(tau);
      next_change = t + std::round(between(2.0, 6.0) * options.rate) / options.rate;
    }
    plain.Advance(tau, step, step / 20.0);
  }
  for (const Dof dof : model.dofs) data.has_velocity[static_cast<std::size_t>(Index(dof))] = true;
  data.segments.push_back(segment);
  return data;
}

Log LogFileOf(const CoupledData& data) {
  Log log;
  log.path = log.name = data.log;
  log.dofs = data.dofs;
  log.command.emplace();
  log.command->time = data.inputs.command.time;
  log.velocity.emplace();
  log.velocity->time = data.segments.front().time;
  for (const Dof dof : data.dofs) {
    log.command->columns.emplace_back(ForceColumn(dof));
    std::vector<double>& force = log.command->values.emplace_back();
    for (const Vector6& tau : data.inputs.command.force) force.push_back(tau[Index(dof)]);
    log.velocity->columns.emplace_back(VelocityColumn(dof));
    std::vector<double>& velocity = log.velocity->values.emplace_back();
    for (const Vector6& nu : data.segments.front().velocity) velocity.push_back(nu[Index(dof)]);
  }
  return log;
}

}  // namespace fathom
