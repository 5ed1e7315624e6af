// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/synthesize.h"

#include "fathom/base/input_error.h"
#include "fathom/simulate/simulate.h"
#include "fathom/synthesize/experiment/experiment_file.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;

Vehicle ProbeVehicle() {
  Vehicle vehicle;
  vehicle.name = "probe";
  vehicle.models[Index(Dof::kSurge)] = {85.0, 8.6, 3.9, -0.8};
  vehicle.models[Index(Dof::kYaw)] = {30.0, 28.0, 2.7, 0.1};
  return vehicle;
}

VelocitySensor PerfectVelocity(double rate) {
  VelocitySensor sensor;
  sensor.sampling.rate = rate;
  return sensor;
}

// Surge in open loop, measured without any error.
Experiment SurgeRun(double duration, const InputSignal& input) {
  Experiment experiment;
  experiment.name = "run";
  experiment.duration = duration;
  experiment.command_rate = 10.0;
  experiment.drives = {{.dof = Dof::kSurge, .input = input, .pid = {}}};
  experiment.velocity = PerfectVelocity(10.0);
  return experiment;
}

InputSignal SinesOfRms(double rms) {
  MultisineInput sines;
  sines.rms = rms;
  sines.lowest_frequency = 0.1;
  sines.highest_frequency = 1.5;
  sines.num_lines = 9;
  return {0.0, sines};
}

Experiment BundledExperiment(const std::string& name) {
  return ReadExperimentFile(std::string(FATHOM_DATA_DIR) + "/experiments/" + name + ".yaml");
}

Vehicle Flatfish() {
  return ReadVehicleFile(std::string(FATHOM_DATA_DIR) + "/vehicles/flatfish.yaml");
}

TEST(Synthesize, FollowsTheClosedFormOfStepsUnderLinearDamping) {
  Vehicle vehicle = ProbeVehicle();
  vehicle.models[0] = {12.0, 0.0, 3.0, -1.5};
  Experiment experiment = SurgeRun(12.0, {0.0, StepsInput{.levels = {2.4, 0.6}, .hold = 4.0}});
  experiment.drives[0].initial_speed = 0.7;
  experiment.start_time = 500.0;
  experiment.velocity->sampling.jitter = 0.02;
  const Log log = Synthesize(vehicle, experiment, 3);
  ASSERT_EQ(log.velocity->time.size(), 120u);

  // v(t + s) = v_end + (v(t) - v_end) exp(-s / 4), v_end = (tau + 1.5) / 3: 1.3, 0.7, 1.3.
  const auto decayed = [](double from, double v_end, double s) {
    return v_end + (from - v_end) * std::exp(-s / 4.0);
  };
  const double v4 = decayed(0.7, 1.3, 4.0);
  const double v8 = decayed(v4, 0.7, 4.0);
  for (std::size_t i = 0; i < 120; ++i) {
    const double t = log.velocity->time[i] - 500.0;
    const double expected = t < 4.0   ? decayed(0.7, 1.3, t)
                            : t < 8.0 ? decayed(v4, 0.7, t - 4.0)
                                      : decayed(v8, 1.3, t - 8.0);
    // The stamps of this log are exact to their last place, 1e-13 s.
    EXPECT_NEAR(log.velocity->values[0][i], expected, 1e-10) << t;
  }
}

TEST(Synthesize, AgreesWithTheSimulationWhichIsOtherCode) {
  Experiment experiment = SurgeRun(120.0, SinesOfRms(20.0));
  experiment.velocity->sampling.jitter = 0.03;
  const Log log = Synthesize(ProbeVehicle(), experiment, 5);
  const auto& time = log.velocity->time;
  const Simulation simulation(HeldCommand{log.command->time, log.command->values[0]}, time);
  std::vector<double> velocity(time.size());
  ASSERT_TRUE(simulation.Run(*ProbeVehicle().models[0],
                             {.velocity = log.velocity->values[0][0], .position = 0.0},
                             velocity,
                             {}));
  // Both are of fourth order but where v|v| has its kink: a step h with acceleration a leaves less
  // than d_Q / m a^2 h^3 = 0.1 * 0.5^2 * 0.1^3 = 3e-5 / 12 there; some ten sign changes.
  double largest = 0.0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    EXPECT_NEAR(log.velocity->values[0][i], velocity[i], 1e-5);
    largest = std::max(largest, std::abs(velocity[i]));
  }
  EXPECT_GT(largest, 0.3);
}

