// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/plan_coupled.h"

#include "fathom/coupled/coupled_fit.h"
#include "fathom/coupled_planning/coupled_plan_files.h"
#include "fathom/coupled_planning/kept_wrench.h"
#include "fathom/coupled_planning/wrench_run.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "boat_trial.h"
#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

constexpr double kQuick = 0.25;  // of the search's effort

std::string CoupledErrorOf(const CoupledPlanRequest& request) {
  return ErrorFrom([&] { PlanCoupledExperiment(request); });
}

// Played by the truth, the plan stays within the limits, and a fit to it has the intervals that
// were predicted. By chance a fit widens some of its intervals, where its scores scatter: by a
// quarter and more for one entry of ten.
TEST(PlanCoupled, IntervalsAreThoseOfTheNextFit) {
  const DrawnBoat boat = DrawBoat(21);
  const CoupledPlanRequest request = BoatRequest(boat, 80.0, kQuick);
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  const CoupledData still = PlayedLog(boat.truth, plan.command, 90.0, 0.0, 1);
  const CoupledSegment& run = still.segments.front();
  for (std::size_t i = 0; i < run.time.size(); ++i) {
    for (const Dof dof : boat.truth.dofs) {
      EXPECT_LE(std::abs(run.velocity[i][Index(dof)]), request.limits.speed[Index(dof)]);
    }
    EXPECT_LE(run.position[i].head<2>().cwiseAbs().maxCoeff(), 8.0);
  }
  const std::vector<CoupledData> next = {
      PlayedLog(boat.truth, plan.command, plan.duration, kBoatNoise, 2)};
  const CoupledSummary fit =
      FitCoupled(next, StructureOf(StandardStructure::kCoriolis, boat.truth.dofs));
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  ASSERT_EQ(fit.entries, boat.fitted.entries);
  std::vector<double> ratios;
  for (std::size_t k = 0; k < fit.entries.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    ratios.push_back(std::sqrt(fit.covariance(at, at)) / plan.parameters[k].after);
    EXPECT_GT(ratios.back(), 0.8) << plan.parameters[k].name;
    EXPECT_LT(ratios.back(), 1.6) << plan.parameters[k].name;
  }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_NEAR(ratios[ratios.size() / 2], 1.0, 0.15);
  EXPECT_LT(ratios[ratios.size() * 3 / 4], 1.25);
}

// The model is not fitted to the first log played, so that it counts in full: a fit to it and the
// planned one has the intervals that were predicted, and without it the plan alone tells less.
TEST(PlanCoupled, CountsAFlownLogAsAFitToBothDoes) {
  const DrawnBoat boat = DrawBoat(21);
  CoupledPlanRequest request = BoatRequest(boat, 40.0, kQuick);
  const CoupledPlan alone = PlanCoupledExperiment(request);
  ASSERT_TRUE(alone.IsUsable()) << alone.message;
  const CoupledData flown = PlayedLog(boat.truth, alone.command, alone.duration, kBoatNoise, 5);
  request.flown = {flown};
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  const CoupledSummary fit = FitCoupled(
      std::vector<CoupledData>{flown,
                               PlayedLog(boat.truth, plan.command, plan.duration, kBoatNoise, 6)},
      StructureOf(StandardStructure::kCoriolis, boat.truth.dofs));
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  std::vector<double> ratios;
  for (std::size_t k = 0; k < fit.entries.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    const PlannedParameter& entry = plan.parameters[k];
    ratios.push_back(std::sqrt(fit.covariance(at, at)) / entry.after);
    EXPECT_LT(entry.before, alone.parameters[k].before) << entry.name;
    EXPECT_LT(entry.after, alone.parameters[k].after) << entry.name;
  }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_NEAR(ratios[ratios.size() / 2], 1.0, 0.15);
}

// In shares of itself, and of the greatest force for an offset.
double Weakest(const CoupledPlan& plan,
               const CoupledLimits& limits,
               double PlannedParameter::*interval) {
  double weakest = 0.0;
  for (const PlannedParameter& entry : plan.parameters) {
    const FreeEntry named = ParseFreeEntry(entry.name);
    const double size = named.kind == FreeEntry::Kind::kOffset ? limits.force[Index(named.row)]
                                                               : std::abs(entry.value);
    weakest = std::max(weakest, entry.*interval / size);
  }
  return weakest;
}

