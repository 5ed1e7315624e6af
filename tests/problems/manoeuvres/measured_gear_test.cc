// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/measured_gear.h"

#include "fathom/manoeuvres/measured_manoeuvre.h"
#include "fathom/simulate/coupled/manoeuvre_figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kInDegrees = std::numbers::pi / 180.0;

struct GearTruth {
  double rate = 12.0 * kInDegrees, delay = 0.43;  // [rad/s], [s]
  double angle = 15.0 * kInDegrees, heading = 5.0 * kInDegrees;
  double course = 0.0, fin_sign = -1.0, first_side = 1.0;
};

// A vessel by Nomoto's equation in steps of a millisecond, K 0.3 1/s and T 5 s; logged at 20 Hz.
// The rudder is straight for 2 s.
ManoeuvreTrack ZigzagLog(const GearTruth& truth, double duration = 80.0) {
  const double step = 1e-3, K = 0.3, T = 5.0;
  ManoeuvreTrack track;
  track.fin_sign = truth.fin_sign;
  double heading = 0.0, turn = 0.0, angle = 0.0, side = truth.first_side, since = 2.0;
  double order = 0.0;
  for (int k = 0; k * step < duration; ++k) {
    const double t = k * step;
    if (k % 50 == 0) {
      CoupledState state;
      const double shown = heading + truth.course;
      state.attitude << 0.0, 0.0, std::sin(0.5 * shown), std::cos(0.5 * shown);
      state.position << t, 0.1 * t, 0.0;
      track.time.push_back(t);
      track.heading.push_back(shown);
      track.angle.push_back(truth.fin_sign * angle);
      track.state.push_back(state);
    }
    if (t >= since && order != side * truth.angle) order = side * truth.angle;
    if (order == side * truth.angle && side * heading >= truth.heading) {
      side = -side;
      since = t + truth.delay;
    }
    angle += std::clamp(order - angle, -truth.rate * step, truth.rate * step);
    turn += step * (K * angle - turn) / T;
    heading += step * turn;
  }
  return track;
}

TEST(GearOf, FindsRateOrderAndDelayOfAZigzag) {
  for (const double side : {1.0, -1.0}) {
    GearTruth truth;
    truth.first_side = side;
    truth.fin_sign = side;
    truth.course = 1.2;
    const auto gear = GearOf(ZigzagLog(truth));
    ASSERT_TRUE(gear);
    ASSERT_TRUE(gear->IsZigzag());
    EXPECT_GE(gear->num_strokes, 3);
    EXPECT_NEAR(gear->angle, truth.angle, 1e-9);
    EXPECT_NEAR(gear->rate, truth.rate, 1e-3 * truth.rate);
    EXPECT_NEAR(gear->heading, truth.heading, 1e-9);
    // The course is midway between the headings at the strokes, which differ as the turns do.
    EXPECT_NEAR(gear->course, truth.course, 0.2 * kInDegrees);
    EXPECT_NEAR(gear->delay, truth.delay, 0.05);
  }
}

// It seems to begin before the sample that shows the heading of the order.
TEST(GearOf, FindsTheOrderWhereTheRudderGoesOverAtOnce) {
  GearTruth truth;
  truth.rate = 1e3;
  truth.delay = 0.0;
  truth.heading = 15.0 * kInDegrees;
  const auto gear = GearOf(ZigzagLog(truth));
  ASSERT_TRUE(gear);
  ASSERT_TRUE(gear->IsZigzag());
  EXPECT_NEAR(gear->heading, truth.heading, 1e-9);
  EXPECT_LT(gear->most_delay, 0.05);
}

TEST(GearOf, KnowsNoDelayOfARudderThatDoesNotFollowTheHeading) {
  ManoeuvreTrack track = ZigzagLog({});
  for (std::size_t k = 0; k < track.time.size(); ++k) track.heading[k] = 0.001 * track.time[k];
  const auto gear = GearOf(track);
  ASSERT_TRUE(gear);
  EXPECT_FALSE(gear->IsZigzag());
  std::ranges::fill(track.angle, 0.1);
  EXPECT_FALSE(GearOf(track));
}

TEST(MeasuredManoeuvre, CountsFromTheRuddersFirstMove) {
  GearTruth truth;
  truth.course = 0.7;
  const ManoeuvreTrack log = ZigzagLog(truth);
  const auto gear = GearOf(log);
  const Manoeuvre zigzag = ParseManoeuvre("zigzag:15/5");
  const auto measured = MeasuredManoeuvre(log, gear, zigzag);
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->time.front(), 0.0);
  EXPECT_NEAR(log.time.back() - measured->time.back(), 2.0, 0.1);
  EXPECT_EQ(measured->state.front().position.norm(), 0.0);
  // A track along the direction (1, 0.1), turned back by the course.
  const Eigen::Vector3d& end = measured->state.back().position;
  EXPECT_NEAR(std::atan2(end.y(), end.x()), std::atan(0.1) - gear->course, 1e-9);
  const auto figures = FiguresOf(zigzag, *measured);
  const double highest = *std::ranges::max_element(log.heading.begin(), log.heading.begin() + 400);
  EXPECT_NEAR(figures[0].value, (highest - gear->course - truth.heading) / kInDegrees, 1e-6);
}

TEST(MeasuredManoeuvre, IsNoneOfAnotherAngleOrderOrSide) {
  const ManoeuvreTrack log = ZigzagLog({});
  const auto gear = GearOf(log);
  for (const char* other : {"zigzag:20/5",
                            "zigzag:15/10",
                            "zigzag:-15/5",
                            "turning_circle:15",
                            "spiral",
                            "stop",
                            "pull_out"}) {
    EXPECT_FALSE(MeasuredManoeuvre(log, gear, ParseManoeuvre(other))) << other;
  }
}

TEST(MeasuredManoeuvre, HoldsACircleUntilTheRudderLeaves) {
  GearTruth truth;
  truth.heading = 4.0;  // never within this time
  ManoeuvreTrack log = ZigzagLog(truth, 60.0);
  for (std::size_t k = 1000; k < log.time.size(); ++k) log.angle[k] = 0.0;
  const auto measured = MeasuredManoeuvre(log, GearOf(log), ParseManoeuvre("turning_circle:15"));
  ASSERT_TRUE(measured);
  EXPECT_NEAR(measured->time.back(), 48.0, 0.15);
}

}  // namespace
}  // namespace fathom
