// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/sensor_mount.h"

#include "fathom/base/random_stream.h"
#include "fathom/findings/pose_twist_check.h"

#include <cmath>
#include <cstdint>
#include <regex>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Mount {
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();  // of the sensor, from the pose's point [m]
  double angle = 0.0;                             // to starboard [rad]
  double delay = 0.0;                             // of the linear columns [s]
  double turns = 1.0;                             // times all rates
};

// Three minutes at 10 Hz of a vehicle that moves along and turns about all axes at drawn rates.
Log SeenFrom(const Mount& mount, int seed = 1) {
  RandomStream random(static_cast<std::uint64_t>(seed), "sensor mount");
  struct Sine {
    double size, rate, phase;
    double At(double t) const { return size * std::sin(rate * t + phase); }
  };
  const double sizes[] = {0.5, 0.2, 0.2, 0.1, 0.15, 0.3};
  std::vector<Sine> sines[6];
  for (int k = 0; k < 6; ++k) {
    const double size = sizes[k] * (k < 3 ? 1.0 : mount.turns);
    for (int n = 0; n < 3; ++n) {
      sines[k].push_back({size, 0.2 + 0.7 * random.Uniform(), 6.28 * random.Uniform()});
    }
  }
  const auto velocity_at = [&](double t) {
    Eigen::Vector<double, 6> nu = Eigen::Vector<double, 6>::Zero();
    for (int k = 0; k < 6; ++k) {
      for (const Sine& sine : sines[k]) nu[k] += sine.At(t);
    }
    return nu;
  };
  Log log;
  log.pose = Stream{{}, {"x", "y", "z", "qx", "qy", "qz", "qw"}, {}};
  log.pose->values.resize(7);
  log.velocity = Stream{{}, {"u", "v", "w"}, {{}, {}, {}}};
  const auto sensor_from_body = Eigen::AngleAxisd(-mount.angle, Eigen::Vector3d::UnitZ());
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond world_from_body = Eigen::Quaterniond::Identity();
  constexpr double kStep = 0.1;
  constexpr int kFine = 10;
  for (int i = 0; i < 1800; ++i) {
    const double t = kStep * i;
    const Eigen::Vector4d q = world_from_body.coeffs();
    log.pose->time.push_back(t);
    for (int k = 0; k < 3; ++k) {
      log.pose->values[k].push_back(position[k] + 0.01 * random.Normal());
    }
    for (int k = 0; k < 4; ++k) log.pose->values[3 + k].push_back(q[k]);
    const Eigen::Vector<double, 6> seen = velocity_at(t - mount.delay);
    const Eigen::Vector3d at_sensor =
        sensor_from_body * (seen.head<3>() + seen.tail<3>().cross(mount.arm));
    log.velocity->time.push_back(t);
    for (int k = 0; k < 3; ++k) {
      log.velocity->values[k].push_back(at_sensor[k] + 0.02 * random.Normal());
    }
    for (int n = 0; n < kFine; ++n) {
      const double h = kStep / kFine;
      const Eigen::Vector<double, 6> nu = velocity_at(t + (n + 0.5) * h);
      const Eigen::Vector3d turn = nu.tail<3>() * h;
      const Eigen::Quaterniond half(Eigen::AngleAxisd(turn.norm() / 2.0, turn.normalized()));
      position += (world_from_body * half) * nu.head<3>() * h;
      world_from_body = (world_from_body * half * half).normalized();
    }
  }
  return log;
}

std::vector<std::string> CodesOf(const std::vector<Finding>& findings) {
  std::vector<std::string> codes;
  for (const Finding& finding : findings) codes.push_back(finding.code);
  return codes;
}

// The number behind `before` and the interval behind it: value, from, to.
std::vector<double> NumbersBehind(const std::string& before, const std::string& sentence) {
  const std::regex number("-?[0-9]+\\.[0-9]+");
  const std::string rest = sentence.substr(sentence.find(before) + before.size());
  std::vector<double> numbers;
  for (auto it = std::sregex_iterator(rest.begin(), rest.end(), number);
       it != std::sregex_iterator() && numbers.size() < 3;
       ++it) {
    numbers.push_back(std::stod(it->str()));
  }
  return numbers;
}

TEST(SensorMount, SaysNothingOfASensorInItsPlace) {
  for (int seed = 1; seed <= 20; ++seed) {
    EXPECT_THAT(CodesOf(CheckPoseAgainstTwist(SeenFrom({}, seed))), IsEmpty()) << seed;
  }
}

