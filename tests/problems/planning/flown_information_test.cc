// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/flown_information.h"

#include "fathom/base/input_error.h"
#include "fathom/coupled_planning/flown_entries.h"
#include "fathom/planning/information.h"
#include "fathom/planning/plan_experiment.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <cmath>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kMass = 42.0, kDamping = 7.0, kOffset = 1.3, kForce = 9.7;
constexpr double kNoiseOfLog = 0.013;

// m dv/dt + d v + b = F from rest is v = V (1 - e), V = (F - b) / d, e = exp(-d t / m).
struct Instant {
  double t, e, V, a;
  explicit Instant(double time)
      : t(time),
        e(std::exp(-kDamping / kMass * time)),
        V((kForce - kOffset) / kDamping),
        a(kDamping / kMass) {}
  double Velocity() const { return V * (1.0 - e); }
  // By inertia, quadratic damping (of which there is none), linear damping, buoyancy; by the start.
  Eigen::Matrix<double, 1, 4> ByParameter() const {
    const double square =
        (1.0 - e) / a - 2.0 * t * e + e * (1.0 - e) / a;  // of v^2 through the lag
    return {-V * a * t / kMass * e,
            -V * V / kMass * square,
            -V / kDamping * (1.0 - e) + V * t / kMass * e,
            -(1.0 - e) / kDamping};
  }
  double ByStart() const { return e; }
};

Segment StepLog() {
  Segment log;
  for (int i = 0; i < 400; ++i) {
    log.time.push_back(100.0 + 0.05 * i);
    log.velocity.push_back(Instant(0.05 * i).Velocity());
  }
  log.command = {{100.0}, {kForce}};
  return log;
}

FittedModel LinearModel() {
  FittedModel model;
  model.dof = Dof::kSurge;
  model.force_unit = "N";
  model.model = {kMass, 0.0, kDamping, kOffset};
  model.covariance = Eigen::Vector4d(4.0, 1.0, 0.25, 0.01).asDiagonal();
  model.covariance(0, 2) = model.covariance(2, 0) = 0.3;
  model.train.mae = 0.01;
  model.train.num_samples = 1000;
  model.train.duration = 100.0;
  return model;
}

// J'J less what the start takes up, over sigma^2.
Eigen::Matrix4d ClosedForm() {
  Eigen::Matrix4d all = Eigen::Matrix4d::Zero();
  Eigen::Vector4d mixed = Eigen::Vector4d::Zero();
  double start = 0.0;
  for (int i = 0; i < 400; ++i) {
    const Instant instant(0.05 * i);
    all += instant.ByParameter().transpose() * instant.ByParameter();
    mixed += instant.ByParameter().transpose() * instant.ByStart();
    start += instant.ByStart() * instant.ByStart();
  }
  return (all - mixed * mixed.transpose() / start) / (kNoiseOfLog * kNoiseOfLog);
}

// `share`: of what an element could be at the most.
void ExpectClosedForm(const Eigen::MatrixXd& flown, double share) {
  const Eigen::Matrix4d expected = ClosedForm();
  ASSERT_EQ(flown.rows(), 4);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(flown(i, k), expected(i, k), share * std::sqrt(expected(i, i) * expected(k, k)))
          << i << ", " << k;
    }
  }
}

// Steps of 0.05 s against a time constant of 6 s; what the start takes up magnifies.
TEST(FlownInformation, IsTheClosedFormOfALinearModel) {
  ExpectClosedForm(FlownInformation(LinearModel(), {StepLog()}, {kNoiseOfLog}, "model.json"), 1e-3);
}

// Twice the log tells twice as much, and none tells nothing.
TEST(FlownInformation, AddsUpOverLogs) {
  const FittedModel model = LinearModel();
  const Eigen::MatrixXd one = FlownInformation(model, {StepLog()}, {kNoiseOfLog}, "");
  const Eigen::MatrixXd two = FlownInformation(model, {StepLog(), StepLog()}, {kNoiseOfLog}, "");
  EXPECT_LT((two - 2.0 * one).norm(), 1e-9 * one.norm());
  EXPECT_EQ(FlownInformation(model, {}, {kNoiseOfLog}, "").norm(), 0.0);
}

// The model's covariance and the logs, each once.
TEST(FlownInformation, IsAddedToTheModelsOwn) {
  PlanRequest request;
  request.model = LinearModel();
  request.name = "model.json";
  request.limits.force = 12.0;
  request.limits.speed = 2.0;
  request.limits.velocity = {20.0, kNoiseOfLog};
  request.duration = 20.0;
  request.effort = 0.05;
  request.flown = {StepLog()};
  const ExperimentPlan plan = PlanExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  const Eigen::Matrix4d of_model = Eigen::Matrix4d(request.model.covariance).inverse();
  const Eigen::Matrix4d before = (of_model + ClosedForm()).inverse();
  for (int i = 0; i < 4; ++i) {
    const PlannedParameter& parameter = plan.parameters[static_cast<std::size_t>(i)];
    EXPECT_NEAR(parameter.before / std::sqrt(before(i, i)), 1.0, 1e-3) << parameter.name;
    EXPECT_LT(parameter.before, std::sqrt(request.model.covariance(i, i)));
    EXPECT_LT(parameter.with_log_so_far, parameter.before);
    EXPECT_LT(parameter.with_log_so_far, parameter.after);
  }
}

// The same log as a model of several DOFs takes it, held out: all of a log counts.
CoupledPlanRequest LinearRequest() {
  const Segment log = StepLog();
  CoupledPlanRequest request;
  request.name = "boat.json";
  request.model.horizon = 20.0;
  CoupledModel& model = request.model.model;
  model.dofs = {Dof::kSurge};
  model.inertia(0, 0) = kMass;
  model.linear_damping(0, 0) = kDamping;
  model.offset[0] = kOffset;
  CoupledData& data = request.flown.emplace_back();
  data.log = "step";
  data.dofs = model.dofs;
  data.has_velocity[0] = true;
  data.inputs.command.time = {log.time.front()};
  data.inputs.command.force = {Vector6::Unit(0) * kForce};
  CoupledSegment& segment = data.segments.emplace_back();
  segment.is_held_out = true;
  segment.time = log.time;
  for (const double velocity : log.velocity)
    segment.velocity.push_back(Vector6::Unit(0) * velocity);
  return request;
}

CoupledPlan OfNoise(double noise) {
  CoupledPlan plan;
  plan.noise[0] = noise;
  return plan;
}

const std::vector<FreeEntry> kEntries = {InertiaEntry(Dof::kSurge, Dof::kSurge),
                                         QuadraticDampingEntry(Dof::kSurge, Dof::kSurge),
                                         LinearDampingEntry(Dof::kSurge, Dof::kSurge),
                                         OffsetEntry(Dof::kSurge)};

// A fit adds a little to the start's squares, so that a start without a trace stays put.
TEST(FlownInformation, OfACoupledModelIsTheClosedFormToo) {
  ExpectClosedForm(FlownInformation(LinearRequest(), OfNoise(kNoiseOfLog), kEntries), 2e-3);
}

TEST(FlownInformation, OfACoupledModelNeedsAVelocity) {
  CoupledPlanRequest request = LinearRequest();
  request.flown.front().has_velocity = {};
  EXPECT_THROW(FlownInformation(request, OfNoise(kNoiseOfLog), kEntries), InputError);
}

}  // namespace
}  // namespace fathom
