// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/input_error.h"
#include "fathom/manoeuvres/manoeuvre_prediction.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "steered_log.h"
#include <Eigen/Core>
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kInertia = 200.0, kDamping = 80.0, kForce = 30.0;
constexpr double kAft = kAftOfSteeredLog, kAhead = kAheadOfSteeredLog;
constexpr double kLength = 4.0;

// Yaw alone, its damping and its rudder's force known to 5 %.
FittedCoupledModel YawModel() {
  FittedCoupledModel fitted;
  fitted.model.dofs = {Dof::kYaw};
  fitted.model.inertia(5, 5) = kInertia;
  fitted.model.linear_damping(5, 5) = kDamping;
  fitted.model.fin_force = {{"rudder", kForce}};
  fitted.entries = {LinearDampingEntry(Dof::kYaw, Dof::kYaw), FinForceEntry("rudder")};
  fitted.covariance = Eigen::Vector2d(16.0, 2.25).asDiagonal();
  return fitted;
}

PredictedFigure FigureOf(const ManoeuvrePrediction& report, const std::string& name) {
  const auto found = std::ranges::find_if(
      report.figures, [&](const PredictedFigure& figure) { return figure.figure.name == name; });
  return found == report.figures.end() ? PredictedFigure{} : *found;
}

// K = -f u^2 x / (d + f u x^2) and T = J / (d + f u x^2), their deviations to first order.
TEST(PredictSteering, GivesNomotosKAndTWithTheirIntervals) {
  const ManoeuvrePrediction report =
      PredictSteering(YawModel(), SteeredLog(""), SteeringUnits::kSi, {2000, 1});
  const double arm = kAft * kAft;
  const double damping = kDamping + kForce * kAhead * arm;
  const double K = -kForce * kAhead * kAhead * kAft / damping, T = kInertia / damping;
  const double by_damping = -K / damping, by_force = K / kForce * kDamping / damping;
  const double std_of_K = std::hypot(4.0 * by_damping, 1.5 * by_force);
  const double std_of_T = T / damping * std::hypot(4.0, 1.5 * kAhead * arm);
  const PredictedFigure found_K = FigureOf(report, "K"), found_T = FigureOf(report, "T");
  EXPECT_NEAR(found_K.figure.value, K, 1e-6 * K);
  EXPECT_NEAR(found_K.high - found_K.low, 2.0 * 1.96 * std_of_K, 0.2 * std_of_K);
  EXPECT_NEAR(found_T.figure.value, T, 1e-6 * T);
  EXPECT_NEAR(found_T.high - found_T.low, 2.0 * 1.96 * std_of_T, 0.2 * std_of_T);
}

// As MSS's Mariner: yaw alone gives a K of 0.07 1/s, where sway and yaw have 0.185.
TEST(PredictSteering, DoubtsAModelWithoutSway) {
  const auto doubts = [](const FittedCoupledModel& fitted) {
    Log log = SteeredLog("");
    log.velocity->columns.push_back("v");
    log.velocity->values.emplace_back(log.velocity->time.size(), 0.0);
    return PredictSteering(fitted, log, SteeringUnits::kSi, {0, 1}).sentences.size();
  };
  FittedCoupledModel with_sway = YawModel();
  with_sway.model.dofs = {Dof::kSway, Dof::kYaw};
  with_sway.model.inertia(1, 1) = kInertia;
  EXPECT_EQ(doubts(YawModel()), doubts(with_sway) + 1);
}

TEST(PredictSteering, DividesByTheLengthWhereAsked) {
  const Log log = SteeredLog("size: [4, 1, 0.5]\n");
  const ManoeuvrePrediction si = PredictSteering(YawModel(), log, SteeringUnits::kSi, {10, 1});
  const ManoeuvrePrediction prime =
      PredictSteering(YawModel(), log, SteeringUnits::kPrime, {10, 1});
  const auto ratio = [&](const char* name, const std::string& primed) {
    return FigureOf(si, name).figure.value / FigureOf(prime, primed).figure.value;
  };
  EXPECT_NEAR(ratio("K", "K'"), kAhead / kLength, 1e-9);
  EXPECT_NEAR(ratio("T", "T'"), kLength / kAhead, 1e-9);
  EXPECT_NEAR(ratio("I_z - N_rdot", "(I_z - N_rdot)'") / (500.0 * std::pow(kLength, 5)), 1.0, 1e-9);
  EXPECT_NEAR(
      ratio("N_delta", "N_delta'") / (500.0 * std::pow(kLength, 3) * kAhead * kAhead), 1.0, 1e-9);
}

// N_delta is that of the vehicle file: no number of the fit moves it, but rounding does.
TEST(PredictSteering, GivesNoIntervalOfWhatIsHeld) {
  FittedCoupledModel held = YawModel();
  held.entries.pop_back();
  held.covariance = Eigen::MatrixXd::Constant(1, 1, 16.0);
  const ManoeuvrePrediction report =
      PredictSteering(held, SteeredLog(""), SteeringUnits::kSi, {200, 1});
  const Table table = ManoeuvreTable(report);
  const auto row = std::ranges::find_if(
      table.rows, [](const TableRow& one) { return one.cells.front() == "N_delta"; });
  ASSERT_NE(row, table.rows.end());
  EXPECT_EQ(row->cells[1], FormatValue(FigureOf(report, "N_delta").figure.value));
  EXPECT_EQ(row->cells.back(), "-");
}

TEST(PredictSteering, NeedsALengthForThat) {
  EXPECT_THROW(PredictSteering(YawModel(), SteeredLog(""), SteeringUnits::kPrime, {10, 1}),
               InputError);
  EXPECT_THROW(ParseSteeringUnits("feet"), InputError);
}

}  // namespace
}  // namespace fathom
