// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/hypothesis_book.h"

#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/parameters.h"

#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// One cause at some values, all of them held on a bound or none.
Hypothesis With(std::string_view name, std::vector<double> values, bool is_on_bound) {
  Hypothesis hypothesis;
  hypothesis.fit.is_on_bound.assign(kNumParameters, false);
  hypothesis.fit.is_on_bound.resize(kNumParameters + values.size(), is_on_bound);
  hypothesis.fit.model.effects.push_back({FindEffect(name), {}, std::move(values)});
  return hypothesis;
}

TEST(IsPhysical, UnlessAnAmountPressesOnItsBound) {
  EXPECT_TRUE(IsPhysical(With("thrust_asymmetry", {0.3}, false)));
  EXPECT_FALSE(IsPhysical(With("thrust_asymmetry", {0.98}, true)));
}

TEST(IsPhysical, WhereAnAmountIsHeldAtNone) {
  EXPECT_TRUE(IsPhysical(With("thrust_dead_zone", {0.0}, true)));
}

// A memory longer than the log, say: that there is one shows all the same.
TEST(IsPhysical, WhereOnlyAShapeIsOnItsBound) {
  Hypothesis hypothesis = With("fluid_memory", {5.0, 100.0}, false);
  hypothesis.fit.is_on_bound.back() = true;
  EXPECT_TRUE(IsPhysical(hypothesis));
}

TEST(IsPhysical, WithoutACauseWhateverTheBaselineDoes) {
  Hypothesis hypothesis;
  hypothesis.fit.is_on_bound.assign(kNumParameters, true);
  EXPECT_TRUE(IsPhysical(hypothesis));
}

// A hypothesis of these suspects that gains so much, and two parameters' worth of BIC less.
Hypothesis Gaining(std::vector<int> suspects, double gain) {
  Hypothesis hypothesis;
  hypothesis.delta_bic = gain - 6.0 * static_cast<double>(suspects.size());
  hypothesis.suspects = std::move(suspects);
  hypothesis.gain = gain;
  hypothesis.fit.converged = true;
  hypothesis.fit.jacobian = RowMajorMatrix::Zero(1, 1);  // as of a model that can be simulated
  return hypothesis;
}

// Four suspects that must gain 10 alone and 15 beside others. Any gain is significant.
HypothesisBook Book() {
  Calibration calibration;
  calibration.thresholds.assign(4, 10.0);
  calibration.thresholds_beside.assign(4, 15.0);
  const Eigen::MatrixXd maxima = Eigen::MatrixXd::Constant(512, 4, 1.0);
  calibration.significance =
      Significance(maxima, std::vector<int>(4, 1), std::vector<double>(4, 1.0), 0.05);
  return HypothesisBook({}, calibration);
}

TEST(HypothesisBook, KeepsTheBetterOfTwoFitsOfTheSameCauses) {
  HypothesisBook book = Book();
  book.Add(Gaining({1}, 20.0));
  book.Add(Gaining({1}, 30.0));
  book.Add(Gaining({1}, 25.0));
  ASSERT_EQ(book.size(), 2);
  EXPECT_EQ(book.IndexOf({1}), 1);
  EXPECT_EQ(book[1].gain, 30.0);
}

TEST(HypothesisBook, FindsWhatIsLeftOfAHypothesisWithoutACause) {
  HypothesisBook book = Book();
  book.Add(Gaining({1}, 20.0));
  book.Add(Gaining({1, 3}, 60.0));
  EXPECT_EQ(book.IndexWithout(2, 3), 1);
  EXPECT_EQ(book.IndexWithout(2, 1), -1);
  EXPECT_EQ(book.IndexWithout(1, 1), 0);  // the baseline
}

// Beside another, a cause must gain more: of two the first one is spared that.
TEST(HypothesisBook, RanksByWhatIsGainedBeyondNoise) {
  HypothesisBook book = Book();
  book.Add(Gaining({1}, 20.0));
  book.Add(Gaining({0}, 22.0));
  book.Add(Gaining({0, 1}, 30.0));
  EXPECT_EQ(book.Worth(0), 0.0);
  EXPECT_EQ(book.Worth(1), 10.0);
  EXPECT_EQ(book.Worth(3), 5.0);
  EXPECT_EQ(book.RankedOfSize(1), std::vector({2, 1}));
}

// A search that ran out of iterations has a likelihood, which says nothing of its model.
TEST(HypothesisBook, RanksNoFitThatStoppedBeforeItArrived) {
  HypothesisBook book = Book();
  book.Add(Gaining({1}, 20.0));
  Hypothesis stopped = Gaining({2}, 500.0), better_of_the_same = Gaining({1}, 500.0);
  stopped.fit.converged = better_of_the_same.fit.converged = false;
  book.Add(stopped);
  book.Add(better_of_the_same);
  EXPECT_EQ(book.RankedOfSize(1), std::vector({1}));
  EXPECT_EQ(book[1].gain, 20.0);
  Hypothesis never_simulated = Gaining({3}, 500.0);
  never_simulated.fit.jacobian.resize(0, 0);
  book.Add(never_simulated);
  EXPECT_EQ(book.size(), 2);
}

TEST(HypothesisBook, SaysOfWhatNothingCame) {
  HypothesisBook book = Book();
  book.AddAttempt({1});
  book.AddAttempt({2});
  book.Add(Gaining({2}, 1.0));
  EXPECT_TRUE(book.HasFailed({1}));
  EXPECT_FALSE(book.HasFailed({2}));
  EXPECT_FALSE(book.HasFailed({3}));
}

TEST(FindRivals, AreThoseWithOneCauseReplacedThatAreNotMuchWorse) {
  HypothesisBook book = Book();
  book.Add(Gaining({0, 1}, 60.0));
  book.Add(Gaining({0, 2}, 55.0));  // 5 worse
  book.Add(Gaining({0, 3}, 50.0));  // 10 worse
  book.Add(Gaining({2, 3}, 59.0));  // both replaced
  book.Add(Gaining({1}, 60.0));     // of another size
  EXPECT_EQ(FindRivals(book, 1, 8.0), std::vector({2}));
  EXPECT_EQ(FindRivals(book, 1, 12.0), std::vector({2, 3}));
  EXPECT_TRUE(FindRivals(book, 0, 8.0).empty());
}

}  // namespace
}  // namespace fathom