TEST(PlanCoupled, KnowsTheWeakestEntryBetterThanASineOnOneAxisAfterTheOther) {
  for (const unsigned seed : {31u, 32u}) {
    const CoupledPlanRequest request = BoatRequest(DrawBoat(seed), 60.0, kQuick);
    const CoupledPlan plan = PlanCoupledExperiment(request);
    ASSERT_TRUE(plan.IsUsable()) << plan.message;
    EXPECT_LE(plan.share_breaking, 0.05);
    EXPECT_EQ(plan.num_models, 200);
    EXPECT_LT(Weakest(plan, request.limits, &PlannedParameter::after),
              Weakest(plan, request.limits, &PlannedParameter::sine));
    for (const PlannedParameter& entry : plan.parameters) {
      EXPECT_LE(entry.with_log_so_far, std::min(entry.before, entry.after)) << entry.name;
    }
    for (const double amplitude : plan.sine_amplitude) EXPECT_GT(amplitude, 0.0);
  }
}

// How far a boat that stays level truly turns under a plan, either way [rad].
double GreatestTurn(const DrawnBoat& boat, const CoupledPlan& plan) {
  const CoupledData played =
      PlayedLog(boat.truth, plan.command, plan.duration + kCoastAfterwards, 0.0, 1);
  const CoupledSegment& run = played.segments.front();
  double heading = 0.0, greatest = 0.0;
  for (std::size_t i = 1; i < run.time.size(); ++i) {
    heading +=
        0.5 * (run.velocity[i - 1][5] + run.velocity[i][5]) * (run.time[i] - run.time[i - 1]);
    greatest = std::max(greatest, std::abs(heading));
  }
  return greatest;
}

// What a camera needs: played by the truth, the bow stays near the wall of markers.
TEST(PlanCoupled, KeepsTheHeadingThatItsLimitsAskFor) {
  const DrawnBoat boat = DrawBoat(33);
  CoupledPlanRequest request = BoatRequest(boat, 40.0, 0.1);
  const CoupledPlan anywhere = PlanCoupledExperiment(request);
  ASSERT_TRUE(anywhere.IsUsable()) << anywhere.message;
  EXPECT_GT(GreatestTurn(boat, anywhere), 0.8);
  EXPECT_TRUE(anywhere.heading.value.empty());
  request.limits.heading = 0.5;
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  const double turn = GreatestTurn(boat, plan);
  EXPECT_LE(turn, 0.5);
  EXPECT_GT(turn, 0.2);
  // Nearly all models of the log turn less than this.
  const double most =
      std::max(std::ranges::max(plan.heading.high), -std::ranges::min(plan.heading.low));
  EXPECT_LE(turn, most);
  EXPECT_LE(most, 0.5);
}

TEST(PlanCoupled, GivesTheSamePlanToTheBitForTheSameSeed) {
  const CoupledPlanRequest request = BoatRequest(DrawBoat(41), 20.0, 0.1);
  const std::string first = FormatCoupledPlan(request, PlanCoupledExperiment(request));
  EXPECT_EQ(FormatCoupledPlan(request, PlanCoupledExperiment(request)), first);
  CoupledPlanRequest other = request;
  other.seed = 2;
  EXPECT_NE(FormatCoupledPlan(other, PlanCoupledExperiment(other)), first);
}

TEST(PlanCoupled, CommandsTheAxesThatAreAskedForAndSaysWhatTheyLeaveOpen) {
  CoupledPlanRequest request = BoatRequest(DrawBoat(41), 20.0, 0.1);
  request.dofs = {Dof::kSurge};
  request.model.model.offset[1] = request.model.model.offset[5] = 0.0;
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  ASSERT_EQ(plan.axes.size(), 1U);
  for (const Vector6& force : plan.command.force) {
    EXPECT_LE(std::abs(force[0]), 40.0);
    EXPECT_EQ(force.tail<5>(), (Eigen::Matrix<double, 5, 1>::Zero()));
  }
  EXPECT_EQ(plan.command.force.back(), Vector6::Zero());
  for (const PlannedParameter& entry : plan.parameters) {
    // Offsets drive a vehicle that nothing else drives, but little.
    if (entry.name.find("offset") != std::string::npos) continue;
    const bool is_told = entry.name.find("surge") != std::string::npos;
    EXPECT_EQ(entry.after < 5.0 * entry.before, is_told)
        << entry.name << ' ' << entry.after << ' ' << entry.before;
  }
}

