// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/format_value.h"

#include "fathom/base/not_known.h"

#include <limits>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(FormatValue, GivesTwoDigitsToTheDeviationAndEndsTheValueThere) {
  EXPECT_EQ(FormatValue(890.34, 4.23), "890.3 ± 4.2");
  EXPECT_EQ(FormatValue(-890.34, 42.3), "-890 ± 42");
  EXPECT_EQ(FormatValue(0.12345, 0.0067), "0.1235 ± 0.0067");
  EXPECT_EQ(FormatValue(12347.0, 231.0), "12350 ± 230");
}

TEST(FormatValue, RoundsTheDeviationUpToANewDigit) {
  EXPECT_EQ(FormatValue(890.34, 0.0996), "890.34 ± 0.10");
  EXPECT_EQ(FormatValue(890.34, 99.7), "890 ± 100");
}

TEST(FormatValue, ShowsAValueThatDrownsInItsDeviationWithoutASign) {
  EXPECT_EQ(FormatValue(-0.04, 1.3), "0.0 ± 1.3");
}

TEST(FormatValue, TakesAPowerOfTenOutOfVerySmallAndVeryLargeNumbers) {
  EXPECT_EQ(FormatValue(1.2343e-5, 5.6e-7), "(1.234 ± 0.056)e-05");
  EXPECT_EQ(FormatValue(1234567.0, 8900.0), "(1.2346 ± 0.0089)e+06");
}

TEST(FormatValue, LimitsTheDigitsOfAValueThatIsKnownAlmostExactly) {
  EXPECT_EQ(FormatValue(890.3, 1e-9), "890.3 ± 1e-09");
}

TEST(FormatValue, GivesFourDigitsToAValueWithoutADeviation) {
  EXPECT_EQ(FormatValue(890.34), "890.3");
  EXPECT_EQ(FormatValue(12345.6), "12346");
  EXPECT_EQ(FormatValue(0.99996), "1.000");
  EXPECT_EQ(FormatValue(0.0), "0");
  EXPECT_EQ(FormatValue(1.5e-7), "1.500e-07");
}

TEST(FormatValue, ShowsWhatIsMissingOrUnbounded) {
  EXPECT_EQ(FormatValue(kNotKnown), "-");
  EXPECT_EQ(FormatValue(kNotKnown, 1.0), "-");
  EXPECT_EQ(FormatValue(5.0, kInfinity), "5.000 ± inf");
  EXPECT_EQ(FormatValue(-kInfinity), "-inf");
  EXPECT_EQ(FormatValue(5.0, 0.0), "5.000 ± 0");
}

// 1.96 deviations to each side: 0.027, 0.000092, 8.2, 450.
TEST(FormatInterval, EndsBothNumbersWhereTheValueEnds) {
  EXPECT_EQ(FormatInterval(851.042, 0.014), "851.015 ... 851.069");
  EXPECT_EQ(FormatInterval(-0.80990, 0.000047), "-0.809992 ... -0.809808");
  EXPECT_EQ(FormatInterval(890.34, 4.2), "882.1 ... 898.6");
  EXPECT_EQ(FormatInterval(12347.0, 231.0), "11890 ... 12800");
  EXPECT_EQ(FormatInterval(1.2343e-5, 5.6e-7), "(1.125 ... 1.344)e-05");
}

TEST(FormatInterval, IsCutAtABoundThatTheValueKeeps) {
  EXPECT_EQ(FormatInterval(0.5, 0.5, 0.0), "0.00 ... 1.48");
  EXPECT_EQ(FormatInterval(-5.0, 0.5, 0.0), "-5.98 ... -4.02");
}

TEST(FormatInterval, ShowsWhatIsMissingOrExact) {
  EXPECT_EQ(FormatInterval(5.0, kNotKnown), "-");
  EXPECT_EQ(FormatInterval(5.0, kInfinity), "-");
  EXPECT_EQ(FormatInterval(kNotKnown, 1.0), "-");
  EXPECT_EQ(FormatInterval(5.0, 0.0), "5.000 ... 5.000");
  EXPECT_EQ(FormatInterval(890.3, 1e-9), "890.3 ... 890.3");
}

