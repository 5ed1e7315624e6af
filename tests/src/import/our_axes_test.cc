// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/our_axes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scratch_file.h"
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

constexpr double kHalfTurn = std::numbers::pi;

// Two equal rows.
GatheredStream Twice(const std::vector<std::string>& columns, const std::vector<double>& row) {
  GatheredStream stream;
  stream.columns = columns;
  stream.samples.time = {1.0, 2.0};
  for (const double value : row) stream.samples.values.push_back({value, value});
  return stream;
}

Eigen::Matrix3d RotationOf(const Stream& pose) {
  return Eigen::Quaterniond(
             pose.values[6][0], pose.values[3][0], pose.values[4][0], pose.values[5][0])
      .toRotationMatrix();
}

Stream Poses(const GatheredStream& gathered, Frame frame) {
  std::vector<std::string> remarks;
  return PosesOf("file", gathered, frame, &remarks);
}

// The same physical vehicle, told in three conventions: 2 m north, 1 m east, 3 m down, its nose 30
// degrees east of north and 20 degrees up, rolled 10 degrees to starboard.
class SamePose : public ::testing::Test {
 protected:
  static constexpr double kYaw = kHalfTurn / 6;
  static constexpr double kPitch = kHalfTurn / 9;
  static constexpr double kRoll = kHalfTurn / 18;
  const std::vector<std::string> columns_ = {"x", "y", "z", "roll", "pitch", "yaw"};

  void ExpectTruth(const Stream& pose) {
    EXPECT_NEAR(pose.values[0][0], 2.0, 1e-12);
    EXPECT_NEAR(pose.values[1][0], 1.0, 1e-12);
    EXPECT_NEAR(pose.values[2][0], 3.0, 1e-12);
    const Eigen::Matrix3d rotation = RotationOf(pose);
    // Where the nose and the starboard side point, by plain trigonometry.
    const Eigen::Vector3d nose(
        std::cos(kPitch) * std::cos(kYaw), std::cos(kPitch) * std::sin(kYaw), -std::sin(kPitch));
    EXPECT_NEAR((rotation.col(0) - nose).norm(), 0.0, 1e-12);
    // The starboard side is rolled down: its depth is sin(roll) cos(pitch).
    EXPECT_NEAR(rotation(2, 1), std::sin(kRoll) * std::cos(kPitch), 1e-12);
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
  }
};

TEST_F(SamePose, InNed) {
  ExpectTruth(Poses(Twice(columns_, {2, 1, 3, kRoll, kPitch, kYaw}), Frame::kNed));
}

// In ENU the heading counts from east to the left, and a nose up is a negative pitch about the axis
// to the left.
TEST_F(SamePose, InEnu) {
  ExpectTruth(
      Poses(Twice(columns_, {1, 2, -3, kRoll, -kPitch, kHalfTurn / 2 - kYaw}), Frame::kEnu));
}

TEST_F(SamePose, InNwu) {
  ExpectTruth(Poses(Twice(columns_, {2, -1, -3, kRoll, -kPitch, -kYaw}), Frame::kNwu));
}

