// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Effects that Synthesize() hides, against closed forms and against EffectSimulation, other code.

#include "fathom/base/input_error.h"
#include "fathom/simulate/effect_simulation.h"
#include "fathom/synthesize/effects/unlisted_effects.h"
#include "fathom/synthesize/synthesize.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;

// Linear: m = 12, d_L = 3, time constant 4 s.
Vehicle LinearVehicle() {
  Vehicle vehicle;
  vehicle.name = "linear";
  vehicle.models[Index(Dof::kSurge)] = {12.0, 0.0, 3.0, 0.0};
  return vehicle;
}

Vehicle ThreeDofVehicle() {
  Vehicle vehicle;
  vehicle.name = "three";
  vehicle.models[Index(Dof::kSurge)] = {85.0, 18.6, 13.9, -0.8};
  vehicle.models[Index(Dof::kSway)] = {95.0, 28.6, 23.9, 0.4};
  vehicle.models[Index(Dof::kYaw)] = {30.0, 28.0, 12.7, 0.1};
  return vehicle;
}

InputSignal Steps(std::vector<double> levels, double hold) {
  return {0.0, StepsInput{.levels = std::move(levels), .hold = hold}};
}

Experiment Run(std::vector<Drive> drives, double duration) {
  Experiment experiment;
  experiment.name = "run";
  experiment.duration = duration;
  experiment.command_rate = 10.0;
  experiment.drives = std::move(drives);
  experiment.velocity.emplace();
  experiment.velocity->sampling.rate = 10.0;
  experiment.velocity->sampling.jitter = 0.01;
  experiment.pose.emplace();
  experiment.pose->sampling.rate = 10.0;
  experiment.pose->sampling.jitter = 0.01;
  return experiment;
}

Experiment SurgeSteps() {
  return Run({{.dof = Dof::kSurge, .input = Steps({6.0, 1.5, -4.5}, 4.0), .pid = {}}}, 12.0);
}

MultisineInput Sines(double rms) {
  MultisineInput sines;
  sines.rms = rms;
  sines.lowest_frequency = 0.1;
  sines.highest_frequency = 1.5;
  sines.num_lines = 9;
  return sines;
}

// Surge, sway and yaw at once.
Experiment ThreeDofs() {
  Experiment experiment = Run({{.dof = Dof::kSurge, .input = {2.0, Sines(20.0)}, .pid = {}},
                               {.dof = Dof::kSway, .input = {1.0, Sines(15.0)}, .pid = {}},
                               {.dof = Dof::kYaw, .input = {0.0, Sines(5.0)}, .pid = {}}},
                              60.0);
  experiment.velocity->sampling.rate = 50.0;
  experiment.velocity->sampling.jitter = 0.001;
  return experiment;
}

ActiveEffect Hidden(const std::string& name,
                    std::vector<double> values,
                    Dof dof = Dof::kSurge,
                    Dof partner = Dof::kSway) {
  const Effect* effect = FindEffect(name);
  if (effect == nullptr) effect = FindUnlistedEffect(name);
  return {effect, {.dof = dof, .partner = partner, .reference_force = 20.0}, std::move(values)};
}

Log LogWith(const std::vector<ActiveEffect>& effects) {
  return Synthesize(LinearVehicle(), SurgeSteps(), effects, 1);
}

// The speed of the linear vehicle after `t` seconds of force a + b exp(-t / T), T not 4 s.
double Speed(double from, double a, double b, double T, double t) {
  const double particular = b / 3.0 / (1.0 - 4.0 / T);  // times exp(-t / T)
  return a / 3.0 + particular * std::exp(-t / T) +
         (from - a / 3.0 - particular) * std::exp(-t / 4.0);
}

// Speeds under forces that are held from the times given on.
double HeldSpeed(const std::vector<double>& from, const std::vector<double>& forces, double t) {
  double v = 0.0;
  for (std::size_t i = 0; i < from.size() && from[i] <= t; ++i) {
    const double end = i + 1 < from.size() ? std::min(from[i + 1], t) : t;
    v = Speed(v, forces[i], 0.0, 1.0, end - from[i]);
  }
  return v;
}

