// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/structure_comparison.h"

#include "fathom/signal/joined_signals.h"
#include "fathom/simulate/coupled/coupled_prediction.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "drawn_vehicle.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<Dof> kPlane = {Dof::kSurge, Dof::kSway, Dof::kYaw};

Log DrawnLogFile(bool coriolis, int seed) {
  std::mt19937 random(seed);
  CoupledModel truth = DrawnPlanarVehicle(&random);
  truth.coriolis = coriolis;
  DrawnLogOptions options;
  options.duration = 100.0;
  return LogFileOf(DrawnLog(truth, options, &random));
}

std::vector<std::string> NamesOfRows(const StructureComparison& comparison) {
  std::vector<std::string> names;
  for (const StructureRow& row : comparison.rows) names.push_back(row.name);
  return names;
}

TEST(CompareStructures, FindsThatCouplingBeatsModelsOfOneDofWhereItIsThere) {
  const std::vector<Log> logs = {DrawnLogFile(true, 1002)};
  StructureComparisonOptions options;
  options.dofs = kPlane;
  options.structures = {StandardStructure::kDiagonal, StandardStructure::kCoriolis};
  options.has_auto = false;
  const StructureComparison comparison = CompareStructures(logs, options);
  EXPECT_THAT(
      NamesOfRows(comparison),
      ElementsAre("least_squares", "adaptive", "output_error", "best", "diagonal", "coriolis"));
  ASSERT_NE(comparison.Taken(), nullptr);
  const StructureRow& coriolis = *comparison.Taken();
  EXPECT_EQ(coriolis.name, "coriolis");
  EXPECT_EQ(coriolis.num_numbers, 12);
  ASSERT_TRUE(coriolis.gain.has_value());
  EXPECT_GT(coriolis.gain->in_errors, 5.0);
  EXPECT_GT(coriolis.gain->share, 0.3);
  for (const Dof dof : kPlane) {
    const auto at = static_cast<std::size_t>(Index(dof));
    EXPECT_LT(coriolis.unseen_nmae[at], comparison.Best()->unseen_nmae[at]) << Name(dof);
    EXPECT_LT(coriolis.train_nmae[at], comparison.Best()->train_nmae[at]) << Name(dof);
    EXPECT_TRUE(std::isnan(coriolis.held_out_nmae[at])) << Name(dof);
  }
}

// A quarter of each of two logs, by the models of what is left of both.
TEST(CompareStructures, UnseenErrorsOfTwoLogsAreNearThoseOfTheirFits) {
  const std::vector<Log> logs = {DrawnLogFile(false, 7), DrawnLogFile(false, 8)};
  StructureComparisonOptions options;
  options.dofs = {Dof::kSurge};
  options.structures = {StandardStructure::kDiagonal};
  options.has_auto = false;
  options.families = {Family::kOutputError};
  const StructureComparison comparison = CompareStructures(logs, options);
  const StructureRow& row = comparison.rows[0];
  EXPECT_NEAR(row.unseen_nmae[0], comparison.rows[1].unseen_nmae[0], 0.05 * row.unseen_nmae[0]);
  EXPECT_LT(row.unseen_nmae[0], 1.5 * row.train_nmae[0]);
}

// A diagonal model without C(nu) is that of each DOF by itself, docs/coupled.md.
TEST(CompareStructures, ADiagonalModelIsOutputErrorOfEachDof) {
  const std::vector<Log> logs = {DrawnLogFile(false, 1001)};
  StructureComparisonOptions options;
  options.dofs = kPlane;
  options.structures = {StandardStructure::kDiagonal};
  options.has_auto = false;
  options.families = {Family::kOutputError};
  const StructureComparison comparison = CompareStructures(logs, options);
  ASSERT_THAT(NamesOfRows(comparison), ElementsAre("output_error", "diagonal"));
  const StructureRow& one = comparison.rows[0];
  const StructureRow& diagonal = comparison.rows[1];
  ASSERT_TRUE(one.is_usable && diagonal.is_usable) << one.message << diagonal.message;
  for (const Dof dof : kPlane) {
    const auto at = static_cast<std::size_t>(Index(dof));
    EXPECT_EQ(one.train_nmae[at], diagonal.train_nmae[at]) << Name(dof);
    // Other noise in the fits of the folds.
    EXPECT_NEAR(one.unseen_nmae[at], diagonal.unseen_nmae[at], 0.02 * diagonal.unseen_nmae[at]);
  }
  EXPECT_LT(std::abs(diagonal.gain->share), 0.02);
}

