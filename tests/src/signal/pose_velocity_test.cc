// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/pose_velocity.h"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

namespace fathom {
namespace {

struct Attitude {
  double yaw, pitch, roll;
};

Eigen::Matrix3d RotationOf(const Attitude& a) {
  return (Eigen::AngleAxisd(a.yaw, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(a.pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(a.roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

// Poses of a motion on irregular stamps; the quaternions' signs are arbitrary, as in files.
Stream StreamOf(const std::function<Eigen::Vector3d(double)>& position,
                const std::function<Attitude(double)>& attitude,
                int n) {
  Stream pose;
  pose.columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  pose.values.resize(7);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> jitter(0.6, 1.4);
  double t = 0.0;
  for (int i = 0; i < n; ++i, t += 0.05 * jitter(generator)) {
    const Eigen::Vector3d p = position(t);
    Eigen::Quaterniond q(RotationOf(attitude(t)));
    if (generator() % 2 == 0) q.coeffs() *= -1.0;
    const double row[7] = {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
    pose.time.push_back(t);
    for (int k = 0; k < 7; ++k) pose.values[k].push_back(row[k]);
  }
  return pose;
}

TEST(PoseVelocity, IsConstantOnAHelixWithATiltedBody) {
  const double radius = 1.4, rate = 0.6, climb = -0.2;
  const Attitude tilt = {0.0, 0.4, -0.3};
  const Poses poses = PosesOf(StreamOf(
      [&](double t) {
        return Eigen::Vector3d(radius * std::cos(rate * t), radius * std::sin(rate * t), climb * t);
      },
      [&](double t) {
        return Attitude{rate * t, tilt.pitch, tilt.roll};
      },
      400));  // 20 s: two turns, through +-pi
  // In the frame that turns with the heading the velocity is (0, radius rate, climb).
  const Eigen::Matrix3d R = RotationOf(tilt);
  const Eigen::Vector3d v = R.transpose() * Eigen::Vector3d(0.0, radius * rate, climb);
  const Eigen::Vector3d omega = R.transpose() * Eigen::Vector3d(0.0, 0.0, rate);
  const auto result = VelocityOf(poses, {.window = 0.5, .order = 3});
  for (size_t i = 0; i < poses.size(); ++i) {
    // The cubic misses (rate h)^4 / 40 of a centred slope (h: half a window), 1e-5; one-sided
    // (rate 2h)^3 / 10, 3e-3.
    const double tolerance = result.is_centred[i] ? 5e-5 : 5e-3;
    EXPECT_LT((result.velocity[i].head<3>() - v).cwiseAbs().maxCoeff(), tolerance) << i;
    EXPECT_LT((result.velocity[i].tail<3>() - omega).cwiseAbs().maxCoeff(), tolerance) << i;
  }
}

// The kinematics of yaw-pitch-roll, written out:
//   p = roll' - yaw' sin(pitch)
//   q = pitch' cos(roll) + yaw' sin(roll) cos(pitch)
//   r = -pitch' sin(roll) + yaw' cos(roll) cos(pitch)
TEST(PoseVelocity, FollowsTheKinematicsOfAllThreeAngles) {
  const auto attitude = [](double t) {
    return Attitude{3.0 + 0.8 * std::sin(0.7 * t),
                    0.5 * std::sin(0.5 * t + 1.0),
                    0.6 * std::sin(0.9 * t + 2.0)};
  };
  const auto position = [](double t) {
    return Eigen::Vector3d(std::sin(0.4 * t), 2.0 * std::cos(0.3 * t), 0.1 * t);
  };
  const Poses poses = PosesOf(StreamOf(position, attitude, 400));
  const auto result = VelocityOf(poses, {.window = 0.5, .order = 3});
  for (size_t i = 0; i < poses.size(); ++i) {
    const double t = poses.time[i];
    const Attitude a = attitude(t);
    const double yaw_rate = 0.56 * std::cos(0.7 * t), pitch_rate = 0.25 * std::cos(0.5 * t + 1.0),
                 roll_rate = 0.54 * std::cos(0.9 * t + 2.0);
    Eigen::Vector<double, 6> expected;
    expected << RotationOf(a).transpose() *
                    Eigen::Vector3d(0.4 * std::cos(0.4 * t), -0.6 * std::sin(0.3 * t), 0.1),
        roll_rate - yaw_rate * std::sin(a.pitch),
        pitch_rate * std::cos(a.roll) + yaw_rate * std::sin(a.roll) * std::cos(a.pitch),
        -pitch_rate * std::sin(a.roll) + yaw_rate * std::cos(a.roll) * std::cos(a.pitch);
    const double tolerance = result.is_centred[i] ? 2e-4 : 1e-2;
    EXPECT_LT((result.velocity[i] - expected).cwiseAbs().maxCoeff(), tolerance) << i;
  }
}

TEST(PoseVelocity, GrowsAlongTheDofWithAPositiveVelocity) {
  // Facing -y in the world, a little askew and with the nose up.
  const Attitude facing = {-M_PI / 2.0 + 0.2, 0.1, 0.0};
  const Eigen::Vector3d velocity(0.3, -2.0, 0.7);
  const Poses poses = PosesOf(StreamOf(
      [&](double t) { return Eigen::Vector3d(t * velocity); }, [&](double) { return facing; }, 10));
  const Eigen::Vector3d body_velocity = RotationOf(facing).transpose() * velocity;
  for (const Dof dof : {Dof::kSurge, Dof::kSway, Dof::kHeave}) {
    const auto displacement = DisplacementAlong(dof, poses);
    for (size_t i = 0; i < poses.size(); ++i) {
      EXPECT_NEAR(displacement[i], body_velocity[Index(dof)] * poses.time[i], 1e-12) << Name(dof);
    }
  }
}

// Where the vehicle is trimmed nose up, the yaw of yaw-pitch-roll runs ahead of the turn about the
// body's own axis, by a tenth at 0.43 rad.
TEST(PoseVelocity, CountsYawAboutTheBodysOwnAxis) {
  const Eigen::Matrix3d trim = RotationOf({0.7, 0.43, 0.0});
  Stream stream = StreamOf(
      [](double) { return Eigen::Vector3d::Zero(); }, [](double) { return Attitude{}; }, 400);
  const auto turn = [](double t) { return 0.5 * std::sin(0.8 * t); };
  for (size_t i = 0; i < stream.time.size(); ++i) {
    const Eigen::Quaterniond q(Eigen::Quaterniond(trim) *
                               Eigen::AngleAxisd(turn(stream.time[i]), Eigen::Vector3d::UnitZ()));
    for (int c = 0; c < 4; ++c) stream.values[static_cast<size_t>(3 + c)][i] = q.coeffs()[c];
  }
  const auto yaw = DisplacementAlong(Dof::kYaw, PosesOf(stream));
  for (size_t i = 0; i < yaw.size(); ++i) {
    EXPECT_NEAR(yaw[i] - yaw[0], turn(stream.time[i]) - turn(stream.time[0]), 1e-9);
  }
}

TEST(PoseVelocity, UnwrapsTheAngleOfADof) {
  const Poses poses = PosesOf(StreamOf([](double) { return Eigen::Vector3d::Zero(); },
                                       [](double t) {
                                         return Attitude{2.0 + 0.5 * t, 0.3, -0.2};
                                       },
                                       400));
  const auto yaw = DisplacementAlong(Dof::kYaw, poses);
  const auto pitch = DisplacementAlong(Dof::kPitch, poses);
  const auto roll = DisplacementAlong(Dof::kRoll, poses);
  for (size_t i = 0; i < poses.size(); ++i) {
    EXPECT_NEAR(yaw[i], 2.0 + 0.5 * poses.time[i], 1e-9);
    EXPECT_NEAR(pitch[i], 0.3, 1e-9);
    EXPECT_NEAR(roll[i], -0.2, 1e-9);
  }
}

TEST(PoseVelocity, CountsFlipsOfASingleSquareAndNothingElse) {
  const auto turning = [](double t) { return Attitude{std::sin(0.8 * t), 0.1, 0.05}; };
  const auto still = [](double) { return Eigen::Vector3d::Zero(); };
  EXPECT_EQ(CountRotationFlips(PosesOf(StreamOf(still, turning, 300))), 0);
  // One pose alone (two steps), then three poses in a row (two steps).
  int i = -1;
  const auto flipping = [&](double t) {
    ++i;
    Attitude a = turning(t);
    if (i == 100 || (200 <= i && i < 203)) a.pitch -= 0.5;
    return a;
  };
  EXPECT_EQ(CountRotationFlips(PosesOf(StreamOf(still, flipping, 300))), 4);
}

}  // namespace
}  // namespace fathom