TEST(SensorMount, FindsAnArmAlongEachAxis) {
  const auto findings = CheckPoseAgainstTwist(SeenFrom({.arm = {0.6, -0.4, 0.3}}));
  ASSERT_THAT(CodesOf(findings), ElementsAre("lever_arm"));
  EXPECT_EQ(findings[0].severity, Severity::kNote);
  EXPECT_THAT(findings[0].sentence, HasSubstr("from the point that pose.csv is of"));
  const double truth[] = {0.6, -0.4, 0.3};
  for (int k = 0; k < 3; ++k) {
    const auto numbers = NumbersBehind(std::string(1, "xyz"[k]) + " = ", findings[0].sentence);
    ASSERT_EQ(numbers.size(), 3U) << findings[0].sentence;
    EXPECT_NEAR(numbers[0], truth[k], 0.05);
    EXPECT_LT(numbers[2] - numbers[1], 0.15);
  }
}

// A velocity that comes late is like one of another point, of a vehicle that turns as it gains
// speed; it is not taken for one.
TEST(SensorMount, TakesNoDelayForAnArm) {
  for (const double delay : {0.08, 0.25, -0.4}) {
    for (const Finding& finding : CheckPoseAgainstTwist(SeenFrom({.delay = delay}))) {
      EXPECT_EQ(finding.code, "pose_twist_delay") << delay;
    }
  }
}

TEST(SensorMount, FindsAnAngleToEitherSide) {
  const double degree = M_PI / 180.0;
  auto findings = CheckPoseAgainstTwist(SeenFrom({.angle = 6.0 * degree}));
  ASSERT_THAT(CodesOf(findings), ElementsAre("mounting_angle"));
  EXPECT_EQ(findings[0].severity, Severity::kNote);
  EXPECT_NEAR(NumbersBehind("turned by ", findings[0].sentence)[0], 6.0, 0.5);
  EXPECT_THAT(findings[0].sentence, HasSubstr("to starboard of"));

  findings = CheckPoseAgainstTwist(SeenFrom({.angle = -15.0 * degree}));
  ASSERT_THAT(CodesOf(findings), ElementsAre("mounting_angle"));
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_NEAR(NumbersBehind("turned by ", findings[0].sentence)[0], 15.0, 0.5);
  EXPECT_THAT(findings[0].sentence, HasSubstr("to port of"));
}

TEST(SensorMount, FindsAnArmInTheAxesOfTheVehicleBesideAnAngle) {
  const auto findings =
      CheckPoseAgainstTwist(SeenFrom({.arm = {0.8, 0.0, 0.0}, .angle = 20.0 * M_PI / 180.0}));
  ASSERT_THAT(CodesOf(findings), ElementsAre("mounting_angle", "lever_arm"));
  EXPECT_NEAR(NumbersBehind("turned by ", findings[0].sentence)[0], 20.0, 0.7);
  EXPECT_NEAR(NumbersBehind("x = ", findings[1].sentence)[0], 0.8, 0.06);
}

// v is then another motion than the poses', and the arm says why.
TEST(SensorMount, IsNamedInPlaceOfAMotionThatIsAnother) {
  EXPECT_THAT(CodesOf(CheckPoseAgainstTwist(SeenFrom({.arm = {4.0, 0.0, 0.0}}))),
              ElementsAre("lever_arm"));
}

// One that no arm explains is still told.
TEST(SensorMount, LeavesAColumnThatIsNoMeasurement) {
  Log log = SeenFrom({.arm = {1.0, 0.0, 0.0}});
  for (std::size_t i = 0; i < log.velocity->time.size(); ++i) {
    log.velocity->values[2][i] = 0.1 * std::sin(1.7 * log.velocity->time[i]);
  }
  EXPECT_THAT(CodesOf(CheckPoseAgainstTwist(log)), ElementsAre("pose_twist_apart", "lever_arm"));
}

TEST(SensorMount, SaysNothingOfAnArmWhereRatesHardlyMove) {
  EXPECT_THAT(CodesOf(CheckPoseAgainstTwist(SeenFrom({.arm = {0.6, -0.4, 0.3}, .turns = 0.05}))),
              IsEmpty());
}

// 95 % of 600: a standard deviation of 0.9 %.
TEST(SensorMount, IntervalsHoldTheTruthAsOftenAsTheySay) {
  const Eigen::Vector3d arm(0.6, -0.4, 0.5);
  constexpr int kRuns = 200;
  int held = 0;
  for (int seed = 100; seed < 100 + kRuns; ++seed) {
    const auto mount = SensorMountOf(SeenFrom({.arm = arm}, seed),
                                     {{Dof::kSurge, 0.0}, {Dof::kSway, 0.0}, {Dof::kHeave, 0.0}});
    ASSERT_TRUE(mount) << seed;
    for (int k = 0; k < 3; ++k) {
      held += std::abs(mount->arm[k].value - arm[k]) <= mount->arm[k].half_width ? 1 : 0;
    }
  }
  RecordProperty("held", held);
  EXPECT_GE(held, 3 * kRuns * 92 / 100);
  EXPECT_LE(held, 3 * kRuns * 98 / 100);
}

}  // namespace
}  // namespace fathom