TEST(Synthesize, GivesTheSameLogForTheSameSeedOnly) {
  const Experiment experiment = BundledExperiment("multisine");
  const Log a = Synthesize(Flatfish(), experiment, 1);
  const Log b = Synthesize(Flatfish(), experiment, 1);
  const Log c = Synthesize(Flatfish(), experiment, 2);
  EXPECT_EQ(a.velocity->time, b.velocity->time);
  EXPECT_EQ(a.velocity->values, b.velocity->values);
  EXPECT_EQ(a.command->values, b.command->values);
  EXPECT_EQ(a.pose->values, b.pose->values);
  EXPECT_NE(a.velocity->values, c.velocity->values);
  EXPECT_NE(a.command->values, c.command->values);  // its phases
}

TEST(Synthesize, ChangesNothingElseWhenOneThingChanges) {
  Experiment experiment = SurgeRun(30.0, SinesOfRms(20.0));
  experiment.velocity->sampling.jitter = 0.01;
  experiment.velocity->noise[0] = 0.01;
  const Log log = Synthesize(ProbeVehicle(), experiment, 1);

  Experiment with_pose = experiment;
  with_pose.pose = PoseSensor{};
  with_pose.pose->position_noise = 0.1;
  EXPECT_EQ(Synthesize(ProbeVehicle(), with_pose, 1).velocity->values, log.velocity->values);

  Experiment with_yaw = experiment;
  with_yaw.drives.push_back(
      {.dof = Dof::kYaw, .input = {0.0, PrbsInput{.amplitude = 2.0, .hold = 1.0}}, .pid = {}});
  with_yaw.velocity->noise[5] = 0.01;
  const Log turning = Synthesize(ProbeVehicle(), with_yaw, 1);
  EXPECT_EQ(turning.velocity->time, log.velocity->time);
  // The step divides by the damping of all DOFs alike, so not to the bit.
  for (std::size_t i = 0; i < log.velocity->time.size(); ++i) {
    EXPECT_NEAR(turning.velocity->values[0][i], log.velocity->values[0][i], 1e-9);
  }
  EXPECT_EQ(turning.command->values[0], log.command->values[0]);
}

TEST(Synthesize, AddsNoiseOfTheGivenSpreadAndCorrelation) {
  Experiment experiment = SurgeRun(2000.0, SinesOfRms(20.0));
  const Log truth = Synthesize(ProbeVehicle(), experiment, 1);
  experiment.velocity->noise[0] = 0.03;
  experiment.velocity->noise_correlation = 0.6;
  const Log noisy = Synthesize(ProbeVehicle(), experiment, 1);
  const std::size_t n = truth.velocity->time.size();
  ASSERT_EQ(noisy.velocity->time, truth.velocity->time);
  double sum2 = 0.0, product = 0.0, last = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double e = (noisy.velocity->values[0][i] - truth.velocity->values[0][i]) / 0.03;
    sum2 += e * e;
    product += e * last;
    last = e;
  }
  // Bartlett: at most 2 (1 + a^2) / (1 - a^2) = 4.3 times the variance 1/N of white products.
  const double five_sigma = 5.0 * std::sqrt(4.3 / n);
  EXPECT_NEAR(sum2 / n, 1.0, five_sigma);
  EXPECT_NEAR(product / n, 0.6, five_sigma);
}

TEST(Synthesize, AddsOutliersAsOftenAndAsLargeAsTold) {
  Experiment experiment = SurgeRun(2000.0, SinesOfRms(20.0));
  experiment.velocity->noise[0] = 0.01;
  experiment.pose = PoseSensor{};
  const Log clean = Synthesize(ProbeVehicle(), experiment, 1);
  experiment.velocity->outlier_probability = 0.05;
  experiment.velocity->outlier_size[0] = 0.5;
  experiment.pose->outlier_probability = 0.05;
  experiment.pose->outlier_position = 0.3;
  const Log log = Synthesize(ProbeVehicle(), experiment, 1);
  const auto expect_outliers = [](const auto& values, const auto& clean_values, double size) {
    const double n = static_cast<double>(values.size());
    double num_outliers = 0.0, sum2 = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double e = values[i] - clean_values[i];
      num_outliers += e != 0.0 ? 1.0 : 0.0;
      sum2 += e * e;
    }
    EXPECT_NEAR(num_outliers / n, 0.05, 5.0 * std::sqrt(0.05 * 0.95 / n));
    EXPECT_NEAR(sum2 / num_outliers / (size * size), 1.0, 5.0 * std::sqrt(2.0 / num_outliers));
  };
  expect_outliers(log.velocity->values[0], clean.velocity->values[0], 0.5);
  expect_outliers(log.pose->values[0], clean.pose->values[0], 0.3);
  expect_outliers(log.pose->values[2], clean.pose->values[2], 0.3);
  EXPECT_EQ(log.pose->values[6], clean.pose->values[6]);
  EXPECT_EQ(log.velocity->time, clean.velocity->time);
}