template <typename Expected>
void ExpectSpeeds(const Log& log, double tolerance, const Expected& expected) {
  ASSERT_EQ(log.velocity->time.size(), 120u);
  for (std::size_t i = 0; i < log.velocity->time.size(); ++i) {
    const double t = log.velocity->time[i];
    ASSERT_NEAR(log.velocity->values[0][i], expected(t), tolerance) << t;
  }
}

TEST(HiddenEffects, LagTheThrustersAsTheClosedFormSays) {
  const double T = 0.5;
  const Log log = LogWith({Hidden("thruster_lag", {T})});
  EXPECT_EQ(log.command->values[0][0], 6.0);  // what was commanded is logged
  const double f4 = 6.0 * (1.0 - std::exp(-4.0 / T));
  const double f8 = 1.5 + (f4 - 1.5) * std::exp(-4.0 / T);
  const double v4 = Speed(0.0, 6.0, -6.0, T, 4.0);
  const double v8 = Speed(v4, 1.5, f4 - 1.5, T, 4.0);
  // The force of a step h = 5 ms is its mean: off by h^2 / 12 d_L / m f' / d_L = 2e-6 / 4 * f'/ 3,
  // f' at most 12 N/s.
  ExpectSpeeds(log, 3e-6, [&](double t) {
    return t < 4.0   ? Speed(0.0, 6.0, -6.0, T, t)
           : t < 8.0 ? Speed(v4, 1.5, f4 - 1.5, T, t - 4.0)
                     : Speed(v8, -4.5, f8 + 4.5, T, t - 8.0);
  });
}

TEST(HiddenEffects, SwallowThrustInADeadZone) {
  ExpectSpeeds(LogWith({Hidden("thrust_dead_zone", {2.0})}), 1e-10, [](double t) {
    return HeldSpeed({0.0, 4.0, 8.0}, {4.0, 0.0, -2.5}, t);
  });
}

TEST(HiddenEffects, ClampAfterTheDeadZoneWhateverTheirOrderInTheList) {
  const ActiveEffect dead_zone = Hidden("thrust_dead_zone", {1.0});
  const ActiveEffect saturation = Hidden("thrust_saturation", {3.0});
  for (const auto& effects : {std::vector{dead_zone, saturation}, {saturation, dead_zone}}) {
    ExpectSpeeds(LogWith(effects), 1e-10, [](double t) {
      return HeldSpeed({0.0, 4.0, 8.0}, {3.0, 0.5, -3.0}, t);
    });
  }
}

TEST(HiddenEffects, ShiftTheCommandLaterByAPositiveOffset) {
  ExpectSpeeds(LogWith({Hidden("time_offset", {0.37})}), 1e-10, [](double t) {
    return HeldSpeed({0.37, 4.37, 8.37}, {6.0, 1.5, -4.5}, t);
  });
}

TEST(HiddenEffects, ShiftTheCommandEarlierByANegativeOffset) {
  const Log log = LogWith({Hidden("time_offset", {-0.37})});
  ExpectSpeeds(log, 1e-10, [](double t) {
    return HeldSpeed({0.0, 3.63, 7.63, 11.63}, {6.0, 1.5, -4.5, 6.0}, t);
  });
  // Its clock is ahead: the last stamps lie behind the end, 12 s.
  EXPECT_NEAR(log.command->time.back(), 12.3, 1e-9);
}

