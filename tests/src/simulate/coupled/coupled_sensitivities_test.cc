// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Derivatives of coupled runs, against the differences of two runs.

#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <string>
#include <vector>

#include "test_rov.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Each column of the sensitivities against the difference of two runs.
void ExpectDerivativesOfDifferences(const CoupledModel& model, const CoupledInputs& inputs) {
  MotionStructure structure = StructureOf(StandardStructure::kFull, model.dofs);
  structure.entries.push_back(QuadraticDampingEntry(Dof::kYaw, Dof::kSway));
  structure.entries.push_back(ThrustGainEntry("port"));
  structure.entries.push_back(ThrustAngleEntry());
  if (!inputs.command.shafts.empty()) structure.entries.push_back(ThrustGainEntry("screw"));
  structure.entries.push_back(LiftEntry(Dof::kSway, Dof::kYaw));
  structure.entries.push_back(FinForceEntry("plane"));
  structure.entries.push_back(FinRaceEntry("rudder"));
  structure.entries.push_back(FinNeutralEntry("rudder"));
  structure.entries.push_back(FinStuckEntry("stuck"));
  // An offset moves the steps, whose errors where the slope of a stall bends its differences would
  // hold; in steps of 2 ms they agree.
  if (model.fin_stall.empty()) structure.entries.push_back(TimeOffsetEntry());
  if (model.thruster_lag > 0.0) structure.entries.push_back(ThrusterLagEntry());
  for (const auto& [fin, lag] : model.fin_lag) structure.entries.push_back(FinLagEntry(fin));
  for (const FreeEntry& entry : EntriesIn(model)) {
    if (IsEffect(entry) || IsLimit(entry) || IsOfRun(entry)) structure.entries.push_back(entry);
  }
  CoupledStamps stamps;
  stamps.start = 0.1;  // at no change of the command, which an offset moves in or out
  for (int k = 1; k <= 20; ++k) stamps.velocity.push_back(0.47 * k);
  stamps.pose = stamps.velocity;
  CoupledOutputs outputs;
  const CoupledState start = Moving();
  ASSERT_TRUE(
      RunCoupledWithSensitivities(model, structure.entries, inputs, start, stamps, &outputs));
  const int columns = NumCoupledColumns(model, structure.entries);
  ASSERT_EQ(outputs.velocity_sensitivity.cols(), columns);

  for (int column = 0; column < columns; ++column) {
    const auto run = [&](double by) {
      CoupledModel moved = model;
      CoupledState from = start;
      const int num_entries = static_cast<int>(structure.entries.size());
      if (column < num_entries) {
        const FreeEntry& entry = structure.entries[static_cast<std::size_t>(column)];
        SetValue(entry, ValueIn(model, entry) + by, &moved);
      } else if (column < num_entries + 6) {
        from.nu[column - num_entries] += by;
      } else {
        const Eigen::Vector3d turn = by * Eigen::Vector3d::Unit(column - num_entries - 6);
        const Eigen::Quaterniond by_turn(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
        from.attitude = (Eigen::Quaterniond(start.attitude) * by_turn).coeffs();
      }
      CoupledOutputs moved_outputs;
      EXPECT_TRUE(RunCoupled(moved, inputs, from, stamps, &moved_outputs));
      return moved_outputs;
    };
    const std::string name = column < static_cast<int>(structure.entries.size())
                                 ? NameOf(structure.entries[static_cast<std::size_t>(column)])
                                 : std::to_string(column);
    // An offset and a limited rate move the steps of integration too, whose errors their
    // differences hold.
    const bool is_offset = name == "time_offset", is_rate = name.starts_with("fin_rate_limit");
    const double kStep = is_offset ? 4e-3 : is_rate ? 2e-3 : 1e-5;
    const double kClose = is_offset || is_rate ? 5e-4 : 1e-4;
    const CoupledOutputs above = run(kStep), below = run(-kStep);
    for (std::size_t k = 0; k < stamps.velocity.size(); ++k) {
      const auto row = 6 * static_cast<Eigen::Index>(k);
      const Vector6 velocity = (above.velocity[k] - below.velocity[k]) / (2.0 * kStep);
      const Vector6 of_velocity = outputs.velocity_sensitivity.block<6, 1>(row, column);
      EXPECT_LT((of_velocity - velocity).norm(), kClose * (1.0 + velocity.norm())) << name;
      const Eigen::Vector3d position =
          (above.pose[k].position - below.pose[k].position) / (2.0 * kStep);
      const Eigen::Vector3d of_position = outputs.pose_sensitivity.block<3, 1>(row + 3, column);
      EXPECT_LT((of_position - position).norm(), kClose * (1.0 + position.norm())) << name;
      const Eigen::Quaterniond between = Eigen::Quaterniond(below.pose[k].attitude).conjugate() *
                                         Eigen::Quaterniond(above.pose[k].attitude);
      const Eigen::Vector3d turn = 2.0 * between.vec() / between.w() / (2.0 * kStep);
      const Eigen::Vector3d of_turn = outputs.pose_sensitivity.block<3, 1>(row, column);
      EXPECT_LT((of_turn - turn).norm(), kClose * (1.0 + turn.norm())) << name;
    }
  }
}

TEST(RunCoupledWithSensitivities, HasTheDerivativesOfDifferences) {
  CoupledModel turned = FinnedRov();
  turned.thrust_angle = 0.2;
  ExpectDerivativesOfDifferences(turned, FinnedSteps(5));
}

TEST(RunCoupledWithSensitivities, HasThemWithLags) {
  CoupledModel lagged = FinnedRov();
  lagged.thruster_lag = 0.3;
  lagged.fin_lag = {{"rudder", 0.6}};
  ExpectDerivativesOfDifferences(lagged, FinnedSteps(5));
}

TEST(RunCoupledWithSensitivities, HasThemInACurrent) {
  CoupledInputs inputs = FinnedSteps(5);
  inputs.log = "dive";
  CoupledModel model = FinnedRov();
  model.current = {{"dive", {0.3, -0.2}}};
  ExpectDerivativesOfDifferences(model, inputs);
}

TEST(RunCoupledWithSensitivities, HasThemWithAnOffsetOfTheRun) {
  CoupledInputs inputs = FinnedSteps(5);
  inputs.log = "dive";
  CoupledModel model = FinnedRov();
  model.run_offset["dive"] << 3.0, -2.0, 1.0, 0.0, 0.5, -1.0;
  ExpectDerivativesOfDifferences(model, inputs);
}

// One that turns all the time, and one that arrives.
TEST(RunCoupledWithSensitivities, HasThemWithLimitedRates) {
  CoupledModel limited = FinnedRov();
  limited.fin_rate_limit = {{"rudder", 0.17}, {"plane", 0.6}};
  ExpectDerivativesOfDifferences(limited, FinnedSteps(5));
}

TEST(RunCoupledWithSensitivities, HasThemWithStall) {
  CoupledModel stalled = FinnedRov();
  stalled.fin_stall = {{"rudder", 0.3}, {"plane", 0.2}, {"stuck", 0.15}};
  ExpectDerivativesOfDifferences(stalled, FinnedSteps(5));
}

TEST(RunCoupledWithSensitivities, HasThemWithEffects) {
  CoupledModel model = FinnedRov();
  model.effects = RovWithEffects().effects;
  // Differences would show the errors of the steps at the kink of a large one.
  model.effects["coulomb_friction"] *= 0.02;
  model.thruster_effects = {{"thrust_dead_zone", 1.0}, {"thrust_asymmetry", 0.25}};
  model.thruster_lag = 0.3;
  ExpectDerivativesOfDifferences(model, FinnedSteps(5));
}

// By the thrust's slope in the speed, and that of the race over the rudder.
TEST(RunCoupledWithSensitivities, HasThemWithAShaft) {
  ExpectDerivativesOfDifferences(ScrewedRov(), ScrewedSteps(5));
}

}  // namespace
}  // namespace fathom