TEST(Synthesize, MovesNothingElseWithTurbulence) {
  Experiment experiment = SurgeRun(60.0, SinesOfRms(20.0));
  experiment.velocity->noise[0] = 0.01;
  const Log still = Synthesize(ProbeVehicle(), experiment, 1);
  experiment.drives[0].turbulence = {.force = 3.0, .correlation_time = 2.0};
  const Log rough = Synthesize(ProbeVehicle(), experiment, 1);
  EXPECT_EQ(rough.command->values, still.command->values);
  EXPECT_EQ(rough.velocity->time, still.velocity->time);
  EXPECT_NE(rough.velocity->values, still.velocity->values);
  EXPECT_EQ(rough.velocity->values[0][0], still.velocity->values[0][0]);
}

TEST(Synthesize, LosesOnlyWholeSamplesInDropOuts) {
  Experiment experiment = SurgeRun(300.0, SinesOfRms(20.0));
  experiment.velocity->noise[0] = 0.03;
  experiment.velocity->noise_correlation = 0.6;
  const Log whole = Synthesize(ProbeVehicle(), experiment, 1);
  experiment.velocity->sampling.drop_outs = {.probability = 0.01, .shortest = 1.0, .longest = 2.0};
  const Log broken = Synthesize(ProbeVehicle(), experiment, 1);
  EXPECT_LT(broken.velocity->time.size(), whole.velocity->time.size());
  ASSERT_THAT(broken.remarks, testing::SizeIs(1));
  EXPECT_THAT(broken.remarks[0].text, HasSubstr("of 3000 samples"));
  std::size_t i = 0;
  for (std::size_t j = 0; j < broken.velocity->time.size(); ++j) {
    while (whole.velocity->time[i] < broken.velocity->time[j]) ++i;
    ASSERT_EQ(whole.velocity->time[i], broken.velocity->time[j]);
    ASSERT_EQ(whole.velocity->values[0][i], broken.velocity->values[0][j]);
  }
}

TEST(Synthesize, RoundsCommandsBeforeTheyActAndVelocitiesAfter) {
  Experiment experiment = SurgeRun(30.0, SinesOfRms(20.0));
  experiment.command_resolution = 5.0;
  experiment.velocity->resolution = 0.01;
  const Log log = Synthesize(ProbeVehicle(), experiment, 1);
  for (const double force : log.command->values[0]) EXPECT_EQ(std::remainder(force, 5.0), 0.0);
  const Simulation simulation(HeldCommand{log.command->time, log.command->values[0]},
                              log.velocity->time);
  std::vector<double> velocity(log.velocity->time.size());
  ASSERT_TRUE(simulation.Run(*ProbeVehicle().models[0], {}, velocity, {}));
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    const double logged = log.velocity->values[0][i];
    EXPECT_NEAR(logged * 100.0, std::round(logged * 100.0), 1e-12);
    EXPECT_NEAR(logged, velocity[i], 0.005 + 1e-5);  // the integrators differ by less than 1e-5
  }
}

TEST(Synthesize, LogsAPoseThatIsTheIntegralOfTheVelocity) {
  Experiment experiment = SurgeRun(60.0, {0.0, SineInput{.amplitude = 20.0, .frequency = 0.5}});
  experiment.pose = PoseSensor{};
  const Log log = Synthesize(ProbeVehicle(), experiment, 1);
  ASSERT_EQ(log.pose->time, log.velocity->time);
  double x = 0.0;
  for (std::size_t i = 1; i < log.pose->time.size(); ++i) {
    x += 0.05 * (log.velocity->values[0][i] + log.velocity->values[0][i - 1]);
    // The trapezoidal rule over T seconds is off by at most T h^2 / 12 max|d2v/dt2|, and the
    // acceleration changes by less than 0.5 m/s^3: 60 * 0.01 / 12 * 0.5; jumps of a held force
    // are within that bound.
    ASSERT_NEAR(log.pose->values[0][i], x, 0.025) << i;
    ASSERT_EQ(log.pose->values[1][i], 0.0);
    ASSERT_EQ(log.pose->values[6][i], 1.0);
  }
}

TEST(Synthesize, SpreadsThePoseAsTold) {
  Experiment experiment = SurgeRun(1000.0, SinesOfRms(20.0));
  experiment.pose = PoseSensor{};
  const Log truth = Synthesize(ProbeVehicle(), experiment, 1);
  experiment.pose->position_noise = 0.02;
  experiment.pose->angle_noise = 0.01;
  const Log noisy = Synthesize(ProbeVehicle(), experiment, 1);
  const std::size_t n = truth.pose->time.size();
  for (int column = 0; column < 6; ++column) {
    double sum2 = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double e = noisy.pose->values[column][i] - truth.pose->values[column][i];
      sum2 += e * e;
    }
    // A small turn by a about an axis is a / 2 in that axis' entry of the quaternion.
    const double sigma = column < 3 ? 0.02 : 0.005;
    EXPECT_NEAR(sum2 / n / (sigma * sigma), 1.0, 5.0 * std::sqrt(2.0 / n) + 1e-4) << column;
  }
}