TEST(HiddenEffects, StartTheClockOfTimesAtTheFirstCommand) {
  Experiment experiment = SurgeSteps();
  experiment.start_time = 500.0;
  const std::vector<ActiveEffect> effects = {Hidden("thrust_fade", {0.05})};
  const Log late = Synthesize(LinearVehicle(), experiment, effects, 1);
  const Log log = LogWith(effects);
  for (std::size_t i = 0; i < 120; ++i) {
    ASSERT_EQ(late.velocity->values[0][i], log.velocity->values[0][i]);
  }
  // A ramp of force 6 (1 - r t): m dv/dt + d v = F (1 - r t) has the particular solution
  // F / d (1 + r T - r t), T = m / d. The force of a step is that of its middle: exact for ramps
  // but for h^2 / 12, as for the lag.
  for (std::size_t i = 0; i < 40; ++i) {
    const double t = log.velocity->time[i];
    if (t > 4.0) continue;
    const double r = 0.05;
    const double expected =
        2.0 * (1.0 + 4.0 * r - r * t) - 2.0 * (1.0 + 4.0 * r) * std::exp(-t / 4.0);
    ASSERT_NEAR(log.velocity->values[0][i], expected, 1e-7) << t;
  }
}

TEST(HiddenEffects, MakeTheDampingActOnTheSpeedThroughTheWater) {
  // Under linear damping a current c is a constant force d_L c.
  ExpectSpeeds(LogWith({Hidden("steady_current", {0.2})}), 1e-10, [](double t) {
    return HeldSpeed({0.0, 4.0, 8.0}, {6.6, 2.1, -3.9}, t);
  });
}

TEST(HiddenEffects, PullBackLikeASpring) {
  // m x'' + d x' + k x = F: k = 3, so w0 = 1/2, damping rate 1/8.
  const Log log = LogWith({Hidden("position_stiffness", {3.0})});
  const double rate = 0.125, w = std::sqrt(0.25 - rate * rate);
  for (std::size_t i = 0; i < 120 && log.velocity->time[i] < 4.0; ++i) {
    const double t = log.velocity->time[i];
    ASSERT_NEAR(log.velocity->values[0][i],
                6.0 / (12.0 * w) * std::exp(-rate * t) * std::sin(w * t),
                1e-10);
  }
}

TEST(HiddenEffects, RememberTheMotionInTheWake) {
  // m dv/dt + d v + k (v - z) = F, T dz/dt = v - z: a linear system of two, k = 6, T = 2, whose
  // matrix has the eigenvalues -1 and -1/4: s^2 + (9/12 + 1/2) s + 3/24 = 0, so s = -1.1404,
  // -0.1096.
  const Log log = LogWith({Hidden("fluid_memory", {6.0, 2.0})});
  const double root = std::sqrt(1.25 * 1.25 - 0.5);
  const double s1 = 0.5 * (-1.25 + root), s2 = 0.5 * (-1.25 - root);
  // v(0) = 0, v'(0) = F / m = 1/2, v(inf) = 2: v = 2 + a exp(s1 t) + b exp(s2 t).
  const double b = (0.5 + 2.0 * s1) / (s2 - s1), a = -2.0 - b;
  for (std::size_t i = 0; i < 120 && log.velocity->time[i] < 4.0; ++i) {
    const double t = log.velocity->time[i];
    ASSERT_NEAR(
        log.velocity->values[0][i], 2.0 + a * std::exp(s1 * t) + b * std::exp(s2 * t), 1e-10);
  }
}

TEST(HiddenEffects, AddABiasExactlyAndToTheReadingOnly) {
  const Log plain = LogWith({});
  const Log biased = LogWith({Hidden("sensor_bias", {0.0625})});
  for (std::size_t i = 0; i < 120; ++i) {
    ASSERT_EQ(biased.velocity->values[0][i], plain.velocity->values[0][i] + 0.0625);
  }
  EXPECT_EQ(biased.pose->values, plain.pose->values);
}

TEST(HiddenEffects, StampPosesByAnotherClock) {
  const Log plain = LogWith({});
  const Log offset = LogWith({Hidden("sensor_clock_offset", {-0.25})});
  EXPECT_EQ(offset.pose->values, plain.pose->values);
  EXPECT_EQ(offset.velocity->time, plain.velocity->time);
  ASSERT_EQ(offset.pose->time.size(), 120u);
  for (std::size_t i = 0; i < 120; ++i) {
    ASSERT_NEAR(offset.pose->time[i], plain.pose->time[i] - 0.25, 1e-12);
  }
}

