// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/entry_prior.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

PhysicalBarrier NoBarrier() { return {0.0, Eigen::VectorXd::Zero(2), Eigen::MatrixXd::Zero(2, 2)}; }

// By central differences; the centre is passed at no slope.
TEST(AddPriors, HaveTheSlopeOfTheirCost) {
  const std::vector<FreeEntry> entries = {InertiaEntry(Dof::kSurge, Dof::kSurge),
                                          InertiaEntry(Dof::kSway, Dof::kSway)};
  const std::vector<EntryPrior> priors = {{entries[1], 30.0, 0.7}};
  const auto at = [&](double sway) {
    CoupledModel model;
    model.inertia.diagonal().head<2>() << 20.0, sway;
    PhysicalBarrier barrier = NoBarrier();
    AddPriors(model, entries, priors, &barrier);
    return barrier;
  };
  EXPECT_EQ(at(30.0).cost, 0.0);
  EXPECT_NEAR(at(30.0 * std::exp(1.4)).cost, 2.0, 1e-12);  // two standard deviations
  const double slope = (at(50.01).cost - at(49.99).cost) / 0.02;
  EXPECT_NEAR(at(50.0).gradient[1], slope, 1e-8);
  EXPECT_EQ(at(50.0).gradient[0], 0.0);
  EXPECT_NEAR(at(50.0).hessian(1, 1), 1.0 / (0.7 * 0.7 * 50.0 * 50.0), 1e-12);
}

TEST(InertiasAlike, AreThoseOfTheOtherAxesOfTheirKind) {
  CoupledModel model;
  model.inertia.diagonal() << 20.0, 500.0, 40.0, 0.0, 0.0, 3.0;
  std::vector<FreeEntry> told;
  for (const Dof dof : {Dof::kSurge, Dof::kSway, Dof::kHeave, Dof::kYaw}) {
    told.push_back(InertiaEntry(dof, dof));
  }
  const std::vector<FreeEntry> open = {InertiaEntry(Dof::kSway, Dof::kSway),
                                       InertiaEntry(Dof::kYaw, Dof::kYaw)};
  const std::vector<EntryPrior> priors = InertiasAlike(model, open, told);
  ASSERT_EQ(priors.size(), 1u);  // none of yaw, the only one about an axis
  EXPECT_EQ(priors[0].entry, open[0]);
  EXPECT_EQ(priors[0].centre, 30.0);
}

}  // namespace
}  // namespace fathom