// Amplitude of a sine of frequency w in `values`, by least squares over whole periods.
double AmplitudeAt(double w, const std::vector<double>& time, const std::vector<double>& values) {
  double c = 0.0, s = 0.0;
  int num_samples = 0;
  const double from = time.back() - 2.0 * M_PI / w * std::floor(0.6 * time.back() * w / 2.0 / M_PI);
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] < from) continue;
    c += values[i] * std::cos(w * time[i]);
    s += values[i] * std::sin(w * time[i]);
    ++num_samples;
  }
  return 2.0 * std::hypot(c, s) / num_samples;
}

TEST(Synthesize, FollowsTableIInClosedLoop) {
  Experiment experiment = BundledExperiment("table1");
  experiment.velocity->sampling.drop_outs = {};
  const Log log = Synthesize(Flatfish(), experiment, 1);
  EXPECT_FALSE(log.pose);
  EXPECT_THAT(log.dofs, testing::ElementsAre(Dof::kSurge, Dof::kHeave, Dof::kYaw));
  // 1 m and 0.3 rad at 0.3 rad/s are speeds of 0.3 m/s and 0.09 rad/s.
  const auto& velocity = *log.velocity;
  EXPECT_NEAR(AmplitudeAt(0.3, velocity.time, *velocity.Find("w")) / 0.3, 1.0, 0.2);
  EXPECT_NEAR(AmplitudeAt(0.3, velocity.time, *velocity.Find("r")) / 0.09, 1.0, 0.2);
  EXPECT_NEAR(AmplitudeAt(0.3, log.command->time, *log.command->Find("tau_surge")), 52.9, 0.1);
  // Stable: after the start nothing is near the limits, 800 N and 150 N m.
  for (std::size_t i = 100; i < log.command->time.size(); ++i) {
    ASSERT_LT(std::abs((*log.command->Find("tau_heave"))[i]), 600.0);
    ASSERT_LT(std::abs((*log.command->Find("tau_yaw"))[i]), 100.0);
  }
}

TEST(Synthesize, PassesOnWhatTheLogSaysAboutItself) {
  Experiment experiment = SurgeRun(10.0, SinesOfRms(20.0));
  experiment.notes = "still water";
  experiment.held_out = {{6.0, 8.0}};
  const Log log = Synthesize(ProbeVehicle(), experiment, 1);
  EXPECT_EQ(log.name, "run");
  EXPECT_EQ(log.notes, "still water");
  EXPECT_EQ(log.vehicle, "probe");
  ASSERT_EQ(log.held_out.size(), 1u);
  EXPECT_EQ(log.held_out[0].from, 6.0);
  EXPECT_EQ(log.held_out[0].to, 8.0);
  EXPECT_THAT(log.command->columns, testing::ElementsAre("tau_surge"));
  EXPECT_THAT(log.velocity->columns, testing::ElementsAre("u"));
}

TEST(Synthesize, RefusesADofWithoutAModel) {
  Experiment experiment = SurgeRun(10.0, SinesOfRms(20.0));
  experiment.drives[0].dof = Dof::kSway;
  EXPECT_THAT([&] { Synthesize(ProbeVehicle(), experiment, 1); },
              testing::ThrowsMessage<InputError>(HasSubstr("'probe': has no model of sway")));
}

TEST(Synthesize, RefusesAControlledAxisThatAnotherDofTurns) {
  Experiment experiment = SurgeRun(10.0, SinesOfRms(1.0));
  experiment.drives[0].pid = PidGains{.kp = 10.0, .limit = 50.0};
  EXPECT_NO_THROW(Synthesize(ProbeVehicle(), experiment, 1));
  experiment.drives.push_back({.dof = Dof::kYaw, .input = SinesOfRms(1.0), .pid = {}});
  EXPECT_THAT(
      [&] { Synthesize(ProbeVehicle(), experiment, 1); },
      testing::ThrowsMessage<InputError>(HasSubstr("surge is in closed loop while yaw turns")));
}

TEST(Synthesize, RefusesAnExperimentTooShortForALog) {
  Experiment experiment = SurgeRun(0.15, SinesOfRms(20.0));
  experiment.velocity->sampling.rate = 1.0;
  EXPECT_THAT([&] { Synthesize(ProbeVehicle(), experiment, 1); },
              testing::ThrowsMessage<InputError>(HasSubstr("velocity.csv would hold 1 rows")));
}

}  // namespace
}  // namespace fathom