TEST(HiddenEffects, ScaleAndMoveWhatThePosesShow) {
  const Log plain = LogWith({});
  const Log shown = LogWith({Hidden("marker_moved", {0.5, 6.0}), Hidden("pose_scale", {0.1})});
  EXPECT_EQ(shown.velocity->values, plain.velocity->values);
  for (std::size_t i = 0; i < 120; ++i) {
    const double t = plain.pose->time[i];
    if (std::abs(t - 6.0) < 0.11) continue;  // while it moves
    const double expected = 1.1 * plain.pose->values[0][i] + (t > 6.0 ? 0.5 : 0.0);
    ASSERT_NEAR(shown.pose->values[0][i], expected, 1e-12);
  }
}

TEST(HiddenEffects, TurnBothAxesOfATurnedSensor) {
  const Log plain = Synthesize(ThreeDofVehicle(), ThreeDofs(), 1);
  const Log turned = Synthesize(
      ThreeDofVehicle(), ThreeDofs(), std::vector{Hidden("sensor_misalignment", {0.3})}, 1);
  for (std::size_t i = 0; i < plain.velocity->time.size(); ++i) {
    const double u = (*plain.velocity->Find("u"))[i], v = (*plain.velocity->Find("v"))[i];
    ASSERT_NEAR((*turned.velocity->Find("u"))[i], u * std::cos(0.3) + v * std::sin(0.3), 1e-14);
    ASSERT_NEAR((*turned.velocity->Find("v"))[i], v * std::cos(0.3) - u * std::sin(0.3), 1e-14);
  }
  EXPECT_EQ(*turned.velocity->Find("r"), *plain.velocity->Find("r"));
}

TEST(HiddenEffects, SmoothWhatTheSensorShows) {
  // A lag T of v = v_end (1 - exp(-t / 4)) from rest: y = v_end (1 - (4 e^{-t/4} - T e^{-t/T}) / (4
  // - T)). Straight lines over 5 ms are off by h^2 / 8 v'' = 3e-6 / 4^2 * 2.
  const double T = 0.7;
  const Log log = LogWith({Hidden("sensor_lag", {T})});
  for (std::size_t i = 0; i < 40; ++i) {
    const double t = log.velocity->time[i];
    if (t > 4.0) continue;
    const double expected =
        2.0 * (1.0 - (4.0 * std::exp(-t / 4.0) - T * std::exp(-t / T)) / (4.0 - T));
    ASSERT_NEAR(log.velocity->values[0][i], expected, 1e-6) << t;
  }
}

TEST(HiddenEffects, PushWithTheCommandOfAnotherDof) {
  Vehicle vehicle = LinearVehicle();
  vehicle.models[Index(Dof::kSway)] = {50.0, 20.0, 5.0, 0.0};
  Experiment experiment = SurgeSteps();
  experiment.drives[0].input = Steps({0.0}, 1.0);
  experiment.drives.push_back(
      {.dof = Dof::kSway, .input = Steps({6.0, 1.5, -4.5}, 4.0), .pid = {}});
  // It is the command that pushes: what the partner's thrusters make of it is another matter.
  const Log log = Synthesize(
      vehicle,
      experiment,
      std::vector{Hidden("thrust_crosstalk", {0.4}), Hidden("thruster_lag", {2.0}, Dof::kSway)},
      1);
  ExpectSpeeds(log, 1e-10, [](double t) {
    return HeldSpeed({0.0, 4.0, 8.0}, {2.4, 0.6, -1.8}, t);
  });
}

