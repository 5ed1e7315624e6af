// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/force_response.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

class ForceResponses : public testing::TestWithParam<bool> {
 protected:
  ForceResponses() {
    SurgeRun run;
    run.input = Multisine(40.0);
    run.duration = 90.0;
    run.has_poses = GetParam();
    const std::vector<Log> logs = {LogOf(run, 1)};
    data_ = std::make_unique<TrainingData>(MeasuredSegmentsOf(logs, Dof::kSurge).all);
    fit_.model = {kSurgeTruth, {}};
    fit_.initial = {{0.05, 0.0}};
  }

  // What a small effect adds to the simulation, per unit of its first value; by central
  // differences.
  Eigen::VectorXd Difference(const char* effect, std::vector<double> values, double step) const {
    Eigen::VectorXd outputs[2];
    for (const int side : {0, 1}) {
      values[0] = side == 0 ? -step : step;
      outputs[side] =
          *data_->Simulate(WithEffect(fit_.model, {FindEffect(effect), {}, values}), fit_.initial);
    }
    return (outputs[1] - outputs[0]) / (2.0 * step);
  }

  void ExpectClose(const std::vector<double>& force, const Eigen::VectorXd& expected) const {
    const Eigen::VectorXd outputs = ForceResponse(data_.get(), fit_).Outputs(force);
    ASSERT_GT(expected.norm(), 0.0);
    // Damping is taken at the speed at one end of each 0.1 s step: the rate, 0.15 / s at most,
    // changes by a few per cent within it.
    EXPECT_LT((outputs - expected).norm(), 0.01 * expected.norm());
  }

  std::vector<RunPoint> points() const { return ForceResponse(data_.get(), fit_).points(); }

  std::unique_ptr<TrainingData> data_;
  StructureFit fit_;
};

TEST_P(ForceResponses, OfAConstantForceIsThatOfTheSimulation) {
  const std::vector<double> force(points().size(), 1.0);
  // A step at 0 s on a vehicle that starts then: a constant force; resistance is against it.
  ExpectClose(force, -Difference("buoyancy_step", {0.0, 0.0}, 0.05));
}

TEST_P(ForceResponses, OfASwingIsThatOfTheSimulation) {
  std::vector<double> force;
  for (const auto& point : points()) force.push_back(std::sin(0.7 * point.time));
  ExpectClose(force, Difference("periodic_force", {0.0, 0.0, 0.7}, 0.05));
}

TEST_P(ForceResponses, OfADragIsThatOfTheSimulation) {
  std::vector<double> force;
  for (const auto& point : points()) force.push_back(-std::pow(point.velocity, 3));
  ExpectClose(force, Difference("cubic_damping", {0.0}, 0.5));
}

// What is active already resists the answer too: beside a spring, a force makes the vehicle swing.
TEST_P(ForceResponses, BesideASpringIsThatOfTheSimulation) {
  fit_.model = WithEffect(fit_.model, {FindEffect("position_stiffness"), {}, {400.0}});
  std::vector<double> force;
  for (const auto& point : points()) force.push_back(std::sin(0.7 * point.time));
  ExpectClose(force, Difference("periodic_force", {0.0, 0.0, 0.7}, 0.05));
}

// Strongly damped, with a spring that brings the vehicle back slowly.
TEST_P(ForceResponses, BesideASoftSpringAndDragIsThatOfTheSimulation) {
  fit_.model.baseline.linear_damping = 2000.0;
  fit_.model = WithEffect(fit_.model, {FindEffect("position_stiffness"), {}, {100.0}});
  std::vector<double> force;
  for (const auto& point : points()) force.push_back(std::sin(0.7 * point.time));
  ExpectClose(force, Difference("periodic_force", {0.0, 0.0, 0.7}, 0.05));
}

INSTANTIATE_TEST_SUITE_P(VelocityAndBoth, ForceResponses, testing::Bool());

}  // namespace
}  // namespace fathom
