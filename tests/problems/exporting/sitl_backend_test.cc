// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// data/examples/ardupilot_sitl.c, driven as ArduPilot's SITL drives it, against our own simulation.

#include "fathom/exporting/c_header.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/vehicle/thruster.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "generic_models.h"
#include "sitl_child.h"
#include "written_out_rate.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kGravity = 9.80665;  // of ArduPilot [m/s^2]
constexpr double kVoltage = 14.8;     // [V]

// Two tables of different kinds, and thrusters along and across.
ExportTarget VehicleWithPulses() {
  ExportTarget target = {"rov", "a test"};
  target.vehicle.emplace();
  target.vehicle->thrust_tables = {
      {"by width",
       "us",
       {12.0, 16.0},
       {1100.0, 1300.0, 1480.0, 1520.0, 1700.0, 1900.0},
       {{-28.0, -40.0}, {-10.0, -14.0}, {0.0, 0.0}, {0.0, 0.0}, {12.0, 18.0}, {36.0, 51.0}}},
      {"by share", "1", {14.0}, {-1.0, 0.1, 1.0}, {{-17.0}, {0.0}, {23.0}}}};
  target.vehicle->thrusters = {{"port", {-0.4, -0.45, 0.1}, {1.0, 0.0, 0.0}, 0, 0, "by width"},
                               {"starboard", {-0.4, 0.4, 0.1}, {0.8, 0.6, 0.0}, 0, 0, "by width"},
                               {"front", {0.3, 0.05, 0.0}, {0.0, 0.0, 1.0}, 0, 0, "by share"},
                               {"rear", {-0.3, 0.0, 0.0}, {0.0, 0.28, 0.96}, 0, 0, "by share"}};
  return target;
}

// What the pulse of a thruster gives, by the tables themselves.
double ThrustOf(const ExportTarget& target, std::size_t k, double pulse) {
  const bool by_width = k < 2;
  if (pulse == 0.0) return 0.0;
  const double command = by_width ? pulse : (pulse - 1500.0) / 400.0;
  return target.vehicle->thrust_tables[by_width ? 0 : 1].Thrust(command, kVoltage);
}

// Frames whose first four pulses change each time, beyond the tables' ends and off among them.
std::vector<SitlFrame> DrawnFrames(int num, int num_channels) {
  std::mt19937 random(7);
  std::vector<SitlFrame> frames;
  for (int k = 0; k < num; ++k) {
    SitlFrame frame;
    frame.count = static_cast<std::uint32_t>(k);
    frame.pulses.resize(static_cast<std::size_t>(num_channels));
    for (auto& pulse : frame.pulses) pulse = static_cast<std::uint16_t>(1050 + random() % 900);
    if (k % 10 == 3) frame.pulses[1] = 0;
    frames.push_back(frame);
  }
  return frames;
}

// Our own run over the frames, a step each: channel_of[k] drives thruster k.
std::vector<CoupledState> OwnRun(const CoupledModel& model,
                                 const ExportTarget& target,
                                 const std::vector<SitlFrame>& frames,
                                 const std::vector<std::size_t>& channel_of,
                                 std::vector<Vector6>* tau) {
  const double h = 1.0 / frames.front().rate;
  const auto allocation = AllocationMatrix(target.vehicle->thrusters);
  CoupledInputs inputs;
  CoupledStamps stamps;
  for (std::size_t k = 0; k < target.vehicle->thrusters.size(); ++k) {
    inputs.command.thrusters.push_back(
        {target.vehicle->thrusters[k].name, allocation.col(static_cast<Eigen::Index>(k))});
  }
  for (std::size_t i = 0; i < frames.size(); ++i) {
    inputs.command.time.push_back(h * static_cast<double>(i));
    stamps.pose.push_back(h * static_cast<double>(i + 1));
    tau->push_back(Vector6::Zero());
    for (std::size_t k = 0; k < channel_of.size(); ++k) {
      CommandedThruster& thruster = inputs.command.thrusters[k];
      const double thrust = ThrustOf(target, k, frames[i].pulses[channel_of[k] - 1]);
      thruster.thrust.push_back(thrust);
      const auto gain = model.thrust_gain.find(thruster.name);
      tau->back() +=
          thruster.push * thrust * (gain == model.thrust_gain.end() ? 1.0 : gain->second);
    }
  }
  CoupledOutputs outputs;
  EXPECT_TRUE(RunCoupled(model, inputs, {}, stamps, &outputs));
  return outputs.pose;
}

