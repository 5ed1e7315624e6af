// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_fit.h"

#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "drawn_vehicle.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(FitCoupled, FindsTheVehicleOfALogWithoutNoise) {
  std::mt19937 random(1);
  CoupledModel truth = DrawnPlanarVehicle(&random);
  truth.inertia(1, 5) = truth.inertia(5, 1) = 3.0;
  truth.linear_damping(1, 5) = 2.0;
  truth.linear_damping(5, 1) = -1.0;
  DrawnLogOptions options;
  options.noise = 1e-6;
  const std::vector<CoupledData> logs = {DrawnLog(truth, options, &random)};
  const MotionStructure structure = StructureOf(StandardStructure::kFull, truth.dofs);
  const CoupledSummary summary = FitCoupled(logs, structure);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  for (const FreeEntry& entry : structure.entries) {
    const double value = ValueIn(truth, entry);
    EXPECT_NEAR(ValueIn(summary.model, entry), value, 1e-3 * std::max(1.0, std::abs(value)))
        << NameOf(entry);
  }
}

// Of 40 vehicles 94.8 % of 520 numbers were covered; with windows of 5 s 95.6 %.
TEST(FitCoupled, IntervalsOf95PerCentCoverTheTruthAsOftenAndModelsAreThoseOfBodies) {
  int num = 0, covered = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    std::mt19937 random(100 + seed);
    const CoupledModel truth = DrawnPlanarVehicle(&random);
    const std::vector<CoupledData> logs = {DrawnLog(truth, {}, &random)};
    const MotionStructure structure = StructureOf(StandardStructure::kSymmetric, truth.dofs);
    const CoupledSummary summary = FitCoupled(logs, structure);
    ASSERT_TRUE(summary.IsUsable()) << summary.message;
    EXPECT_TRUE(IsPositiveDefinite(summary.model.inertia, truth.dofs));
    EXPECT_TRUE(IsPassive(summary.model));
    for (std::size_t k = 0; k < structure.entries.size(); ++k) {
      const FreeEntry& entry = structure.entries[k];
      const auto at = static_cast<Eigen::Index>(k);
      const double miss = ValueIn(summary.model, entry) - ValueIn(truth, entry);
      ++num;
      covered += std::abs(miss) < 1.96 * std::sqrt(summary.covariance(at, at)) ? 1 : 0;
    }
  }
  EXPECT_GT(covered, 0.89 * num);
  EXPECT_LT(covered, 0.99 * num);
}

// Two standard deviations of a difference; chance alone may take one number beyond,
// none beyond three. Of 40 further vehicles all 480 numbers were within 1.7.
TEST(FitCoupled, WindowsOfAnyLengthTellTheSameVehicle) {
  int num_beyond = 0;
  for (const unsigned seed : {7u, 8u, 9u}) {
    std::mt19937 random(seed);
    const CoupledModel truth = DrawnPlanarVehicle(&random);
    const std::vector<CoupledData> logs = {DrawnLog(truth, {}, &random)};
    const MotionStructure structure = StructureOf(StandardStructure::kCoriolis, truth.dofs);
    std::vector<CoupledSummary> fits;
    for (const double window : {5.0, 20.0, 100.0}) {
      CoupledFitOptions options;
      options.window = window;
      fits.push_back(FitCoupled(logs, structure, options));
      ASSERT_TRUE(fits.back().IsUsable()) << fits.back().message;
    }
    for (std::size_t k = 0; k < structure.entries.size(); ++k) {
      const FreeEntry& entry = structure.entries[k];
      const auto at = static_cast<Eigen::Index>(k);
      double farthest = 0.0;
      for (const auto& [a, b] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
        const double apart = ValueIn(fits[a].model, entry) - ValueIn(fits[b].model, entry);
        const double variance = fits[a].covariance(at, at) + fits[b].covariance(at, at);
        farthest = std::max(farthest, std::abs(apart) / std::sqrt(variance));
      }
      EXPECT_LT(farthest, 3.0) << NameOf(entry) << ", seed " << seed;
      num_beyond += farthest < 2.0 ? 0 : 1;
    }
  }
  EXPECT_LE(num_beyond, 1);
}