// Sums of errors and of motion, by hand: each of four logs by the model of the others.
TEST(CompareStructures, UnseenErrorsOfOneDofAreThoseOfModelsOfTheOtherLogs) {
  std::vector<Log> logs;
  for (const int seed : {7, 8, 9, 10}) logs.push_back(DrawnLogFile(false, seed));
  StructureComparisonOptions options;
  options.dofs = {Dof::kSurge};
  options.structures = {StandardStructure::kDiagonal};
  options.has_auto = false;
  options.families = {Family::kLeastSquares};
  const StructureComparison comparison = CompareStructures(logs, options);
  double error = 0.0, motion = 0.0;
  for (std::size_t unseen = 0; unseen < logs.size(); ++unseen) {
    std::vector<Log> others = logs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(unseen));
    const Signals signals = JoinSignals(others, Dof::kSurge, std::nullopt).all;
    const Identification fit = Identify(signals, signals, Family::kLeastSquares);
    ASSERT_TRUE(fit.is_usable) << fit.message;
    CoupledModel model;
    model.dofs = {Dof::kSurge};
    model.inertia(0, 0) = fit.fitted.model.inertia;
    model.linear_damping(0, 0) = fit.fitted.model.linear_damping;
    model.quadratic_damping(0, 0) = fit.fitted.model.quadratic_damping;
    model.offset[0] = fit.fitted.model.buoyancy;
    const std::vector<CoupledData> data = {CoupledDataOf(logs[unseen], {Dof::kSurge})};
    const FitFigures figures = PredictCoupled(model, data, 5.0)->train[0];
    error += figures.mae * figures.num_samples;
    motion += figures.mae / figures.nmae * figures.num_samples;
  }
  EXPECT_NEAR(comparison.rows[0].unseen_nmae[0], error / motion, 1e-6);
}

TEST(CompareStructures, TakesOfEachDofTheBestOfTheFamilies) {
  const std::vector<Log> logs = {DrawnLogFile(true, 1002)};
  StructureComparisonOptions options;
  options.dofs = kPlane;
  options.structures = {StandardStructure::kDiagonal};
  options.has_auto = false;
  const StructureComparison comparison = CompareStructures(logs, options);
  ASSERT_NE(comparison.Best(), nullptr);
  ASSERT_EQ(comparison.Best()->of_families.size(), 3);
  for (std::size_t k = 0; k < kPlane.size(); ++k) {
    const auto at = static_cast<std::size_t>(Index(kPlane[k]));
    for (std::size_t family = 0; family < 3; ++family) {
      const StructureRow& row = comparison.rows[family];
      if (std::isnan(row.unseen_nmae[at])) continue;
      // Steps of the simulation are those of the quickest DOF: another model's beside it.
      const double tolerance = 1e-4 * row.unseen_nmae[at];
      EXPECT_LE(comparison.Best()->unseen_nmae[at], row.unseen_nmae[at] + tolerance) << row.name;
      if (comparison.Best()->of_families[k] != row.name) continue;
      EXPECT_NEAR(comparison.Best()->unseen_nmae[at], row.unseen_nmae[at], tolerance) << row.name;
    }
  }
}

TEST(CompareStructures, KeepsWhatIsKnownWhereOneDofFails) {
  Log log = DrawnLogFile(false, 1002);
  for (double& force : log.command->values[1]) force = 0.0;  // though sway moves
  StructureComparisonOptions options;
  options.dofs = {Dof::kSurge, Dof::kSway};
  options.structures = {StandardStructure::kDiagonal};
  options.has_auto = false;
  const StructureComparison comparison = CompareStructures(std::vector<Log>{log}, options);
  for (const StructureRow& row : comparison.rows) {
    if (!row.is_of_one_dof) continue;
    EXPECT_FALSE(row.is_usable) << row.name;
    EXPECT_THAT(row.message, HasSubstr("sway: ")) << row.name;
    EXPECT_TRUE(std::isfinite(row.unseen_nmae[0])) << row.name;
    EXPECT_TRUE(std::isnan(row.unseen_nmae[1])) << row.name;
  }
  EXPECT_EQ(comparison.Best(), nullptr);
}

TEST(CompareStructures, LeavesOutStructuresThatFreeNothingMore) {
  const std::vector<Log> logs = {DrawnLogFile(false, 3)};
  StructureComparisonOptions options;
  options.dofs = {Dof::kSurge};
  options.has_auto = false;
  options.families = {Family::kOutputError};
  const StructureComparison comparison = CompareStructures(logs, options);
  EXPECT_THAT(NamesOfRows(comparison), ElementsAre("output_error", "diagonal", "coriolis"));
  EXPECT_THAT(comparison.remarks,
              Contains("Left out: symmetric, full, lopsided, which free nothing more of surge."));
}

}  // namespace
}  // namespace fathom