// What SITL is to be told of a state.
void ExpectTold(const SitlAnswer& answer,
                const CoupledModel& model,
                const CoupledState& state,
                const Vector6& tau) {
  const Eigen::Quaterniond q(state.attitude);
  const Eigen::Matrix3d world_from_body = q.toRotationMatrix();
  const Eigen::Vector3d v = state.nu.head<3>(), omega = state.nu.tail<3>();
  const Eigen::Vector3d accel = WrittenOutRate(model, {state.nu, q, tau}).head<3>() +
                                omega.cross(v) -
                                world_from_body.transpose() * Eigen::Vector3d(0.0, 0.0, kGravity);
  // R = R_z(yaw) R_y(pitch) R_x(roll).
  const Eigen::Matrix3d told = (Eigen::AngleAxisd(answer.attitude[2], Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(answer.attitude[1], Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(answer.attitude[0], Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  const Eigen::Quaterniond told_q(
      answer.quaternion[0], answer.quaternion[1], answer.quaternion[2], answer.quaternion[3]);
  // Twelve digits are told.
  EXPECT_LT((answer.gyro - omega).norm(), 1e-9);
  EXPECT_LT((answer.accel_body - accel).norm(), 1e-9);
  EXPECT_LT((answer.position - state.position).norm(), 1e-9);
  EXPECT_LT((answer.velocity - world_from_body * v).norm(), 1e-9);
  EXPECT_LT((told - world_from_body).norm(), 1e-9);
  EXPECT_LT((told_q.toRotationMatrix() - world_from_body).norm(), 1e-9);
}

// Surge and yaw without offset: nothing moves them at rest.
ExportModel Still() {
  FittedModel surge = GenericOneDof(Dof::kSurge), yaw = GenericOneDof(Dof::kYaw);
  surge.model.buoyancy = yaw.model.buoyancy = 0.0;
  return ExportModelOf({surge, yaw}, {"surge.json", "yaw.json"});
}

std::string StillHeader() { return CHeader(Still(), VehicleWithPulses()).text; }

TEST(SitlBackend, MovesAsOurOwnSimulationInSixDofs) {
  const FittedCoupledModel fitted = GenericRov();
  const ExportTarget target = VehicleWithPulses();
  const SitlChild child(
      "rov", CHeader(ExportModelOf(fitted, "rov.json"), target).text, "--voltage=14.8");
  const std::vector<SitlFrame> frames = DrawnFrames(300, 16);
  std::vector<Vector6> tau;
  const std::vector<CoupledState> truth = OwnRun(fitted.model, target, frames, {1, 2, 3, 4}, &tau);
  ASSERT_EQ(truth.size(), frames.size());
  for (std::size_t i = 0; i < frames.size() && !HasFailure(); ++i) {
    const SitlAnswer answer = child.AnswerTo(frames[i]);
    EXPECT_NEAR(answer.timestamp, 0.02 * static_cast<double>(i + 1), 1e-9);
    ExpectTold(answer, fitted.model, truth[i], tau[i]);
  }
}

// Channels above 16, another order and a reversed motor: 3000 us less the pulse.
TEST(SitlBackend, TakesThirtyTwoChannelsInAnyOrder) {
  const FittedCoupledModel fitted = GenericBoat();
  const ExportTarget target = VehicleWithPulses();
  const SitlChild child("rov",
                        CHeader(ExportModelOf(fitted, "boat.json"), target).text,
                        "--voltage=14.8 --channels=20,-2,32,1");
  const std::vector<SitlFrame> frames = DrawnFrames(50, 32);
  std::vector<SitlFrame> turned = frames;
  for (SitlFrame& frame : turned) {
    auto& pulse = frame.pulses[1];
    if (pulse != 0) pulse = static_cast<std::uint16_t>(3000 - pulse);
  }
  std::vector<Vector6> tau;
  const std::vector<CoupledState> truth =
      OwnRun(fitted.model, target, turned, {20, 2, 32, 1}, &tau);
  ASSERT_EQ(truth.size(), frames.size());
  for (std::size_t i = 0; i < frames.size() && !HasFailure(); ++i) {
    ExpectTold(child.AnswerTo(frames[i]), fitted.model, truth[i], tau[i]);
  }
}

TEST(SitlBackend, SaysOnceWhichThrustersHaveNoChannel) {
  SitlChild child("rov", StillHeader(), "--channels=17,2,3,4");
  SitlFrame frame;
  frame.pulses = std::vector<std::uint16_t>(16, 0);
  for (; frame.count < 2; ++frame.count) {
    EXPECT_EQ(child.AnswerTo(frame).velocity, Eigen::Vector3d::Zero());
  }
  EXPECT_EQ(child.End(),
            "ardupilot_sitl: thruster 1 is off: its channel 17 is not in packets of 16. "
            "SERVO_32_ENABLE = 1 gives 32.\n");
}

// A frame of a tenth of a second is five steps, and the lag follows through all of them.
TEST(SitlBackend, ActsThroughTheLagOfTheThrusters) {
  ExportModel model = Still();
  model.effects.push_back(
      {"thruster_lag", "thruster_lag", Dof::kSurge, {{"time_constant", 0.3, 0.01, "s"}}, "pool"});
  SitlFrame frame;
  frame.rate = 10;
  frame.pulses[2] = frame.pulses[3] = 0;
  frame.pulses[0] = 1700;
  const SitlChild child("rov", CHeader(model, VehicleWithPulses()).text, "--voltage=16");
  const double linear = model.model.linear_damping(0, 0);
  const double quadratic = model.model.quadratic_damping(0, 0);
  double force = 0.0, speed = 0.0, rate = 0.0;
  for (; frame.count < 20; ++frame.count) {
    const SitlAnswer answer = child.AnswerTo(frame);
    for (int i = 0; i < 5; ++i) {
      const double h = 0.02, kept = std::exp(-h / 0.3);
      const double mean = 18.0 + (force - 18.0) * (1.0 - kept) * 0.3 / h;
      force = 18.0 + (force - 18.0) * kept;
      const auto at = [&](double u) {
        return (mean - (linear + quadratic * std::abs(u)) * u) / model.model.inertia(0, 0);
      };
      const double k1 = at(speed), k2 = at(speed + 0.5 * h * k1), k3 = at(speed + 0.5 * h * k2),
                   k4 = at(speed + h * k3);
      speed += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
      rate = at(speed);
    }
    EXPECT_NEAR(answer.velocity.head<2>().norm(), speed, 1e-9);
    EXPECT_NEAR(answer.accel_body[0], rate, 1e-9);
  }
}

TEST(SitlBackend, ShowsGravityUpwardsAtRest) {
  const SitlChild child("rov", StillHeader());
  SitlFrame frame;
  frame.rate = 400;
  frame.pulses[2] = frame.pulses[3] = 0;
  for (; frame.count < 3; ++frame.count) {
    const SitlAnswer answer = child.AnswerTo(frame);
    EXPECT_NEAR(answer.timestamp, 0.0025 * (frame.count + 1), 1e-12);
    EXPECT_EQ(answer.accel_body, Eigen::Vector3d(0.0, 0.0, -kGravity));
    EXPECT_EQ(answer.gyro, Eigen::Vector3d::Zero());
    EXPECT_EQ(answer.position, Eigen::Vector3d::Zero());
    EXPECT_EQ(answer.velocity, Eigen::Vector3d::Zero());
    EXPECT_EQ(answer.attitude, Eigen::Vector3d::Zero());
    EXPECT_EQ(answer.quaternion, Eigen::Vector4d(1.0, 0.0, 0.0, 0.0));
  }
}

TEST(SitlBackend, IgnoresBadPacketsAndSaysWhy) {
  SitlChild child("rov", StillHeader());
  SitlFrame frame;
  child.Send(BytesOf(frame, 4711));
  child.Send(BytesOf(frame).substr(0, 39));
  child.Send(BytesOf(frame) + "x");
  child.Send("");
  child.Send("\x1a");
  SitlFrame no_rate;
  no_rate.rate = 0;
  child.Send(BytesOf(no_rate));
  EXPECT_FALSE(child.Receive(0.2).has_value());
  EXPECT_NEAR(child.AnswerTo(frame).timestamp, 0.02, 1e-12);
  const std::string err = child.End();
  EXPECT_THAT(err, HasSubstr("ignored a packet of 40 bytes with magic 4711, expected 18458"));
  EXPECT_THAT(err, HasSubstr("ignored a packet of 39 bytes, expected 40 with magic 18458.\n"));
  EXPECT_THAT(err, HasSubstr("ignored a packet of 41 bytes, expected 40 with magic 18458.\n"));
  EXPECT_THAT(err, HasSubstr("ignored a packet of 0 bytes with magic 0, expected 18458"));
  EXPECT_THAT(err, HasSubstr("ignored a packet of 1 bytes with magic 0, expected 18458"));
  EXPECT_THAT(err, HasSubstr("ignored a packet with a frame rate of 0 Hz.\n"));
}

TEST(SitlBackend, KnowsFramesThatComeAgainAreMissingOrBeginAnew) {
  SitlChild child("rov", StillHeader());
  SitlFrame frame;
  frame.pulses[0] = 1900;
  const SitlAnswer first = child.AnswerTo(frame);
  frame.count = 1;
  const SitlAnswer second = child.AnswerTo(frame);
  EXPECT_GT(second.position.x(), first.position.x());

  // At once: it waited in the queue. After a while: the answer was lost.
  child.Send(BytesOf(frame));
  EXPECT_FALSE(child.Receive(0.6).has_value());
  EXPECT_EQ(child.AnswerTo(frame).text, second.text);

  frame.count = 5;
  EXPECT_NEAR(child.AnswerTo(frame).timestamp, 0.06, 1e-12);
  frame.count = 0;
  EXPECT_EQ(child.AnswerTo(frame).text, first.text);
  // A second without a packet.
  EXPECT_FALSE(child.Receive(1.3).has_value());
  frame.count = 1;
  EXPECT_EQ(child.AnswerTo(frame).text, second.text);

  const std::string err = child.End();
  EXPECT_THAT(err, HasSubstr("frame 5 after 1: those between are missing, and not simulated.\n"));
  EXPECT_THAT(err, HasSubstr("frame 0 after 5: SITL was started again, the vehicle is reset.\n"));
  EXPECT_THAT(err, HasSubstr("no packet for 1 s. The vehicle stands still until one comes.\n"));
  EXPECT_THAT(err, Not(HasSubstr("ignored")));
}

// Without a vehicle file, a header of one's own says what the thrusters do.
TEST(SitlBackend, TakesTheThrustersOfAHeaderOfOnesOwn) {
  const SitlChild child(
      "rov",
      CHeader(Still(), {"rov", "a test"}).text +
          "enum { rov_num_thrusters = 1 };\n"
          "static inline double rov_thrust_of_pulse(int thruster, double pulse, double voltage) {\n"
          "  return (thruster + 1) * voltage * (pulse - 1500) / 400;\n"
          "}\n"
          "static inline void rov_forces(const double thrust[1], double tau[6]) {\n"
          "  int i;\n"
          "  for (i = 0; i < 6; ++i) tau[i] = i == 0 ? thrust[0] : 0;\n"
          "}\n",
      "--voltage=10");
  SitlFrame frame;
  frame.pulses[0] = 1700;
  const ExportModel model = Still();
  const SitlAnswer answer = child.AnswerTo(frame);
  const double u = answer.velocity.x();
  EXPECT_GT(u, 0.0);
  // 5 N less the damping at u.
  EXPECT_NEAR(
      answer.accel_body[0],
      (5.0 - model.model.linear_damping(0, 0) * u - model.model.quadratic_damping(0, 0) * u * u) /
          model.model.inertia(0, 0),
      1e-9);
}

}  // namespace
}  // namespace fathom