TEST(HiddenEffects, ReachAClosedLoopThroughItsMotion) {
  Experiment experiment = SurgeSteps();
  experiment.drives[0].input = Steps({1.0, -1.0}, 6.0);
  experiment.drives[0].pid = PidGains{.kp = 3.0, .ki = 0.1, .kd = 6.0, .limit = 50.0};
  const Log plain = Synthesize(LinearVehicle(), experiment, 1);
  const Log lagged =
      Synthesize(LinearVehicle(), experiment, std::vector{Hidden("thruster_lag", {0.5})}, 1);
  EXPECT_EQ(lagged.command->values[0][0], plain.command->values[0][0]);
  EXPECT_NE(lagged.command->values[0][30], plain.command->values[0][30]);
  // A command clock that is ahead by three periods: until the setpoint changes, the same commands
  // stamped 0.3 s later, and the same motion. (Without ki: its first three calls, before anything
  // moves, would add up.)
  experiment.drives[0].pid->ki = 0.0;
  const Log in_time = Synthesize(LinearVehicle(), experiment, 1);
  const Log ahead =
      Synthesize(LinearVehicle(), experiment, std::vector{Hidden("time_offset", {-0.3})}, 1);
  ASSERT_EQ(ahead.command->time.size(), in_time.command->time.size() + 3);
  for (std::size_t k = 0; k < 50; ++k) {
    ASSERT_NEAR(ahead.command->values[0][k + 3], in_time.command->values[0][k], 1e-9);
    ASSERT_NEAR(ahead.velocity->values[0][k], in_time.velocity->values[0][k], 1e-9);
  }
  const auto late =
      Synthesize(LinearVehicle(), experiment, std::vector{Hidden("time_offset", {0.3})}, 1);
  EXPECT_NE(late.command->values[0][30], plain.command->values[0][30]);
}

// Each effect of the catalogue.
class EveryHiddenEffect : public testing::TestWithParam<const Effect*> {
 protected:
  std::string name() const { return std::string(GetParam()->info().name); }

  Dof partner() const { return name() == "lever_arm" ? Dof::kYaw : Dof::kSway; }

  ActiveEffect At(std::vector<double> values) const {
    return {GetParam(), {Dof::kSurge, partner(), 20.0}, std::move(values)};
  }

  ActiveEffect AtNull() const {
    std::vector<double> values;
    for (const EffectParameter& parameter : GetParam()->info().parameters) {
      values.push_back(std::isnan(parameter.null) ? 30.0 : parameter.null);
    }
    return At(values);
  }

  ActiveEffect AtSomeSize() const {
    std::vector<double> values;
    for (const EffectParameter& parameter : GetParam()->info().parameters) {
      double value =
          0.3 * std::pow(20.0, parameter.quantity.force) * std::pow(0.4, parameter.quantity.speed);
      if (parameter.search == Search::kTimeOfRun) value = 20.3;
      if (parameter.quantity.time < 0.0 && parameter.quantity.force == 0.0) value = 0.01;
      if (parameter.search == Search::kFrequencyOfRun) value = 0.7;
      if (parameter.name == "slope") value = 0.1;
      if (parameter.name == "rate" && parameter.quantity.force > 0.0) value = 20.0;
      if (parameter.name == "stiffness" || parameter.name == "moment") value = 5.0;
      if (parameter.name == "limit") value = 25.0;
      if (parameter.name == "exponent") value = 1.3;
      if (parameter.search == Search::kShape) value = 2.0;
      values.push_back(value);
    }
    return At(values);
  }
};

TEST_P(EveryHiddenEffect, LeavesEveryBitOfTheLogAtItsNull) {
  const Log plain = Synthesize(ThreeDofVehicle(), ThreeDofs(), 1);
  const Log null = Synthesize(ThreeDofVehicle(), ThreeDofs(), std::vector{AtNull()}, 1);
  EXPECT_EQ(null.command->time, plain.command->time);
  EXPECT_EQ(null.command->values, plain.command->values);
  EXPECT_EQ(null.velocity->time, plain.velocity->time);
  EXPECT_EQ(null.pose->time, plain.pose->time);
  if (name() != "thrust_curve") {
    EXPECT_EQ(null.velocity->values, plain.velocity->values);
    EXPECT_EQ(null.pose->values, plain.pose->values);
    return;
  }
  // (|tau| / F0)^1 F0 is tau but for two roundings.
  for (std::size_t i = 0; i < plain.velocity->time.size(); ++i) {
    ASSERT_NEAR(null.velocity->values[0][i], plain.velocity->values[0][i], 1e-13);
  }
}