TEST(PlanCoupled, LeavesOutWhatAWrenchDoesNotTell) {
  CoupledPlanRequest request = BoatRequest(DrawBoat(41), 20.0, 0.1);
  const Eigen::Index size = request.model.covariance.rows();
  request.model.entries.push_back(ThrustGainEntry("port"));
  request.model.model.thrust_gain["port"] = 0.9;
  request.model.covariance.conservativeResizeLike(Eigen::MatrixXd::Zero(size + 1, size + 1));
  request.model.covariance(size, size) = 1e-4;
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  EXPECT_EQ(plan.left_out, std::vector<std::string>{"thrust_gain.port"});
  EXPECT_EQ(static_cast<Eigen::Index>(plan.parameters.size()), size);
}

TEST(PlanCoupled, RefusesAModelOfWhichAWrenchTellsNothing) {
  const std::string refusal =
      "boat.json: holds no identified number that a wrench tells of, expected one: of single "
      "thrusters, fins and clocks it tells nothing. fathom_identify --dofs writes it.";
  CoupledPlanRequest request = BoatRequest(DrawBoat(41), 20.0, 0.1);
  request.model.entries = {ThrustGainEntry("port")};
  request.model.covariance = Eigen::MatrixXd::Constant(1, 1, 1e-4);
  EXPECT_EQ(CoupledErrorOf(request), refusal);
  request.model.entries.clear();  // all of them held
  request.model.covariance.resize(0, 0);
  EXPECT_EQ(CoupledErrorOf(request), refusal);
}

// A window of a stamp, and no endless number of them.
TEST(PlanCoupled, TakesAHorizonBelowAPeriodForAPeriod) {
  CoupledPlanRequest request = BoatRequest(DrawBoat(41), 5.0, 0.1);
  request.model.horizon = 1e-300;
  EXPECT_TRUE(PlanCoupledExperiment(request).IsUsable());
}

// A twentieth of 40 kN passes the limits within one hold.
TEST(PlanCoupled, UsesTheForceThatItsLimitsLeave) {
  CoupledPlanRequest request = BoatRequest(DrawBoat(41), 40.0, 0.1);
  request.limits.force[0] = request.limits.force[1] = 40000.0;
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  EXPECT_LT(plan.axes[0].force, 1000.0);
  double fastest = 0.0;
  for (const double speed : plan.speed[0].value) fastest = std::max(fastest, std::abs(speed));
  EXPECT_GT(fastest, 0.2);
}

// A lag is the vehicle's, and a wrench tells it; an offset is of two clocks.
TEST(PlanCoupled, TellsALagAndNoOffset) {
  CoupledPlanRequest request = BoatRequest(DrawBoat(41), 20.0, 0.1);
  const Eigen::Index size = request.model.covariance.rows();
  request.model.entries.push_back(ThrusterLagEntry());
  request.model.entries.push_back(TimeOffsetEntry());
  request.model.model.thruster_lag = 0.3;
  request.model.model.time_offset = -0.5;
  request.model.covariance.conservativeResizeLike(Eigen::MatrixXd::Zero(size + 2, size + 2));
  request.model.covariance(size, size) = request.model.covariance(size + 1, size + 1) = 0.01;
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  EXPECT_EQ(plan.left_out, std::vector<std::string>{"time_offset"});
  ASSERT_EQ(static_cast<Eigen::Index>(plan.parameters.size()), size + 1);
  EXPECT_EQ(plan.parameters.back().name, "thruster_lag");
  EXPECT_LT(plan.parameters.back().after, 0.03);
}

