// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "drawn_setup.h"

#include "fathom/simulate/simulate.h"

#include <algorithm>
#include <cmath>

#include "drawn_input.h"
#include <fmt/format.h>

namespace fathom::hidden {
namespace {

constexpr int kMostSamples = 6000;  // of a stream: the oracle's time is spent per sample

// FlatFish's, with a sway, a roll and a quadratic surge damping that its paper does not tell.
constexpr std::array<UncoupledModel<double>, 6> kTypical = {{{851.0, 50.0, 39.6, 0.0},
                                                             {1200.0, 400.0, 60.0, 0.0},
                                                             {1511.0, 1200.0, 60.0, 0.0},
                                                             {150.0, 120.0, 25.0, 0.0},
                                                             {},
                                                             {302.0, 279.0, 27.0, 0.0}}};

struct Motion {
  double speed = 0.0;  // RMS
  double force = 0.0;  // RMS
};

Motion MotionUnder(const InputSignal& input,
                   const UncoupledModel<double>& model,
                   double duration,
                   double rate) {
  HeldCommand command;
  double force2 = 0.0;
  for (int k = 0; k / rate < duration; ++k) {
    command.time.push_back(k / rate);
    command.value.push_back(Value(input, k / rate));
    force2 += command.value.back() * command.value.back();
  }
  std::vector<double> velocity(command.time.size());
  const Simulation simulation(command, command.time);
  if (!simulation.Run(model, {}, velocity, {})) return {1e9, 1.0};
  double speed2 = 0.0;
  for (const double v : velocity) speed2 += v * v;
  const double n = static_cast<double>(velocity.size());
  return {std::sqrt(speed2 / n), std::sqrt(force2 / n)};
}

struct DrawnDrive {
  Drive drive;
  UncoupledModel<double> model;
  Motion motion;
  std::string kind;
  double damping_rate = 0.1;
};

DrawnDrive DrawDrive(Dof dof, double duration, double rate, std::uint64_t seed) {
  const std::string name(Name(dof));
  Chance chance(seed, "hidden.vehicle." + name);
  DrawnDrive drawn;
  drawn.drive.dof = dof;
  const auto factor = [&chance] { return chance.LogUniform(0.316, 3.16); };
  const auto& typical = kTypical[Index(dof)];
  drawn.model = {typical.inertia * factor(),
                 typical.quadratic_damping * factor(),
                 typical.linear_damping * factor(),
                 0.0};
  const double speed = IsAngular(dof) ? chance.LogUniform(0.06, 0.4) : chance.LogUniform(0.1, 0.7);
  const double drag = drawn.model.linear_damping + 1.6 * drawn.model.quadratic_damping * speed;
  drawn.damping_rate = drag / drawn.model.inertia;
  const double offset_share = chance.Sign() * chance.LogUniform(0.005, 0.2);
  const bool is_moving = chance.Is(0.25);
  if (is_moving) drawn.drive.initial_speed = chance.Uniform(-1.0, 1.0) * speed;

  DrawnInput input = DrawInput(duration, rate, 1.0 / drawn.damping_rate, seed, "input." + name);
  drawn.kind = input.kind;
  // As Synthesize() will draw them.
  InputSignal complete = input.input;
  RandomStream random(seed, "input." + name);
  DrawRandomParts(complete, duration, random);
  double scale = drag * speed;
  Scale(complete, scale);
  for (int i = 0; i < 4; ++i) {
    const Motion motion = MotionUnder(complete, drawn.model, duration, rate);
    const double correction = std::clamp(speed / motion.speed, 0.1, 10.0);
    Scale(complete, correction);
    scale *= correction;
  }
  Scale(input.input, scale);
  drawn.drive.input = input.input;
  drawn.motion = MotionUnder(complete, drawn.model, duration, rate);
  // Against the drag: a vehicle of little drag must not be carried away.
  drawn.model.buoyancy = 2.0 * offset_share * drag * speed;
  return drawn;
}

Sampling DrawSampling(double rate, Chance& chance) {
  Sampling sampling;
  sampling.rate = rate;
  if (chance.Is(0.5)) sampling.jitter = chance.Uniform(0.02, 0.15) / rate;
  if (chance.Is(0.3)) {
    sampling.drop_outs = {chance.Uniform(0.01, 0.05) / rate, 0.3, chance.Uniform(0.5, 4.0)};
  }
  return sampling;
}

// In steps of 0.1 Hz, so that logs read well.
double DrawRate(double lowest, double duration, Chance& chance) {
  const double highest = std::clamp(kMostSamples / duration, lowest, 50.0);
  return std::round(10.0 * chance.LogUniform(lowest, highest)) / 10.0;
}

}  // namespace

double Chance::LogUniform(double low, double high) {
  return low * std::pow(high / low, Uniform(0, 1));
}

Setup DrawSetup(const Cast& cast, std::uint64_t seed) {
  Setup setup;
  setup.cast = cast;
  Chance chance(seed, "hidden.setup");
  Experiment& experiment = setup.experiment;
  experiment.duration = std::round(chance.Uniform(120.0, 600.0));
  experiment.start_time = chance.Is(0.5) ? 0.0 : std::round(chance.Uniform(1.0, 5000.0));
  experiment.command_rate = DrawRate(5.0, experiment.duration, chance);
  VelocitySensor velocity;
  velocity.sampling = DrawSampling(DrawRate(5.0, experiment.duration, chance), chance);
  const double noise_share = chance.LogUniform(0.003, 0.1);
  velocity.noise_correlation = chance.Is(0.5) ? 0.0 : chance.Uniform(0.2, 0.9);
  const bool is_turbulent = chance.Is(0.33);
  const double turbulence_share = chance.LogUniform(0.005, 0.03);
  const double turbulence_time = chance.LogUniform(0.5, 8.0);

  std::vector<Dof> dofs = cast.partners;
  dofs.push_back(cast.dof);
  std::sort(dofs.begin(), dofs.end());
  double travel = 0.0;
  std::string kind;
  for (const Dof dof : dofs) {
    DrawnDrive drawn = DrawDrive(dof, experiment.duration, experiment.command_rate, seed);
    setup.vehicle.models[Index(dof)] = drawn.model;
    velocity.noise[Index(dof)] = noise_share * drawn.motion.speed;
    if (is_turbulent) {
      // Force whose response is `turbulence_share` of the speed: docs/residual_noise.md (3).
      const double a = drawn.damping_rate, tau = turbulence_time;
      const double acceleration =
          turbulence_share * drawn.motion.speed * std::sqrt(a * (a + 1.0 / tau));
      drawn.drive.turbulence = {acceleration * drawn.model.inertia, tau};
    }
    if (dof == cast.dof) {
      setup.damping_rate = drawn.damping_rate;
      travel = drawn.motion.speed / drawn.damping_rate;
      kind = drawn.kind;
    }
    experiment.drives.push_back(std::move(drawn.drive));
  }
  experiment.velocity = velocity;

  const bool axis_turns = (cast.dof == Dof::kSurge || cast.dof == Dof::kSway) &&
                          setup.vehicle.models[Index(Dof::kYaw)].has_value();
  const bool has_pose = chance.Is(axis_turns ? 0.2 : 0.5) || cast.needs_pose;
  PoseSensor pose;
  pose.sampling = DrawSampling(DrawRate(2.0, 2.0 * experiment.duration, chance), chance);
  pose.position_noise = std::clamp(chance.LogUniform(0.001, 0.02) * travel, 0.002, 0.1);
  pose.angle_noise = chance.LogUniform(0.002, 0.02);
  if (has_pose) experiment.pose = pose;
  setup.poses_show_the_dof = has_pose && !axis_turns;
  setup.has_outliers = chance.Is(0.2);
  if (chance.Is(0.8)) {
    const double end = experiment.start_time + experiment.duration;
    experiment.held_out = {{end - chance.Uniform(0.2, 0.3) * experiment.duration, end + 1.0}};
  }
  setup.vehicle.name = "hidden";
  setup.vehicle.mass = 300.0;
  setup.vehicle.size = Eigen::Vector3d(1.0, 1.0, 1.0);

  std::string partners;
  for (const Dof dof : cast.partners) partners += fmt::format("+{}", Name(dof));
  setup.text =
      fmt::format("{}{}, {}, {:.0f} s, command {:.3g} Hz, velocity {:.3g} Hz, noise {:.1f} %",
                  Name(cast.dof),
                  partners,
                  kind,
                  experiment.duration,
                  experiment.command_rate,
                  velocity.sampling.rate,
                  100.0 * noise_share);
  if (velocity.noise_correlation > 0.0)
    setup.text += fmt::format(" AR {:.2f}", velocity.noise_correlation);
  if (has_pose) setup.text += axis_turns ? ", poses of a turning vehicle" : ", poses";
  if (is_turbulent) setup.text += fmt::format(", turbulence {:.1f} %", 100.0 * turbulence_share);
  if (setup.has_outliers) setup.text += ", outliers";
  if (experiment.held_out.empty()) setup.text += ", nothing held out";
  return setup;
}

}  // namespace fathom::hidden