// What EffectSimulation predicts from the log of commands and, for partners, of their motion.
TEST_P(EveryHiddenEffect, AgreesWithTheSimulationOfIt) {
  Experiment experiment = ThreeDofs();
  experiment.command_rate = 100.0;
  experiment.velocity->sampling.rate = 100.0;
  // Turned while it moves ahead, it does not move along one axis of the world.
  if (GetParam()->info().needs_pose) experiment.drives.resize(1);
  const ActiveEffect hidden = AtSomeSize();
  const Log log = Synthesize(ThreeDofVehicle(), experiment, std::vector{hidden}, 1);
  const Log plain = Synthesize(ThreeDofVehicle(), experiment, 1);

  EffectInputs inputs;
  inputs.command = {log.command->time, log.command->values[0]};
  for (const Drive& drive : experiment.drives) {
    const int i = Index(drive.dof);
    inputs.velocity[i] = {log.velocity->time, *log.velocity->Find(VelocityColumn(drive.dof))};
    inputs.force[i] = {log.command->time, *log.command->Find(ForceColumn(drive.dof))};
  }
  OutputStamps stamps;
  stamps.velocity = log.velocity->time;
  if (GetParam()->info().needs_pose) stamps.displacement = log.pose->time;
  const EffectSimulation simulation(&inputs, stamps);
  EffectOutputs outputs;
  ASSERT_TRUE(simulation.Run(
      {*ThreeDofVehicle().models[0], {hidden}}, {.velocity = 0.0, .position = 0.0}, &outputs));

  double miss = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < stamps.velocity.size(); ++i) {
    const double logged = log.velocity->values[0][i];
    miss = std::max(miss, std::abs(outputs.velocity[i] - logged));
    difference = std::max(difference, std::abs(logged - plain.velocity->values[0][i]));
  }
  for (std::size_t i = 0; i < stamps.displacement.size(); ++i) {
    const double shown = log.pose->values[0][i];
    miss = std::max(miss, std::abs(outputs.displacement[i] - shown));
    difference = std::max(difference, std::abs(shown - plain.pose->values[0][i]));
    difference = std::max(difference, std::abs(log.pose->time[i] - plain.pose->time[i]));
  }
  // The simulation steps from command to command. A thruster's force f is its mean over such a step
  // h: halfway, the speed is off by h^2 / 8 f' / m = 2e-7 f', with f' up to 20 N / 0.3 s: 1e-5. It
  // takes the partner's command of a step's end, the next one, for a sixth of the step: up to 3 N
  // by 2 ms in 85 kg, times some steps that a multisine goes one way.
  EXPECT_GT(difference, 0.01);
  EXPECT_LT(miss, name() == "thrust_crosstalk" ? 4e-4 : 3e-5);
}

INSTANTIATE_TEST_SUITE_P(Catalogue,
                         EveryHiddenEffect,
                         testing::ValuesIn(EffectCatalogue().begin(), EffectCatalogue().end()),
                         [](const auto& info) { return std::string(info.param->info().name); });

TEST(HiddenEffects, RefuseADofThatIsNotDrivenAndAPoseThatIsNotLogged) {
  EXPECT_THAT(
      [] { LogWith({Hidden("thruster_lag", {0.5}, Dof::kHeave)}); },
      testing::ThrowsMessage<InputError>(HasSubstr("does not drive heave, expected it to since "
                                                   "thruster_lag is to be hidden there")));
  Experiment experiment = SurgeSteps();
  experiment.pose.reset();
  EXPECT_THAT(
      [&] { Synthesize(LinearVehicle(), experiment, std::vector{Hidden("pose_scale", {0.1})}, 1); },
      testing::ThrowsMessage<InputError>(HasSubstr("logs no pose, expected one since pose_scale")));
}

}  // namespace
}  // namespace fathom
