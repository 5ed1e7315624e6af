// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/block_fit.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "drawn_vehicle.h"
#include "plain_simulator.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kRudderForce = 30.0;  // f [N s^2/m^2 a radian]

FinArms RudderArms() {
  Fin fin;
  fin.position << -0.8, 0.0, 0.0;
  return ArmsOf(fin);
}

// A survey AUV in the plane: thrust ahead and a rudder that steps.
CoupledModel DrawnSurveyVehicle(std::mt19937* random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(*random);
  };
  CoupledModel model = DrawnPlanarVehicle(random);
  model.offset.setZero();
  model.lift(1, 1) = between(20.0, 40.0);
  model.lift(1, 5) = between(-10.0, 0.0);
  model.lift(5, 1) = between(-8.0, 8.0);
  model.lift(5, 5) = between(4.0, 10.0);
  model.fin_force = {{"rudder", kRudderForce}};
  return model;
}

double RateOfRudder(const CoupledModel& model) {
  const auto limit = model.fin_rate_limit.find("rudder");
  return limit == model.fin_rate_limit.end() ? std::numeric_limits<double>::infinity()
                                             : limit->second;
}

// 150 s at 10 Hz, white noise, by another integrator than Fathom's and the law by angles.
CoupledData DrawnSurveyLog(const CoupledModel& model, std::mt19937* random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(*random);
  };
  std::normal_distribution<double> noise(0.0, 0.003);
  CoupledData data;
  data.log = "survey";
  data.dofs = model.dofs;
  data.force_unit = "N";
  data.has_velocity[0] = data.has_velocity[1] = data.has_velocity[5] = true;
  CoupledCommand& command = data.inputs.command;
  command.fins = {{"rudder", RudderArms(), {}}};
  CoupledSegment segment;
  PlainSimulator plain(model);
  plain.nu[0] = 1.0;
  Vector6 tau = Vector6::Zero();
  double commanded = 0.0, angle = 0.0, next_change = 0.0;
  plain.more = [&](const Vector6& nu) {
    const double u = nu[0], w = nu[1] - 0.8 * nu[5];
    const double load = kRudderForce * (u * u + w * w) * std::sin(angle - std::atan2(w, u));
    Vector6 force = Vector6::Zero();
    force[0] = -load * std::sin(angle);
    force[1] = load * std::cos(angle) - u * (model.lift(1, 1) * nu[1] + model.lift(1, 5) * nu[5]);
    force[5] =
        -0.8 * load * std::cos(angle) - u * (model.lift(5, 1) * nu[1] + model.lift(5, 5) * nu[5]);
    return force;
  };
  for (int k = 0; k <= 1500; ++k) {
    const double t = 0.1 * k;
    Vector6 measured = plain.nu;
    for (const Dof dof : model.dofs) measured[Index(dof)] += noise(*random);
    segment.time.push_back(t);
    segment.velocity.push_back(measured);
    if (t >= next_change - 1e-9) {
      tau[0] = between(20.0, 60.0);
      commanded = between(-0.4, 0.4);
      command.time.push_back(t);
      command.force.push_back(tau);
      command.fins[0].angle.push_back(commanded);
      next_change = t + std::round(10.0 * between(2.0, 6.0)) / 10.0;
    }
    for (int step = 0; step < 20; ++step) {
      const double most = 0.005 * RateOfRudder(model);
      angle += std::clamp(commanded - angle, -most, most);
      plain.Advance(tau, 0.005, 0.005);
    }
  }
  data.segments.push_back(segment);
  return data;
}

// Within four standard deviations of the truth: of the lift terms, with the rudder's force known.
TEST(FitCoupled, FindsTheLiftOfASurveyVehicle) {
  std::mt19937 random(31);
  const CoupledModel truth = DrawnSurveyVehicle(&random);
  CoupledLogs logs;
  logs.data = {DrawnSurveyLog(truth, &random)};
  CoupledFitOptions options;
  options.held.fin_force = truth.fin_force;
  const MotionStructure structure =
      StructureOf(StandardStructure::kLift, truth.dofs, {{"rudder", true, false}});
  const CoupledSummary fit = FitBlocks(logs, structure, options);
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  for (std::size_t k = 0; k < fit.entries.size(); ++k) {
    const FreeEntry& entry = fit.entries[k];
    const double std =
        std::sqrt(fit.covariance(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)));
    EXPECT_NEAR(ValueIn(fit.model, entry), ValueIn(truth, entry), 4.0 * std) << NameOf(entry);
    if (entry.kind == FreeEntry::Kind::kInertia) {
      EXPECT_LT(std, 0.1 * ValueIn(truth, entry)) << NameOf(entry);
    }
  }
}

// From a start that knows of no limit.
TEST(FitCoupled, FindsTheLimitedRateOfARudder) {
  std::mt19937 random(32);
  CoupledModel truth = DrawnSurveyVehicle(&random);
  truth.fin_rate_limit = {{"rudder", 0.25}};
  CoupledLogs logs;
  logs.data = {DrawnSurveyLog(truth, &random)};
  CoupledFitOptions options;
  options.held.fin_force = truth.fin_force;
  MotionStructure structure =
      StructureOf(StandardStructure::kLift, truth.dofs, {{"rudder", true, false}});
  structure.entries.push_back(FinRateLimitEntry("rudder"));
  const CoupledSummary fit = FitBlocks(logs, structure, options);
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  const auto last = fit.covariance.rows() - 1;
  const double std = std::sqrt(fit.covariance(last, last));
  EXPECT_NEAR(fit.model.fin_rate_limit.at("rudder"), 0.25, 4.0 * std);
  EXPECT_LT(std, 0.01);
}

}  // namespace
}  // namespace fathom
