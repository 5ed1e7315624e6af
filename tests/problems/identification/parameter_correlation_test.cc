// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/parameter_correlation.h"

#include <limits>

#include "handmade_identification.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

FittedModel Handmade() { return HandmadeRow(Family::kOutputError, 0.02, 0.03).fitted; }

void SetCovariance(int one, int other, double value, FittedModel* fitted) {
  fitted->covariance(one, other) = fitted->covariance(other, one) = value;
}

// Standard deviations 2 and 0.5, covariance -0.6.
TEST(ParameterCorrelation, IsTheCovarianceOverTheDeviations) {
  const auto table = CorrelationTable(Handmade());
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 3u);
  EXPECT_THAT(table->rows[0].cells, ElementsAre("quadratic damping", "0.00", "", ""));
  EXPECT_THAT(table->rows[1].cells, ElementsAre("linear damping", "−0.60", "0.00", ""));
  EXPECT_THAT(table->rows[2].cells, ElementsAre("buoyancy", "0.00", "0.00", "0.00"));
}

TEST(ParameterCorrelation, NamesThePairsThatAreHardlyToldApart) {
  FittedModel fitted = Handmade();
  EXPECT_THAT(CorrelationSentence(fitted), HasSubstr("No two parameters"));
  SetCovariance(kQuadraticDamping, kLinearDamping, -0.97 * 1.5 * 0.5, &fitted);
  EXPECT_THAT(CorrelationSentence(fitted),
              HasSubstr("hardly tells quadratic damping and linear damping (−0.97) apart"));
}

TEST(ParameterCorrelation, NeverRoundsToOne) {
  FittedModel fitted = Handmade();
  SetCovariance(kInertia, kBuoyancy, 0.99871 * 2.0 * 0.1, &fitted);
  EXPECT_EQ(CorrelationTable(fitted)->rows[2].cells[1], "0.9987");
}

TEST(ParameterCorrelation, IsNotSaidWhereTheCovarianceIsNotKnown) {
  FittedModel fitted = Handmade();
  fitted.covariance(kBuoyancy, kBuoyancy) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(CorrelationTable(fitted));
  EXPECT_EQ(CorrelationSentence(fitted), "");
}

}  // namespace
}  // namespace fathom
