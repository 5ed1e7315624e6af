// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/solve/active_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kResolution = 1e-8;
constexpr double kOffset = 100.0;  // cost of the free optimum
const std::vector<int> kBounded = {1, 2};

std::vector<int> Rest(const std::vector<int>& held, int size) {
  std::vector<int> rest;
  for (int i = 0; i < size; ++i) {
    if (std::find(held.begin(), held.end(), i) == held.end()) rest.push_back(i);
  }
  return rest;
}

// 1/2 (x - centre)' H (x - centre) + kOffset, with a search that stops short of each optimum by
// `slack`, a share of the cost, in a random direction: as Ceres' does.
class Quadratic final : public BoundedSearch {
 public:
  Quadratic(Eigen::MatrixXd H, Eigen::VectorXd centre, double slack, unsigned seed)
      : H_(std::move(H)), centre_(std::move(centre)), slack_(slack), generator_(seed) {
    x_ = Eigen::VectorXd::Ones(centre_.size());
  }

  double CostAt(const Eigen::VectorXd& x) const {
    return 0.5 * (x - centre_).dot(H_ * (x - centre_)) + kOffset;
  }

  // The exact optimum with `held` at 0.
  Eigen::VectorXd OptimumWith(const std::vector<int>& held) const {
    Eigen::VectorXd x = centre_;
    for (const int i : held) x[i] = 0.0;
    const auto rest = Rest(held, static_cast<int>(x.size()));
    const Eigen::VectorXd slope = (H_ * (x - centre_))(rest);
    const Eigen::MatrixXd block = H_(rest, rest);
    x(rest) -= block.llt().solve(slope);
    return x;
  }

  // The least cost over the four sets' optima that are feasible.
  double Truth() const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& held : std::vector<std::vector<int>>{{}, {1}, {2}, {1, 2}}) {
      const Eigen::VectorXd x = OptimumWith(held);
      if (x[1] >= 0.0 && x[2] >= 0.0) least = std::min(least, CostAt(x));
    }
    return least;
  }

  Optimum Solve(const std::vector<int>& held) override {
    ++num_solves;
    for (const int i : held) EXPECT_EQ(x_[i], 0.0);
    x_ = OptimumWith(held);
    const auto rest = Rest(held, static_cast<int>(x_.size()));
    std::normal_distribution<double> normal;
    Eigen::VectorXd away(static_cast<Eigen::Index>(rest.size()));
    for (double& value : away) value = normal(generator_);
    const Eigen::MatrixXd block = H_(rest, rest);
    const double cost = 0.5 * away.dot(block * away);
    x_(rest) += std::sqrt(slack_ * kOffset / cost) * away;
    return {true, CostAt(x_), "converged"};
  }

  double Value(int unknown) const override { return x_[unknown]; }
  void SetToZero(int unknown) override { x_[unknown] = 0.0; }
  std::vector<double> Point() const override { return {x_.begin(), x_.end()}; }
  void GoTo(const std::vector<double>& point) override {
    x_ = Eigen::VectorXd::Map(point.data(), static_cast<Eigen::Index>(point.size()));
  }

  const Eigen::VectorXd& x() const { return x_; }

  int num_solves = 0;

 private:
  const Eigen::MatrixXd H_;
  const Eigen::VectorXd centre_;
  const double slack_;
  std::mt19937 generator_;
  Eigen::VectorXd x_;
};

// Four unknowns, strongly correlated, the free optimum anywhere about the corner.
Quadratic RandomQuadratic(unsigned seed, double slack) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Eigen::Matrix4d A;
  for (double& value : A.reshaped()) value = normal(generator);
  Eigen::Vector4d centre;
  for (double& value : centre) value = 0.1 * normal(generator);
  return {A.transpose() * A + 1e-3 * Eigen::Matrix4d::Identity(), centre, slack, seed};
}

TEST(ActiveSet, FindsTheLeastOfAllFourSets) {
  std::vector<int> count(3);
  for (unsigned seed = 0; seed < 2000; ++seed) {
    Quadratic search = RandomQuadratic(seed, 0.1 * kResolution);
    const BoundedOptimum found = SearchActiveSet(kBounded, kResolution, &search);
    ASSERT_TRUE(found.converged) << seed << " " << found.message;
    ++count[found.held.size()];
    EXPECT_GE(std::min(search.x()[1], search.x()[2]), 0.0) << seed;
    for (const int i : found.held) EXPECT_EQ(search.x()[i], 0.0) << seed;
    EXPECT_EQ(found.cost, search.CostAt(search.x()));
    EXPECT_NEAR(found.cost, search.Truth(), 2.0 * kResolution * kOffset) << seed;
    EXPECT_LE(search.num_solves, 8) << seed;
  }
  for (const int number : count) EXPECT_GT(number, 200);  // all of them occur
}

