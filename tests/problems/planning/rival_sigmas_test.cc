// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/rival_sigmas.h"

#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <cmath>

#include <Eigen/Core>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;

// Rows of unit noise by generic columns: a number of the model, the named cause, its rival.
Eigen::MatrixXd Columns() {
  Eigen::MatrixXd columns(6, 3);
  columns << 1.0, 0.3, 0.2, -0.5, 0.8, 0.9, 0.7, -1.2, -0.4, 2.0, 0.6, 0.1, -0.3, 0.4, 1.5, 0.9,
      1.1, -0.6;
  return columns;
}

TEST(SigmasOf, AreWhatIsLeftOfTheEffectAfterTheBestImitation) {
  const Eigen::MatrixXd columns = Columns();
  const Eigen::VectorXd effect = -2.5 * columns.col(1);
  Eigen::MatrixXd others(6, 2);
  others << columns.col(0), columns.col(2);
  const Eigen::VectorXd left = effect - others * LeastSquares(others, effect);
  const std::vector<double> sigmas = SigmasOf({{1, 2, -2.5}}, 2, columns.transpose() * columns);
  ASSERT_EQ(sigmas.size(), 1u);
  EXPECT_NEAR(sigmas[0], left.norm(), 1e-9);
}

TEST(SigmasOf, AreNoneBesideARivalThatMovesTheVehicleAlike) {
  Eigen::MatrixXd columns = Columns();
  columns.col(2) = 3.0 * columns.col(1) - 0.4 * columns.col(0);
  EXPECT_NEAR(SigmasOf({{1, 2, 1.5}}, 2, columns.transpose() * columns)[0], 0.0, 1e-5);
}

// One that leaves no trace imitates nothing.
TEST(SigmasOf, HoldARivalWithoutATrace) {
  Eigen::MatrixXd columns = Columns();
  columns.col(2).setZero();
  const Eigen::VectorXd own = columns.col(1) - columns.col(0) * columns.col(0).dot(columns.col(1)) /
                                                   columns.col(0).squaredNorm();
  EXPECT_NEAR(SigmasOf({{1, 2, 1.5}}, 2, columns.transpose() * columns)[0], 1.5 * own.norm(), 1e-9);
}

// In a run in which two causes differ little, the rival of the size that imitates the named one.
TEST(BothWays, TakeTheRivalForTrueAsLargeAsItImitatesTheNamedCause) {
  Eigen::MatrixXd columns = Columns();
  columns.col(2) = 4.0 * columns.col(1) - 0.4 * columns.col(0);
  const std::vector<PlacedRival> both = BothWays({{1, 2, 1.5}}, 2, columns.transpose() * columns);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[1].truth, 2);
  EXPECT_EQ(both[1].assumed, 1);
  EXPECT_NEAR(both[1].value, 1.5 / 4.0, 1e-6);
}

TEST(PlaceRivals, PutsBehindTheModelsEntriesWhatItLacks) {
  std::vector<FreeEntry> entries = {InertiaEntry(Dof::kSway, Dof::kSway),
                                    ParseFreeEntry("cubic_damping.sway")};
  const FreeEntry friction = ParseFreeEntry("coulomb_friction.sway");
  const std::vector<PlacedRival> placed = PlaceRivals(
      {{entries[1], 90.0, friction}, {TimeOffsetEntry(), 0.2, ThrusterLagEntry()}}, &entries);
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_EQ(placed[0].truth, 1);
  EXPECT_EQ(placed[0].assumed, 2);
  EXPECT_EQ(placed[0].value, 90.0);
  EXPECT_EQ(placed[1].truth, 3);
  EXPECT_EQ(placed[1].assumed, 4);
  EXPECT_THAT(std::vector<FreeEntry>(entries.begin() + 2, entries.end()),
              ElementsAre(friction, TimeOffsetEntry(), ThrusterLagEntry()));
}

TEST(WorthOfSigmas, IsLedByTheLeast) {
  EXPECT_GT(WorthOfSigmas({3.0, 3.0}), WorthOfSigmas({2.0, 9.0}));
  EXPECT_GT(WorthOfSigmas({0.0, 3.0}), WorthOfSigmas({0.0, 2.0}));
}

}  // namespace
}  // namespace fathom
