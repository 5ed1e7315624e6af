// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/manoeuvre.h"

#include "fathom/base/input_error.h"
#include "fathom/simulate/coupled/imo_limit.h"
#include "fathom/simulate/coupled/manoeuvre_figures.h"
#include "fathom/simulate/coupled/manoeuvre_run.h"
#include "fathom/simulate/coupled/steering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kInertia = 200.0, kDamping = 8.0, kForce = 30.0, kAft = -1.0;

// Yaw alone at a speed of 1 m/s: for small angles Nomoto's T dr/dt + r = K angle.
CoupledModel YawOnly() {
  CoupledModel model;
  model.dofs = {Dof::kYaw};
  model.inertia(5, 5) = kInertia;
  model.linear_damping(5, 5) = kDamping;
  model.fin_force = {{"rudder", kForce}};
  return model;
}

std::vector<CommandedFin> OneRudder() {
  Fin fin;
  fin.position << kAft, 0.0, 0.0;
  return {{"rudder", ArmsOf(fin), {}}};
}

double Figure(const std::vector<ManoeuvreFigure>& figures, const std::string& name) {
  for (const ManoeuvreFigure& figure : figures) {
    if (figure.name == name) return figure.value;
  }
  return NAN;
}

TEST(ParseManoeuvre, ReadsDegrees) {
  EXPECT_NEAR(ParseManoeuvre("turning_circle:35").angle, 35.0 * std::numbers::pi / 180.0, 1e-12);
  const Manoeuvre zigzag = ParseManoeuvre("zigzag:20/10");
  EXPECT_NEAR(zigzag.heading, 10.0 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_EQ(ParseManoeuvre("zigzag:-20/10").first_side, -1.0);
  EXPECT_EQ(ParseManoeuvre("zigzag:-20/10").angle, zigzag.angle);
  EXPECT_EQ(ParseManoeuvre("stop").astern, 1.0);
  EXPECT_EQ(ParseManoeuvre("stop:0").astern, 0.0);
  EXPECT_NEAR(ParseManoeuvre("spiral").angle, 25.0 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_NEAR(ParseManoeuvre("pull_out:15").angle, 15.0 * std::numbers::pi / 180.0, 1e-12);
  for (const char* wrong : {"zigzag:20",
                            "zigzag:20/0",
                            "turning_circle",
                            "loop:3",
                            "stop:-5",
                            "spiral:",
                            "pull_out:-20",
                            "stopp",
                            ""}) {
    EXPECT_THROW(ParseManoeuvre(wrong), InputError) << wrong;
  }
}

// As one whose orders move no faster.
TEST(RunManoeuvre, TurnsTheRudderAtTheRateThatTheModelLimitsItTo) {
  const Manoeuvre zigzag = ParseManoeuvre("zigzag:20/10");
  CoupledModel limited = YawOnly();
  limited.fin_rate_limit = {{"rudder", 0.04}};
  ManoeuvreOptions slow;
  slow.rudder_rate = 0.04;
  const auto track = RunManoeuvre(limited, OneRudder(), zigzag, {});
  const auto expected = RunManoeuvre(YawOnly(), OneRudder(), zigzag, slow);
  ASSERT_TRUE(track && expected);
  EXPECT_EQ(track->angle, expected->angle);
  EXPECT_EQ(track->heading, expected->heading);
  EXPECT_EQ(RudderRate(limited, OneRudder(), {}), 0.04);
}

// To starboard, on a circle whose radius the track itself shows.
TEST(RunManoeuvre, TurnsOnACircle) {
  CoupledModel model = YawOnly();
  model.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  model.inertia.diagonal() << 100.0, 150.0, 1.0, 1.0, 1.0, kInertia;
  model.coriolis = true;
  model.quadratic_damping(0, 0) = 20.0;
  model.linear_damping(1, 1) = 150.0;
  model.linear_damping(5, 5) = 100.0;
  ManoeuvreOptions options;
  options.force[0] = 20.0;
  const Manoeuvre circle = ParseManoeuvre("turning_circle:20");
  const auto track = RunManoeuvre(model, OneRudder(), circle, options);
  ASSERT_TRUE(track);
  const std::vector<ManoeuvreFigure> figures = FiguresOf(circle, *track);
  // Points of the second half turn, opposite to each other.
  double from_heading = std::numbers::pi, far = 0.0;
  std::size_t first = 0;
  while (track->heading[first] < from_heading) ++first;
  for (std::size_t k = first; k < track->time.size(); ++k) {
    far = std::max(far, (track->state[k].position - track->state[first].position).norm());
  }
  EXPECT_NEAR(2.0 * Figure(figures, "steady_radius"), far, 0.02 * far);
  EXPECT_GT(Figure(figures, "tactical_diameter"), 0.0);
  EXPECT_GT(Figure(figures, "advance"), 0.0);
}

// Of sway and yaw, with all that a hull and its rudder have about a straight track.
CoupledModel SwayAndYaw() {
  CoupledModel model = YawOnly();
  model.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  model.inertia.diagonal() << 100.0, 150.0, 1.0, 1.0, 1.0, kInertia;
  model.inertia(1, 5) = model.inertia(5, 1) = 12.0;
  model.coriolis = true;
  model.linear_damping(0, 0) = 10.0;
  model.lift(1, 1) = 180.0;
  model.lift(1, 5) = -20.0;
  model.lift(5, 1) = -15.0;
  model.lift(5, 5) = 130.0;
  return model;
}

// By hand: Coriolis forces of M at u are (M_11 u r) in sway and (M_22 - M_11) u v + M_26 u r in
// yaw; the fin's are f u^2 angle - f u (v + x r), and x times that.
TEST(SteeringOf, HoldsTheDerivativesByHand) {
  const double u = 1.5;
  const auto equations = SteeringOf(SwayAndYaw(), OneRudder(), u, 0.0);
  ASSERT_TRUE(equations);
  const double fin = kForce * u;
  const double Y_v = -180.0 * u - fin, Y_r = 20.0 * u - fin * kAft - 100.0 * u;
  const double N_v = 15.0 * u - fin * kAft - (150.0 - 100.0) * u;
  const double N_r = -130.0 * u - kDamping - fin * kAft * kAft - 12.0 * u;
  Eigen::Matrix2d force;
  force << Y_v, Y_r, N_v, N_r;
  EXPECT_TRUE(equations->force.isApprox(force, 1e-6)) << equations->force;
  // To starboard, by the fin behind: the force is to port.
  EXPECT_NEAR(equations->rudder[0], kForce * u * u * kAft, 1e-4);
  EXPECT_NEAR(equations->rudder[1], kForce * u * u * kAft * kAft, 1e-4);
  EXPECT_EQ(equations->inertia(0, 1), 12.0);
}

TEST(NomotoOf, IsTheEquationOfYawAlone) {
  const auto equations = SteeringOf(YawOnly(), OneRudder(), 1.0, 0.0);
  ASSERT_TRUE(equations);
  const double damping = kDamping + kForce * kAft * kAft;
  const Nomoto nomoto = NomotoOf(*equations);
  EXPECT_NEAR(nomoto.K, kForce * -kAft / damping, 1e-6);
  EXPECT_NEAR(nomoto.T, kInertia / damping, 1e-4);
  EXPECT_NEAR(nomoto.growth_rate, -damping / kInertia, 1e-6);
}

// A free run tells both: r settles at K angle, and the heading lags K angle t by K angle T.
TEST(NomotoOf, IsWhatASmallTurnSettlesAt) {
  CoupledModel model = SwayAndYaw();
  const Manoeuvre circle = ParseManoeuvre("turning_circle:0.1");
  ManoeuvreOptions options;
  options.force[0] = 10.0;  // holds 1 m/s
  options.longest = 60.0;
  const auto track = RunManoeuvre(model, OneRudder(), circle, options);
  ASSERT_TRUE(track);
  const Nomoto nomoto = NomotoOf(*SteeringOf(model, OneRudder(), 1.0, 0.0));
  EXPECT_GT(nomoto.T, 0.5);
  const double turn = nomoto.K * circle.angle;
  EXPECT_NEAR(track->state.back().nu[5], turn, 2e-3 * turn);
  EXPECT_NEAR(track->heading.back(), turn * (track->time.back() - nomoto.T), 5e-3 * turn * 60.0);
}

TEST(SteeringOf, NeedsARudderAndAYaw) {
  EXPECT_FALSE(SteeringOf(YawOnly(), {}, 1.0, 0.0));
  CoupledModel surge = YawOnly();
  surge.dofs = {Dof::kSurge};
  surge.inertia(0, 0) = 1.0;
  EXPECT_FALSE(SteeringOf(surge, OneRudder(), 1.0, 0.0));
}

// A rudder that answers later: the heading goes on for so long, at about the same rate.
// The lag goes on from step to step; an offset of clocks is none of the vehicle.
TEST(RunManoeuvre, TurnsItsRudderWithItsLag) {
  CoupledModel model = YawOnly();
  model.fin_lag[OneRudder().front().name] = 0.8;
  model.time_offset = 0.3;
  const Manoeuvre circle = ParseManoeuvre("turning_circle:20");
  const auto prompt = RunManoeuvre(YawOnly(), OneRudder(), circle, {});
  const auto lagging = RunManoeuvre(model, OneRudder(), circle, {});
  ASSERT_TRUE(prompt && lagging);
  for (std::size_t k = 0; k < 30; ++k) {
    const double share = 1.0 - std::exp(-lagging->time[k] / 0.8);
    EXPECT_NEAR(lagging->angle[k], share * prompt->angle.back(), 1e-9) << k;
  }
  EXPECT_NEAR(lagging->state.back().nu[5], prompt->state.back().nu[5], 1e-4);
}

// A delay may be shorter than a step of the simulation.
TEST(RunManoeuvre, OvershootsAsNomotosEquationDoesHoweverLateTheRudderAnswers) {
  const Manoeuvre zigzag = ParseManoeuvre("zigzag:1/1");
  const auto overshoot = [&](double delay) {
    ManoeuvreOptions options;
    options.rudder_delay = delay;
    const auto track = RunManoeuvre(YawOnly(), OneRudder(), zigzag, options);
    return Figure(FiguresOf(zigzag, *track), "first_overshoot") * std::numbers::pi / 180.0;
  };
  // By hand, the rudder turned at once: with r1 the rate and psi1 the heading when it turns,
  //   s = T log((r1 + K d) / (K d)), overshoot = psi1 + T r1 - K d s
  const double damping = kDamping + kForce * kAft * kAft;
  const double T = kInertia / damping, Kd = kForce * -kAft / damping * zigzag.angle;
  double low = 0.0, high = 100.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (Kd * (middle - T * (1.0 - std::exp(-middle / T))) < zigzag.heading ? low : high) = middle;
  }
  for (const double delay : {0.0, 0.03, 0.25, 0.73, 2.0}) {
    const double t1 = low + delay, r1 = Kd * (1.0 - std::exp(-t1 / T));
    const double beyond = Kd * (t1 - T * (1.0 - std::exp(-t1 / T))) - zigzag.heading;
    const double by_hand = beyond + T * r1 - Kd * T * std::log((r1 + Kd) / Kd);
    EXPECT_NEAR(overshoot(delay), by_hand, 2e-3 * by_hand) << delay;
  }
}

// A turn to port is one to starboard in a mirror.
TEST(RunManoeuvre, GivesTheSameFiguresToPort) {
  for (const char* name : {"turning_circle:20", "zigzag:10/10"}) {
    Manoeuvre manoeuvre = ParseManoeuvre(name);
    const auto starboard =
        FiguresOf(manoeuvre, *RunManoeuvre(YawOnly(), OneRudder(), manoeuvre, {}));
    manoeuvre.first_side = -1.0;
    const auto port = FiguresOf(manoeuvre, *RunManoeuvre(YawOnly(), OneRudder(), manoeuvre, {}));
    for (std::size_t k = 0; k < port.size(); ++k) {
      EXPECT_NEAR(port[k].value, starboard[k].value, 1e-6 * starboard[k].value) << port[k].name;
    }
  }
}

// Of Nomoto's equation the yaw rate is K angle on both ways: no loop, nothing left at midships.
TEST(RunManoeuvre, GoesThroughASpiralWithoutALoop) {
  const Manoeuvre spiral = ParseManoeuvre("spiral:6");
  // One degree takes nearly all of a step, whose mean is far from where the rudder then stands.
  const auto track = RunManoeuvre(YawOnly(), OneRudder(), spiral, {.rudder_rate = 0.18});
  ASSERT_TRUE(track);
  const double K = kForce * -kAft / (kDamping + kForce * kAft * kAft);
  ASSERT_EQ(track->steady.size(), 25u);  // 6, 5, ... -6 and back
  const double largest = K * spiral.angle;
  for (const SteadyTurn& turn : track->steady) {
    // The fin's force goes with sin(angle), 0.2 % less at 6 degrees.
    EXPECT_NEAR(turn.rate, K * turn.angle, 5e-3 * largest) << turn.angle;
  }
  const auto figures = FiguresOf(spiral, *track);
  EXPECT_NEAR(Figure(figures, "loop_width"), 0.0, 0.1);
  EXPECT_NEAR(
      Figure(figures, "rate_after_starboard"), 0.0, 5e-3 * largest * 180.0 / std::numbers::pi);
}

// J dr/dt = a r - b r |r| + c angle: left alone it turns at a / b, and the loop ends where the
// parabola a r - b r^2 has its top: at an angle of a^2 / (4 b c).
CoupledModel Unstable(double a, double b) {
  CoupledModel model = YawOnly();
  const double of_fin = kForce * kAft * kAft;
  model.linear_damping(5, 5) = -a - of_fin;
  model.quadratic_damping(5, 5) = b;
  return model;
}

TEST(RunManoeuvre, FindsTheLoopOfAnUnstableVehicle) {
  const double a = 60.0, c = kForce * -kAft, width_by_hand = 5.0 * std::numbers::pi / 180.0;
  const double b = a * a / (4.0 * c * 0.5 * width_by_hand);
  const Manoeuvre spiral = ParseManoeuvre("spiral:8");
  const auto track = RunManoeuvre(Unstable(a, b), OneRudder(), spiral, {});
  ASSERT_TRUE(track);
  const auto figures = FiguresOf(spiral, *track);
  EXPECT_NEAR(Figure(figures, "loop_width"), 5.0, 1.01);  // to the step of a degree
  const double left = a / b * 180.0 / std::numbers::pi;
  EXPECT_NEAR(Figure(figures, "rate_after_starboard"), left, 0.02 * left);
  EXPECT_NEAR(Figure(figures, "rate_after_port"), -left, 0.02 * left);
}

// While the rudder stands a spiral runs many samples at once, in longer steps. It is what a run
// from sample to sample is: `angle` is that at a sample, held since the one before.
TEST(RunManoeuvre, GoesThroughASpiralAsItWouldSampleBySample) {
  const CoupledModel model = Unstable(60.0, 3000.0);
  const auto track = RunManoeuvre(model, OneRudder(), ParseManoeuvre("spiral:8"), {});
  ASSERT_TRUE(track);
  CoupledInputs inputs;
  inputs.command.fins = OneRudder();
  inputs.measured[0] = {{0.0}, {1.0}};
  CoupledStamps stamps;
  for (std::size_t k = 0; k + 1 < track->time.size(); ++k) {
    inputs.command.time.push_back(track->time[k]);
    inputs.command.fins[0].angle.push_back(track->angle[k + 1]);
    stamps.velocity.push_back(track->time[k + 1]);
  }
  CoupledOutputs outputs;
  ASSERT_TRUE(RunCoupled(model, inputs, track->state.front(), stamps, &outputs));
  double largest = 0.0, farthest = 0.0;
  for (std::size_t k = 0; k < outputs.velocity.size(); ++k) {
    largest = std::max(largest, std::abs(outputs.velocity[k][5]));
    farthest = std::max(farthest, std::abs(outputs.velocity[k][5] - track->state[k + 1].nu[5]));
  }
  // What leaves a turn that is not stable grows, and so does the scheme's error of some 1e-5.
  // Steady is what changes by less than 1e-3.
  EXPECT_GT(largest, 0.01);
  EXPECT_LT(farthest, 3e-4 * largest);
}

TEST(RunManoeuvre, PullsOutOfATurn) {
  const Manoeuvre pull_out = ParseManoeuvre("pull_out:3");
  const auto stable = FiguresOf(pull_out, *RunManoeuvre(YawOnly(), OneRudder(), pull_out, {}));
  const double K = kForce * -kAft / (kDamping + kForce * kAft * kAft);
  EXPECT_NEAR(Figure(stable, "rate_to_starboard"), 3.0 * K, 5e-3 * 3.0 * K);
  EXPECT_NEAR(Figure(stable, "rate_after_starboard"), 0.0, 5e-3 * 3.0 * K);
  EXPECT_NEAR(Figure(stable, "rate_to_port"), -3.0 * K, 5e-3 * 3.0 * K);
  const auto unstable =
      FiguresOf(pull_out, *RunManoeuvre(Unstable(10.0, 200.0), OneRudder(), pull_out, {}));
  const double left = 10.0 / 200.0 * 180.0 / std::numbers::pi;
  EXPECT_NEAR(Figure(unstable, "rate_after_starboard"), left, 0.02 * left);
  EXPECT_NEAR(Figure(unstable, "rate_after_port"), -left, 0.02 * left);
}

// m du/dt = -F - D u^2 from U on: the track is m / (2 D) log(1 + D U^2 / F), the time
// sqrt(m^2 / (D F)) atan(U sqrt(D / F)). No rudder is needed.
TEST(RunManoeuvre, StopsAsTheEquationByHandDoes) {
  CoupledModel model;
  model.dofs = {Dof::kSurge, Dof::kYaw};
  model.inertia(0, 0) = 300.0;
  model.inertia(5, 5) = kInertia;
  model.linear_damping(5, 5) = kDamping;
  model.quadratic_damping(0, 0) = 20.0;
  ManoeuvreOptions options;
  options.ahead = 1.5;
  options.force[0] = 40.0;
  options.thrust = 40.0;
  for (const double share : {1.0, 0.5}) {
    Manoeuvre stop = ParseManoeuvre("stop");
    stop.astern = share;
    const auto track = RunManoeuvre(model, {}, stop, options);
    ASSERT_TRUE(track);
    const auto figures = FiguresOf(stop, *track);
    const double F = share * 40.0, D = 20.0, m = 300.0, U = 1.5;
    EXPECT_NEAR(
        Figure(figures, "track_reach"), m / (2.0 * D) * std::log(1.0 + D * U * U / F), 0.01);
    EXPECT_NEAR(Figure(figures, "head_reach"), Figure(figures, "track_reach"), 1e-3);
    EXPECT_NEAR(Figure(figures, "lateral_deviation"), 0.0, 1e-9);
    EXPECT_NEAR(Figure(figures, "stop_time"),
                m / std::sqrt(D * F) * std::atan(U * std::sqrt(D / F)),
                options.step);
  }
  // Off: to 5 % of the speed in m / D (1 / u - 1 / U), over m / D log(20).
  const Manoeuvre off = ParseManoeuvre("stop:0");
  const auto figures = FiguresOf(off, *RunManoeuvre(model, {}, off, options));
  EXPECT_NEAR(Figure(figures, "stop_time"), 15.0 * (19.0 / 1.5), 1.01 * options.step);
  EXPECT_NEAR(Figure(figures, "track_reach"), 15.0 * std::log(20.0), 0.01);
}

// Astern K_T is that at rest: m du/dt = -F - d u with F the bollard pull, for half of which the
// shaft turns at the root of a half.
TEST(RunManoeuvre, StopsByAShaftAsTheEquationByHandDoes) {
  CoupledModel model;
  model.dofs = {Dof::kSurge};
  model.inertia(0, 0) = 300.0;
  model.linear_damping(0, 0) = 30.0;
  model.thrust_gain = {{"screw", 0.8}};
  Shaft shaft;
  shaft.name = "screw";
  shaft.diameter = 0.2;
  shaft.curve = OpenWaterCurve{{0.0, 0.9}, {0.36, 0.0}};
  shaft.thrust_deduction = 0.1;
  ManoeuvreOptions options;
  options.ahead = 1.2;
  options.shafts = {CommandedShaftOf(shaft)};
  options.shafts[0].turns = {9.0};
  for (const double share : {1.0, 0.5}) {
    Manoeuvre stop = ParseManoeuvre("stop");
    stop.astern = share;
    const auto track = RunManoeuvre(model, {}, stop, options);
    ASSERT_TRUE(track);
    const double F = share * 0.8 * 0.9 * 1000.0 * 0.0016 * 81.0 * 0.36, d = 30.0, m = 300.0;
    const double time = m / d * std::log(1.0 + d * 1.2 / F);
    const auto figures = FiguresOf(stop, *track);
    EXPECT_NEAR(Figure(figures, "stop_time"), time, options.step);
    EXPECT_NEAR(Figure(figures, "track_reach"), (m * 1.2 - F * time) / d, 0.01);
  }
}

// MSC.137(76), 5.3: of a ship of 100 m at 8 m/s, at 4 m/s and at 2 m/s; L/V is 12.5, 25 and 50 s.
TEST(ImoLimit, IsThatOfTheStandard) {
  const Manoeuvre circle = ParseManoeuvre("turning_circle:35"),
                  small = ParseManoeuvre("zigzag:10/10"), large = ParseManoeuvre("zigzag:20/20");
  EXPECT_DOUBLE_EQ(*ImoLimit(circle, "advance", 100.0, 8.0), 450.0);
  EXPECT_DOUBLE_EQ(*ImoLimit(circle, "tactical_diameter", 100.0, 8.0), 500.0);
  EXPECT_DOUBLE_EQ(*ImoLimit(small, "first_overshoot", 100.0, 8.0), 11.25);
  EXPECT_DOUBLE_EQ(*ImoLimit(small, "first_overshoot", 100.0, 2.0), 20.0);
  EXPECT_DOUBLE_EQ(*ImoLimit(small, "second_overshoot", 100.0, 4.0), 36.25);
  EXPECT_DOUBLE_EQ(*ImoLimit(small, "second_overshoot", 100.0, 50.0), 25.0);
  EXPECT_DOUBLE_EQ(*ImoLimit(large, "first_overshoot", 100.0, 8.0), 25.0);
  EXPECT_DOUBLE_EQ(*ImoLimit(ParseManoeuvre("stop"), "track_reach", 100.0, 8.0), 1500.0);
  EXPECT_FALSE(ImoLimit(ParseManoeuvre("stop:50"), "track_reach", 100.0, 8.0));
  EXPECT_FALSE(ImoLimit(large, "second_overshoot", 100.0, 8.0));
  EXPECT_FALSE(ImoLimit(ParseManoeuvre("turning_circle:20"), "advance", 100.0, 8.0));
}

TEST(RunManoeuvre, NeedsARudder) {
  EXPECT_FALSE(RunManoeuvre(YawOnly(), {}, ParseManoeuvre("turning_circle:20"), {}));
}

}  // namespace
}  // namespace fathom