// A vehicle that rolls and pitches, its attitude measured beside its rates.
TEST(FitCoupled, TellsRightingMomentsFromRatesAndAttitude) {
  std::mt19937 random(3);
  CoupledModel truth;
  truth.dofs = {Dof::kRoll, Dof::kPitch, Dof::kYaw};
  truth.inertia.diagonal() << 0.0, 0.0, 0.0, 2.0, 3.0, 4.0;
  truth.linear_damping.diagonal() << 0.0, 0.0, 0.0, 1.5, 2.0, 2.5;
  truth.quadratic_damping.diagonal() << 0.0, 0.0, 0.0, 1.0, 1.2, 1.5;
  truth.righting_roll = 6.0;
  truth.righting_pitch = 9.0;
  truth.coriolis = true;
  // The plain simulator moves all six: the others are held by a great mass.
  CoupledModel simulated = truth;
  simulated.inertia.diagonal().head<3>().setConstant(1e9);
  DrawnLogOptions options;
  options.force = Vector6(0.0, 0.0, 0.0, 3.0, 4.0, 5.0);
  CoupledData log = DrawnLog(simulated, options, &random);
  log.has_attitude = true;
  const MotionStructure structure = StructureOf(StandardStructure::kCoriolis, truth.dofs);
  const CoupledSummary summary = FitCoupled({&log, 1}, structure);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NEAR(summary.model.righting_roll, 6.0, 0.1);
  EXPECT_NEAR(summary.model.righting_pitch, 9.0, 0.15);
  EXPECT_NEAR(summary.model.inertia(3, 3), 2.0, 0.05);
  EXPECT_NEAR(summary.model.inertia(4, 4), 3.0, 0.07);
}

// What was commanded is what acted, but for the port thruster, which gave 0.7 of it.
TEST(FitCoupled, FindsAWeakThruster) {
  std::mt19937 random(5);
  const CoupledModel truth = DrawnPlanarVehicle(&random);
  CoupledData log = DrawnLog(truth, {}, &random);
  CoupledCommand& command = log.inputs.command;
  const Vector6 port(1.0, 0.0, 0.0, 0.0, 0.0, 0.3), starboard(1.0, 0.0, 0.0, 0.0, 0.0, -0.3);
  const Vector6 lateral(0.0, 1.0, 0.0, 0.0, 0.0, 0.0);
  command.thrusters = {{"port", port, {}}, {"starboard", starboard, {}}, {"lateral", lateral, {}}};
  for (const Vector6& force : command.force) {
    const double sum = force[0], difference = force[5] / 0.3;
    command.thrusters[0].thrust.push_back(0.5 * (sum + difference) / 0.7);
    command.thrusters[1].thrust.push_back(0.5 * (sum - difference));
    command.thrusters[2].thrust.push_back(force[1]);
  }
  command.force.clear();
  MotionStructure structure = StructureOf(StandardStructure::kCoriolis, truth.dofs);
  structure.entries.push_back(ThrustGainEntry("port"));
  const CoupledSummary summary = FitCoupled({&log, 1}, structure);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NEAR(summary.model.thrust_gain.at("port"), 0.7, 0.02);
}

// Nothing drives sway, so that nothing tells its inertia.
TEST(FitCoupled, IsNotUsableWhereAnInertiaMayBe0) {
  std::mt19937 random(4);
  CoupledModel truth = DrawnPlanarVehicle(&random);
  truth.coriolis = false;
  DrawnLogOptions drawn;
  drawn.force[1] = 0.0;
  const CoupledData log = DrawnLog(truth, drawn, &random);
  const MotionStructure structure = StructureOf(StandardStructure::kDiagonal, truth.dofs);
  EXPECT_FALSE(FitCoupled({&log, 1}, structure).IsUsable());
}

// As where some blocks of a fit before had a noise of their own.
TEST(FitCoupled, TakesNoNoiseOfOtherChannels) {
  std::mt19937 random(9);
  const CoupledModel truth = DrawnPlanarVehicle(&random);
  DrawnLogOptions drawn;
  drawn.duration = 60.0;
  const CoupledData log = DrawnLog(truth, drawn, &random);
  const MotionStructure structure = StructureOf(StandardStructure::kCoriolis, truth.dofs);
  const CoupledSummary usual = FitCoupled({&log, 1}, structure);
  CoupledFitOptions options;
  options.noise = {usual.noise.back()};
  const CoupledSummary summary = FitCoupled({&log, 1}, structure, options);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_EQ(summary.model.inertia, usual.model.inertia);
}

TEST(FitCoupled, SaysWhatTheDataDoNotTellApart) {
  std::mt19937 random(2);
  const CoupledModel truth = DrawnPlanarVehicle(&random);
  DrawnLogOptions options;
  options.duration = 60.0;
  CoupledData log = DrawnLog(truth, options, &random);
  // All thrusts free beside all inertias: only ratios are determined.
  MotionStructure structure = StructureOf(StandardStructure::kCoriolis, truth.dofs);
  CoupledCommand& command = log.inputs.command;
  for (int i : {0, 1, 5}) {
    Vector6 along = Vector6::Zero();
    along[i] = 1.0;
    CommandedThruster& thruster = command.thrusters.emplace_back();
    thruster.name = std::string(VelocityColumn(kAllDofs[static_cast<std::size_t>(i)]));
    thruster.push = along;
    for (const Vector6& force : command.force) thruster.thrust.push_back(force[i]);
    structure.entries.push_back(ThrustGainEntry(thruster.name));
  }
  command.force.clear();
  const CoupledSummary summary = FitCoupled({&log, 1}, structure);
  EXPECT_FALSE(summary.IsUsable());
}

}  // namespace
}  // namespace fathom