// Half widths 1.96 * 0.0153 = 0.030, 1.96 * 0.077 = 0.151 and 1.96 * 5.9 = 11.6.
TEST(UnitText, RaisesTheFigures) {
  EXPECT_EQ(UnitText("kg m^2/s"), "kg m²/s");
  EXPECT_EQ(UnitText("N m s^3/rad^3"), "N m s³/rad³");
  EXPECT_EQ(UnitText("s^2/m^2"), "s²/m²");
  EXPECT_EQ(UnitText("m/s"), "m/s");
  EXPECT_EQ(UnitText("m^"), "m^");
  EXPECT_EQ(UnitText(""), "");
}

TEST(WithInterval, ShowsTheUnitWithRaisedFigures) {
  EXPECT_EQ(WithInterval(852.5, 5.9, "kg m^2", -kInfinity, kInfinity),
            "852 kg m² (841 to 864 kg m²)");
}

TEST(WithInterval, RoundsAtTheFirstDigitOfTheHalfWidthOrTheSecondBehindAOne) {
  EXPECT_EQ(WithInterval(0.4211, 0.0153, "s", -kInfinity, kInfinity), "0.42 s (0.39 to 0.45 s)");
  EXPECT_EQ(WithInterval(4.965, 0.077, "N", -kInfinity, kInfinity), "4.96 N (4.81 to 5.12 N)");
  EXPECT_EQ(WithInterval(852.5, 5.9, "kg", -kInfinity, kInfinity), "852 kg (841 to 864 kg)");
}

// 1.96 * 230 = 451.
TEST(WithInterval, RoundsBeforeThePoint) {
  EXPECT_EQ(WithInterval(12345.0, 230.0, "N", -kInfinity, kInfinity), "12300 N (11900 to 12800 N)");
}

TEST(WithInterval, EndsAtTheBounds) {
  EXPECT_EQ(WithInterval(0.02, 0.03, "s", 0.0, kInfinity), "0.02 s (0.00 to 0.08 s)");
  EXPECT_EQ(WithInterval(0.97, 0.03, "", 0.0, 0.98), "0.97 (0.91 to 0.98)");
}

TEST(WithInterval, HasNoMinusBeforeAZero) {
  EXPECT_EQ(WithInterval(-0.001, 0.03, "N", -kInfinity, kInfinity), "0.00 N (-0.06 to 0.06 N)");
}

TEST(WithInterval, IsTheNumberAloneWithoutADeviation) {
  EXPECT_EQ(WithInterval(0.42113, kNotKnown, "s", 0.0, 20.0), "0.4211 s");
  EXPECT_EQ(WithInterval(0.42113, 0.0, "", 0.0, 20.0), "0.4211");
}

TEST(ShareText, KeepsTwoDigitsOfASmallShare) {
  EXPECT_EQ(ShareText(0.0127, 3), "0.013");
  EXPECT_EQ(ShareText(0.1, 4), "0.1000");
  EXPECT_EQ(ShareText(1.13e-5, 3), "1.1e-05");
  EXPECT_EQ(ShareText(0.0043, 3), "0.0043");
  EXPECT_EQ(ShareText(0.0, 3), "0.000");
  EXPECT_EQ(ShareText(std::numeric_limits<double>::quiet_NaN(), 3), "-");
}

TEST(WithInterval, WritesHugeNumbersWithAPowerOfTen) {
  EXPECT_EQ(WithInterval(3.21e7, 1.0e6, "N", -kInfinity, kInfinity),
            "3.21e+07 N (3.01e+07 to 3.41e+07 N)");
}

// A small motor's inertia, known to 2e-7 kg m^2: 1.96 * 2e-7 = 4e-7.
TEST(WithInterval, KeepsTheDigitsOfASmallNumber) {
  EXPECT_EQ(WithInterval(5.9941e-4, 2.0e-7, "kg m^2", 0.0, kInfinity),
            "0.0005994 kg m² (0.000599 to 0.0005998 kg m²)");
}

TEST(WithInterval, KeepsTheDigitsOfALargeNumber) {
  EXPECT_EQ(WithInterval(2.3456e6, 1.2e3, "kg", 0.0, kInfinity),
            "2.346e+06 kg (2.343e+06 to 2.348e+06 kg)");
}

}  // namespace
}  // namespace fathom