// The other unknowns' remaining slopes at a held optimum say nothing about which side of the bound
// the free optimum is on, if that is near: the slope at the bound has the wrong sign in half of
// the searches.
TEST(ActiveSet, EndsWhereTheSlopeAtTheBoundIsBelowWhatTheSearchResolves) {
  Eigen::Matrix3d H;
  H << 100.0, 0.0, -99.0, 0.0, 1.0, 0.0, -99.0, 0.0, 100.0;
  int wrong_slopes = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    // Held, it costs 0.5 * 1.99 * 1e-6, of which the search resolves 1e-6.
    Quadratic search(H, Eigen::Vector3d(1.0, 1.0, -1e-3), 1e-9, seed);
    Quadratic held = search;
    held.SetToZero(2);
    held.Solve({2});
    if ((H * (held.x() - Eigen::Vector3d(1.0, 1.0, -1e-3)))[2] < 0.0) ++wrong_slopes;
    const BoundedOptimum found = SearchActiveSet(kBounded, kResolution, &search);
    EXPECT_TRUE(found.converged) << found.message;
    EXPECT_NEAR(found.cost, search.Truth(), 2.0 * kResolution * kOffset);
    EXPECT_GE(search.x()[2], 0.0);
  }
  EXPECT_GT(wrong_slopes, 20);  // or nothing is tested
}

// Runs off where the second unknown is free and begins below 1.
class RunsOff final : public BoundedSearch {
 public:
  explicit RunsOff(bool always) : always_(always) {}
  Optimum Solve(const std::vector<int>& held) override {
    const auto is_free = [&held](int unknown) {
      return std::find(held.begin(), held.end(), unknown) == held.end();
    };
    if (always_ || (is_free(2) && x_[2] < 0.0)) return {false, 1e9, "it ran off."};
    if (is_free(2)) x_[2] = 2.0;
    x_[1] = is_free(1) ? 3.0 : 0.0;
    const double a = x_[1] - 3.0, b = x_[2] - 2.0;
    return {true, 1.0 + a * a + b * b, "converged"};
  }
  double Value(int unknown) const override { return x_[unknown]; }
  void SetToZero(int unknown) override { x_[unknown] = 0.0; }
  std::vector<double> Point() const override { return x_; }
  void GoTo(const std::vector<double>& point) override { x_ = point; }

 private:
  const bool always_;
  std::vector<double> x_ = {0.0, -5.0, -5.0};
};

TEST(ActiveSet, StartsFromTheBoundsIfTheFreeSearchRunsOff) {
  RunsOff search(false);
  const BoundedOptimum found = SearchActiveSet(kBounded, kResolution, &search);
  ASSERT_TRUE(found.converged) << found.message;
  EXPECT_EQ(search.Value(1), 3.0);
  EXPECT_EQ(search.Value(2), 2.0);
  EXPECT_TRUE(found.held.empty());
}

// 3 + x, without end: a search of the free unknown runs out of iterations while it still goes down.
class EndlessSlope final : public BoundedSearch {
 public:
  Optimum Solve(const std::vector<int>& held) override {
    if (!held.empty()) return {true, 3.0 + x_, "converged"};
    ++num_solves;
    x_ -= 1000.0;
    return {false, 3.0 + x_, "out of iterations"};
  }
  double Value(int) const override { return x_; }
  void SetToZero(int) override { x_ = 0.0; }
  std::vector<double> Point() const override { return {x_}; }
  void GoTo(const std::vector<double>& point) override { x_ = point[0]; }

  int num_solves = 0;

 private:
  double x_ = 5.0;
};

TEST(ActiveSet, HoldsWhatGoesDownBelowItsBoundWithoutEnd) {
  EndlessSlope search;
  const BoundedOptimum found = SearchActiveSet({0}, kResolution, &search);
  ASSERT_TRUE(found.converged) << found.message;
  EXPECT_EQ(found.held, std::vector<int>{0});
  EXPECT_EQ(found.cost, 3.0);
  EXPECT_EQ(search.Value(0), 0.0);
}

// There is no bound to start from: it would be the same search again.
TEST(ActiveSet, DoesNotRepeatASearchWithoutBounds) {
  EndlessSlope search;
  EXPECT_FALSE(SearchActiveSet({}, kResolution, &search).converged);
  EXPECT_EQ(search.num_solves, 1);
}

TEST(ActiveSet, SaysWhyThereIsNoOptimum) {
  RunsOff search(true);
  const BoundedOptimum found = SearchActiveSet(kBounded, kResolution, &search);
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.message, "it ran off.");
}

}  // namespace
}  // namespace fathom
