// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/block_fit.h"

#include "fathom/coupled/coupled_identification.h"
#include "fathom/output_error/output_error.h"
#include "fathom/signal/joined_signals.h"

#include <random>
#include <vector>

#include "drawn_vehicle.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Six DOFs that nothing joins: no Coriolis forces, and no forces by the attitude.
CoupledModel DrawnDiagonalVehicle(std::mt19937* random) {
  CoupledModel truth = DrawnPlanarVehicle(random);
  truth.dofs.assign(kAllDofs.begin(), kAllDofs.end());
  truth.inertia.diagonal().segment<3>(2) << 70.0, 4.0, 5.0;
  truth.linear_damping.diagonal().segment<3>(2) << 12.0, 2.0, 3.0;
  truth.quadratic_damping.diagonal().segment<3>(2) << 60.0, 3.0, 4.0;
  truth.offset.segment<3>(2) << 0.5, 0.1, -0.1;
  truth.coriolis = false;
  return truth;
}

MotionStructure DiagonalStructure(const std::vector<Dof>& dofs) {
  MotionStructure structure = {dofs, {}, false};
  for (const Dof dof : dofs) {
    for (const FreeEntry& entry : {InertiaEntry(dof, dof),
                                   QuadraticDampingEntry(dof, dof),
                                   LinearDampingEntry(dof, dof),
                                   OffsetEntry(dof)}) {
      structure.entries.push_back(entry);
    }
  }
  return structure;
}

TEST(FitBlocks, OfOneDofEachIsOutputErrorToTheBit) {
  std::mt19937 random(11);
  const CoupledModel truth = DrawnDiagonalVehicle(&random);
  CoupledLogs logs;
  logs.logs = {LogFileOf(DrawnLog(truth, {}, &random))};
  logs.data = {CoupledDataOf(logs.logs.front(), truth.dofs)};
  const CoupledSummary blocks = FitBlocks(logs, DiagonalStructure(truth.dofs), {});
  ASSERT_TRUE(blocks.IsUsable()) << blocks.message;
  for (const Dof dof : truth.dofs) {
    const JoinedSignals signals = JoinSignals(logs.logs, dof, std::nullopt);
    OutputErrorOptions options;
    options.output = OutputOf(signals.all.train);
    const OutputErrorSummary one = FitOutputError(signals.all.train, options);
    const int i = Index(dof);
    EXPECT_EQ(blocks.model.inertia(i, i), one.model.inertia);
    EXPECT_EQ(blocks.model.linear_damping(i, i), one.model.linear_damping);
    EXPECT_EQ(blocks.model.quadratic_damping(i, i), one.model.quadratic_damping);
    EXPECT_EQ(blocks.model.offset[i], one.model.buoyancy);
    const auto inertia = kNumParameters * Index(dof);
    EXPECT_EQ(blocks.covariance(inertia, inertia), one.covariance(kInertia, kInertia));
  }
}

// A plan takes it from the model's file.
TEST(FitBlocks, OfOneDofEachKnowTheColourOfTheirNoise) {
  std::mt19937 random(11);
  const CoupledModel truth = DrawnDiagonalVehicle(&random);
  DrawnLogOptions options;
  options.colour = 0.8;
  CoupledIdentificationOptions how;
  how.dofs = truth.dofs;
  how.structure = StandardStructure::kDiagonal;
  const CoupledIdentification found =
      IdentifyCoupled({LogFileOf(DrawnLog(truth, options, &random))}, how);
  ASSERT_TRUE(found.is_usable) << found.message;
  for (const auto& colour : found.fitted.residual_autoregression) {
    ASSERT_TRUE(colour && !colour->empty());
    EXPECT_NEAR(colour->front(), options.colour, 0.1);
  }
}

// A boat whose thrusters push ahead and turn it, but not sideways: what moves it in sway is some
// offset alone. The data tell its damping by its inertia, not the two.
TEST(FitBlocks, TakesAnInertiaThatNothingDrivesForOneLikeTheOthers) {
  std::mt19937 random(12);
  CoupledModel truth = DrawnPlanarVehicle(&random);
  truth.coriolis = false;
  DrawnLogOptions options;
  options.force[1] = 0.0;
  CoupledLogs logs;
  logs.data = {DrawnLog(truth, options, &random)};
  const CoupledSummary fit = FitBlocks(logs, DiagonalStructure(truth.dofs), {});
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  ASSERT_EQ(fit.priors.size(), 1u);
  EXPECT_EQ(fit.priors[0].entry, InertiaEntry(Dof::kSway, Dof::kSway));
  EXPECT_NEAR(fit.priors[0].centre, truth.inertia(0, 0), 0.05 * truth.inertia(0, 0));
  EXPECT_GT(fit.model.inertia(1, 1), 0.25 * fit.priors[0].centre);
  EXPECT_LT(fit.model.inertia(1, 1), 4.0 * fit.priors[0].centre);
  EXPECT_NEAR(fit.model.inertia(5, 5), truth.inertia(5, 5), 0.05 * truth.inertia(5, 5));
}

}  // namespace
}  // namespace fathom