TEST(PlanCoupled, SaysWhatIsMissing) {
  const CoupledPlanRequest request = BoatRequest(DrawBoat(41), 20.0, 0.1);
  CoupledPlanRequest bad = request;
  bad.dofs = {Dof::kHeave};
  EXPECT_EQ(CoupledErrorOf(bad),
            "--dofs: names heave, which boat.json does not model, expected of surge, sway, yaw.");
  bad = request;
  bad.limits.force[1] = 0.0;
  bad.dofs = {Dof::kSway};
  EXPECT_EQ(CoupledErrorOf(bad).find("lake.yaml: key 'force' lacks sway, which --dofs names"), 0U);
  bad = request;
  bad.limits.force[2] = 5.0;
  EXPECT_EQ(CoupledErrorOf(bad),
            "lake.yaml: key 'force' holds heave, which boat.json does not model, expected of "
            "surge, sway, yaw.");
  bad = request;
  bad.limits.speed[4] = 0.5;
  EXPECT_EQ(CoupledErrorOf(bad),
            "lake.yaml: key 'speed' holds pitch, which boat.json does not model, expected of "
            "surge, sway, yaw.");
  bad = request;
  bad.model.train[5].mae = std::nan("");
  EXPECT_EQ(CoupledErrorOf(bad),
            "boat.json: does not say how much its fit missed of yaw, expected `velocity: {noise: "
            "{yaw: 0.01}}` in the limits file.");
  bad.limits.noise[5] = 0.01;
  EXPECT_TRUE(PlanCoupledExperiment(bad).IsUsable());
  bad = request;
  for (FitFigures& fit : bad.model.train) fit.duration = 1e-9;  // 1e11 samples a second and more
  EXPECT_EQ(CoupledErrorOf(bad),
            "boat.json: does not say how often its log measured the velocities, expected "
            "`velocity: {rate: 10}` in the limits file.");
  bad = request;
  bad.model.force_unit = "A";
  EXPECT_EQ(CoupledErrorOf(bad),
            "boat.json: commands are in A, expected N and N m: forces are planned.");
  bad = request;
  bad.limits.room[0] = {-1e-4, 1e-4};
  const CoupledPlan none = PlanCoupledExperiment(bad);
  EXPECT_FALSE(none.IsUsable());
  EXPECT_EQ(none.message.find("No command was found that keeps the limits"), 0U);
}

// Steps of all axes that differ from one second on.
CoupledCommand StepsFrom(int second, double level) {
  CoupledCommand command;
  for (int t = 0; t <= 40; ++t) {
    Vector6 force = Vector6::Zero();
    force[0] = 10.0 * (t % 7 - 3);
    force[5] = 1.0 * (t % 5 - 2);
    if (t >= second && t < 40) force[1] = level;
    command.time.push_back(t);
    command.force.push_back(force);
  }
  return command;
}

// What is remembered of one command changes nothing for the next.
TEST(WrenchInformation, OfACommandIsTheSameWhateverCameBefore) {
  const DrawnBoat boat = DrawBoat(41);
  WrenchMeasurement measurement = {0.1, {0.01, 0.02, 0.0, 0.0, 0.0, 0.03}, 20.0};
  WrenchInformation used(boat.truth, boat.fitted.entries, measurement);
  for (const auto& [second, level] : {std::pair{5, 3.0}, {30, 4.0}, {30, 5.0}, {10, 4.0}}) {
    WrenchInformation fresh(boat.truth, boat.fitted.entries, measurement);
    const CoupledCommand command = StepsFrom(second, level);
    EXPECT_EQ(*used.Of(command, 40.0), *fresh.Of(command, 40.0));
  }
}

TEST(KeptWrench, SaysOfACommandTheSameWhateverCameBefore) {
  const DrawnBoat boat = DrawBoat(41);
  const std::vector<CoupledModel> models = {boat.truth, boat.fitted.model};
  CoupledLimits limits;
  limits.speed[1] = 0.4;
  KeptWrench used(models, limits, 40.0);
  int num_kept = 0;
  for (const auto& [second, level] :
       {std::pair{30, 5.0}, {30, 60.0}, {35, 8.0}, {5, 60.0}, {33, 6.0}, {20, 60.0}, {36, 7.0}}) {
    const CoupledCommand command = StepsFrom(second, level);
    bool kept = true;
    for (const CoupledModel& model : models) {
      kept = kept && KeepsLimits(*WrenchMotion(
                                     model, command, WrenchLimitStamps(limits.shortest_hold, 40.0)),
                                 limits);
    }
    EXPECT_EQ(used.KeptByAll(command), kept) << second;
    num_kept += kept ? 1 : 0;
  }
  EXPECT_GT(num_kept, 1);
  EXPECT_LT(num_kept, 5);
}

}  // namespace
}  // namespace fathom