TEST_F(SamePose, AsAQuaternion) {
  const Eigen::Quaterniond q = Eigen::AngleAxisd(kYaw, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(kPitch, Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(kRoll, Eigen::Vector3d::UnitX());
  ExpectTruth(
      Poses(Twice({"x", "y", "z", "qx", "qy", "qz", "qw"}, {2, 1, 3, q.x(), q.y(), q.z(), q.w()}),
            Frame::kNed));
}

TEST(OurAxes, TellsWhatAPoseLacks) {
  std::vector<std::string> remarks;
  PosesOf("file", Twice({"x", "y", "yaw"}, {1, 2, 0.5}), Frame::kNed, &remarks);
  EXPECT_THAT(remarks,
              testing::ElementsAre(HasSubstr("no z"), HasSubstr("no roll"), HasSubstr("no pitch")));
}

// A roll of 0.2 rad to starboard, without a position; 3 m of height where z is up.
TEST(OurAxes, TakesAnAttitudeWithoutAPosition) {
  const Stream roll = Poses(Twice({"roll"}, {0.2}), Frame::kNed);
  EXPECT_THAT(roll.columns, testing::ElementsAre("qx", "qy", "qz", "qw"));
  EXPECT_NEAR(roll.values[0][0], std::sin(0.1), 1e-12);
  EXPECT_NEAR(roll.values[3][0], std::cos(0.1), 1e-12);
  const Stream height = Poses(Twice({"z"}, {3.0}), Frame::kNwu);
  EXPECT_THAT(height.columns, testing::ElementsAre("z"));
  EXPECT_EQ(height.values[0][0], -3.0);
  std::vector<std::string> remarks;
  const Stream both =
      PosesOf("file", Twice({"z", "qx", "qy", "qz", "qw"}, {3, 0, 0, 0, 1}), Frame::kNed, &remarks);
  EXPECT_THAT(both.columns, testing::ElementsAre("z", "qx", "qy", "qz", "qw"));
  EXPECT_THAT(remarks, testing::IsEmpty());
}

TEST(OurAxes, RefusesAVelocityOverGroundWithoutAnAttitude) {
  EXPECT_THAT(
      ErrorFrom([] {
        std::vector<std::string> remarks;
        const Stream height = Poses(Twice({"z"}, {3.0}), Frame::kNed);
        BodyVelocitiesOf("file", Twice({"u", "v", "w"}, {1, 0, 0}), Frame::kNed, height, &remarks);
      }),
      HasSubstr("whose attitude turns it into the body"));
}

TEST(OurAxes, RefusesQuaternionsThatAreNone) {
  EXPECT_THAT(
      ErrorFrom([] {
        Poses(Twice({"x", "y", "z", "qx", "qy", "qz", "qw"}, {0, 0, 0, 1, 1, 0, 0}), Frame::kNed);
      }),
      HasSubstr("0 rows with a quaternion of length 1"));
}

TEST(OurAxes, TurnsAVelocityOverGroundIntoTheBody) {
  std::vector<std::string> remarks;
  // The nose to the east: what goes east goes forward, what goes south goes to starboard.
  const Stream pose = Poses(Twice({"x", "y", "yaw"}, {0, 0, kHalfTurn / 2}), Frame::kNed);
  const auto gathered = Twice({"u", "v", "w", "r"}, {-0.3, 0.7, 0.2, 0.1});
  const Stream velocity = BodyVelocitiesOf("file", gathered, Frame::kNed, pose, &remarks);
  EXPECT_NEAR(velocity.values[0][0], 0.7, 1e-12);
  EXPECT_NEAR(velocity.values[1][0], 0.3, 1e-12);
  EXPECT_NEAR(velocity.values[2][0], 0.2, 1e-12);
  EXPECT_EQ(velocity.values[3][0], 0.1);
  // The same motion told in ENU: east, north, up, and rates about an axis up.
  const auto in_enu = Twice({"u", "v", "w", "r"}, {0.7, -0.3, -0.2, -0.1});
  const Stream same = BodyVelocitiesOf("file", in_enu, Frame::kEnu, pose, &remarks);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(same.values[i][0], velocity.values[i][0], 1e-12);
}

TEST(OurAxes, TurnsAVelocityOfABodyWithZUp) {
  std::vector<std::string> remarks;
  const auto gathered = Twice({"u", "v", "w", "p", "q", "r"}, {1, 2, 3, 4, 5, 6});
  const Stream velocity = BodyVelocitiesOf("file", gathered, Frame::kFlu, std::nullopt, &remarks);
  const std::array<double, 6> expected = {1, -2, -3, 4, -5, -6};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(velocity.values[i][0], expected[i]);
}

TEST(OurAxes, NeedsAnAttitudeForAVelocityOverGround) {
  std::vector<std::string> remarks;
  const auto all = Twice({"u", "v", "w"}, {1, 2, 3});
  EXPECT_THAT(
      ErrorFrom([&] { BodyVelocitiesOf("file", all, Frame::kNed, std::nullopt, &remarks); }),
      HasSubstr("expected the map to give the pose too"));
  const auto some = Twice({"u"}, {1});
  EXPECT_THAT(
      ErrorFrom([&] { BodyVelocitiesOf("file", some, Frame::kNed, std::nullopt, &remarks); }),
      HasSubstr("expected all of u, v, w"));
}

TEST(OurAxes, TurnsForces) {
  Stream command = {{0.0}, {"tau_surge", "tau_sway", "tau_heave", "tau_yaw"}, {{1}, {2}, {3}, {4}}};
  TurnCommand(Frame::kFrd, &command);
  EXPECT_EQ(command.values[3][0], 4.0);
  TurnCommand(Frame::kFlu, &command);
  EXPECT_EQ(command.values[0][0], 1.0);
  EXPECT_EQ(command.values[1][0], -2.0);
  EXPECT_EQ(command.values[2][0], -3.0);
  EXPECT_EQ(command.values[3][0], -4.0);
}

}  // namespace
}  // namespace fathom
