// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/barrier_cost.h"

#include "fathom/coupled/physical_barrier.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <ceres/cost_function.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

struct BarrierAsCost {
  CoupledFilm film;
  FilmUnknowns unknowns;
};

BarrierAsCost NearItsBounds() {
  BarrierAsCost of;
  CoupledModel model;
  model.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  model.inertia.diagonal() << 34.0, 47.0, 1.0, 1.0, 1.0, 3.4;
  model.inertia(1, 5) = model.inertia(5, 1) = 8.0;
  model.linear_damping.diagonal() << 0.02, 13.0, 0.0, 0.0, 0.0, 2.1;
  model.linear_damping(1, 5) = 1.3;
  model.linear_damping(5, 1) = -0.4;
  model.quadratic_damping.diagonal() << 28.0, 0.1, 0.0, 0.0, 0.0, 3.5;
  of.film.structure = StructureOf(StandardStructure::kFull, model.dofs);
  of.film.body.mass = 22.0;
  of.unknowns = FilmUnknownsAt(of.film, model);
  return of;
}

TEST(BarrierCost, GivesAStepTheBarriersSlopeAndCurvature) {
  const BarrierAsCost of = NearItsBounds();
  const auto cost = MakeBarrierCost(of.film, of.unknowns);
  const auto n = static_cast<Eigen::Index>(of.film.structure.entries.size());
  const auto m = static_cast<Eigen::Index>(of.unknowns.shared.size());
  Eigen::VectorXd r(n + 1);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> J(n + 1, m);
  const double* const blocks[] = {of.unknowns.shared.data()};
  double* jacobians[] = {J.data()};
  ASSERT_TRUE(cost->Evaluate(blocks, r.data(), jacobians));
  const PhysicalBarrier barrier =
      BarrierAt(of.unknowns.model, of.film.structure.entries, of.film.body);
  EXPECT_LT(((J.transpose() * r).head(n) - barrier.gradient).norm(),
            1e-9 * barrier.gradient.norm());
  EXPECT_LT(((J.transpose() * J).topLeftCorner(n, n) - barrier.hessian).norm(),
            1e-9 * barrier.hessian.norm());
}

TEST(BarrierCost, IsTheBarrierAndAConstant) {
  BarrierAsCost of = NearItsBounds();
  const auto cost = MakeBarrierCost(of.film, of.unknowns);
  const auto above = [&] {
    Eigen::VectorXd r(static_cast<Eigen::Index>(of.film.structure.entries.size()) + 1);
    const double* const blocks[] = {of.unknowns.shared.data()};
    EXPECT_TRUE(cost->Evaluate(blocks, r.data(), nullptr));
    const PhysicalBarrier barrier =
        BarrierAt(of.unknowns.Model(of.film.structure), of.film.structure.entries, of.film.body);
    return 0.5 * r.squaredNorm() - barrier.cost;
  };
  const double before = above();
  for (double& number : of.unknowns.shared) number *= 1.07;
  EXPECT_NEAR(above(), before, 1e-9);
}

TEST(BarrierCost, RefusesAnInertiaThatIsNotPositiveDefinite) {
  BarrierAsCost of = NearItsBounds();
  const auto cost = MakeBarrierCost(of.film, of.unknowns);
  for (std::size_t i = 0; i < of.film.structure.entries.size(); ++i) {
    if (NameOf(of.film.structure.entries[i]) == "inertia.sway.yaw") of.unknowns.shared[i] = 40.0;
  }
  Eigen::VectorXd r(static_cast<Eigen::Index>(of.film.structure.entries.size()) + 1);
  const double* const blocks[] = {of.unknowns.shared.data()};
  EXPECT_FALSE(cost->Evaluate(blocks, r.data(), nullptr));
}

}  // namespace
}  // namespace fathom
