// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "boat_trial.h"

#include "fathom/coupled/coupled_identification.h"

#include <cmath>
#include <random>

#include "drawn_vehicle.h"
#include "plain_simulator.h"
#include <gtest/gtest.h>

namespace fathom {

DrawnBoat DrawBoat(unsigned seed, double colour) {
  std::mt19937 random(seed);
  DrawnBoat boat = {DrawnPlanarVehicle(&random), {}};
  DrawnLogOptions options;
  options.duration = 60.0;
  options.noise = kBoatNoise;
  options.colour = colour;
  CoupledIdentificationOptions how;
  how.dofs = boat.truth.dofs;
  how.structure = StandardStructure::kCoriolis;
  CoupledIdentification found =
      IdentifyCoupled({LogFileOf(DrawnLog(boat.truth, options, &random))}, how);
  EXPECT_TRUE(found.is_usable) << found.message;
  boat.fitted = found.fitted;
  return boat;
}

CoupledPlanRequest BoatRequest(const DrawnBoat& boat, double duration, double effort) {
  CoupledPlanRequest request;
  request.model = boat.fitted;
  request.name = "boat.json";
  request.limits_name = "lake.yaml";
  request.limits.force = {40.0, 40.0, 0.0, 0.0, 0.0, 8.0};
  request.limits.speed[0] = 0.8;
  request.limits.speed[1] = 0.6;
  request.limits.speed[5] = 0.8;
  request.limits.room[0] = request.limits.room[1] = {-8.0, 8.0};
  request.duration = duration;
  request.effort = effort;
  return request;
}

CoupledData PlayedLog(const CoupledModel& truth,
                      const CoupledCommand& command,
                      double duration,
                      double noise,
                      unsigned seed,
                      double colour) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  CoupledData data;
  data.log = "played";
  data.dofs = truth.dofs;
  data.force_unit = "N";
  data.inputs.command = command;
  CoupledSegment& segment = data.segments.emplace_back();
  PlainSimulator plain(truth);
  std::size_t row = 0;
  Vector6 error;
  for (double& value : error) value = noise * normal(random);
  for (int k = 0; k <= std::lround(10.0 * duration); ++k) {
    const double t = 0.1 * k;
    const Vector6 shown = plain.nu + error;
    for (double& value : error) {
      value = colour * value + std::sqrt(1.0 - colour * colour) * noise * normal(random);
    }
    segment.time.push_back(t);
    segment.velocity.push_back(shown);
    segment.pose_time.push_back(t);
    segment.position.push_back(plain.position);
    while (row + 1 < command.time.size() && command.time[row + 1] <= t + 1e-9) ++row;
    plain.Advance(command.force[row], 0.1, 0.005);
  }
  for (const Dof dof : truth.dofs) data.has_velocity[static_cast<std::size_t>(Index(dof))] = true;
  return data;
}

}  // namespace fathom
