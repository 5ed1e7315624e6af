// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "effect_size.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

#include "known_noise_fit.h"
#include <glog/logging.h>

namespace fathom::hidden {
namespace {

using Values = std::vector<double>;

double RootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double x : values) sum += x * x;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

// Sizes of what is left out of the catalogue: the first parameter is the amount.
SizedEffect DrawUnlistedShape(std::string_view name,
                              const UncoupledModel<double>& baseline,
                              const RunScales& scales,
                              double F,
                              double V,
                              Chance& chance) {
  const double damping = baseline.linear_damping + baseline.quadratic_damping * V;
  const double sign = chance.Sign();
  const double place = chance.Uniform(-0.8, 0.8) * scales.length;
  const double width = chance.Uniform(0.1, 0.4) * scales.length;
  const double heat_time = chance.LogUniform(15.0, 60.0);
  const double wander_time = chance.LogUniform(5.0, 40.0);
  const double realisation = std::floor(chance.Uniform(1.0, 1e6));
  if (name == "unlisted.thrust_backlash") return {0.8, [=](double s) { return Values{s * F}; }};
  if (name == "unlisted.thrust_levels") return {1.8, [=](double s) { return Values{s * F}; }};
  if (name == "unlisted.thruster_heat") {
    return {0.6, [=](double s) { return Values{s / F, heat_time}; }};
  }
  if (name == "unlisted.thrust_wash_drag") {
    return {1.0, [=](double s) { return Values{s / (V * V)}; }};
  }
  if (name == "unlisted.power_damping") {
    return {3.0, [=](double s) { return Values{s * damping / std::sqrt(V)}; }};
  }
  if (name == "unlisted.place_bump") {
    return {1.5, [=](double s) { return Values{sign * s * F, place, width}; }};
  }
  if (name == "unlisted.slack_tether") {
    return {3.0, [=](double s) { return Values{s * F / scales.length, place}; }};
  }
  if (name == "unlisted.wandering_current") {
    return {0.8, [=](double s) { return Values{s * V, wander_time, realisation}; }};
  }
  LOG(FATAL) << "no sizes for " << name;
}

}  // namespace

RunScales ScalesOfRun(const EffectInputs& inputs, Dof dof, double train_to) {
  RunScales scales;
  for (int i = 0; i < 6; ++i) {
    scales.force[i] = RootMeanSquare(inputs.force[i].value);
    scales.speed[i] = RootMeanSquare(inputs.velocity[i].value);
  }
  for (const double x : inputs.command.value)
    scales.most_force = std::max(scales.most_force, std::abs(x));
  const SampledSignal& velocity = inputs.velocity[Index(dof)];
  std::vector<double> place(velocity.time.size(), 0.0);
  double mean = 0.0;
  for (std::size_t i = 1; i < place.size(); ++i) {
    place[i] = place[i - 1] + velocity.value[i] * (velocity.time[i] - velocity.time[i - 1]);
    mean += place[i] / static_cast<double>(place.size());
  }
  for (double& x : place) x -= mean;
  scales.length = RootMeanSquare(place);
  scales.duration = velocity.time.back() - velocity.time.front();
  scales.train_duration = train_to - inputs.command.time.front();
  return scales;
}

SizedEffect DrawShape(const ActiveEffect& effect,
                      const UncoupledModel<double>& baseline,
                      const RunScales& scales,
                      Chance& chance) {
  const std::string_view name = effect.effect->info().name;
  const double F = scales.force[Index(effect.setting.dof)];
  const double V = scales.speed[Index(effect.setting.dof)];
  const double partner_F = scales.force[Index(effect.setting.partner)];
  const double partner_V = scales.speed[Index(effect.setting.partner)];
  const double yaw_rate = scales.speed[Index(Dof::kYaw)];
  const double T = scales.duration;
  const double sign = chance.Sign();
  const double time = chance.Uniform(0.2, 0.8) * std::min(T, scales.train_duration);
  const double phase = chance.Uniform(0.0, 6.283);
  const double frequency = chance.LogUniform(0.15, 2.5);
  const double memory_time = chance.LogUniform(0.6, 12.0);
  const double Fmax = scales.most_force;
  const double damping = baseline.linear_damping + baseline.quadratic_damping * V;
  if (name.substr(0, 9) == "unlisted.")
    return DrawUnlistedShape(name, baseline, scales, F, V, chance);

  const std::map<std::string_view, SizedEffect> shapes = {
      {"time_offset", {1.5, [=](double s) { return Values{sign * s}; }}},
      {"thrust_dead_zone", {0.8, [=](double s) { return Values{s * F}; }}},
      {"thrust_saturation", {0.7, [=](double s) { return Values{(1.0 - s) * Fmax}; }}},
      {"thrust_curve", {0.7, [=](double s) { return Values{std::exp(sign * s)}; }}},
      {"thrust_asymmetry", {0.6, [=](double s) { return Values{sign * s}; }}},
      {"thrust_fade", {0.7, [=](double s) { return Values{s / T}; }}},
      {"thrust_step_loss",
       {0.9,
        [=](double s) {
          return Values{s, time};
        }}},
      {"thrust_slew_limit", {8.0, [=](double s) { return Values{F / s}; }}},
      {"thruster_lag", {3.0, [=](double s) { return Values{s}; }}},
      {"thrust_inflow_loss", {0.6, [=](double s) { return Values{s * std::sqrt(F) / V}; }}},
      {"damping_asymmetry",
       {3.0, [=](double s) { return Values{sign > 0.0 ? s : -s / (1.0 + s)}; }}},
      {"cubic_damping", {2.0, [=](double s) { return Values{s * F / (V * V * V)}; }}},
      {"coulomb_friction", {0.4, [=](double s) { return Values{s * F}; }}},
      {"steady_current", {0.8, [=](double s) { return Values{sign * s * V}; }}},
      {"position_stiffness", {1.0, [=](double s) { return Values{s * F / scales.length}; }}},
      {"righting_moment",
       {1.0, [=](double s) { return Values{s * F / std::min(scales.length, 1.0)}; }}},
      {"buoyancy_step",
       {0.8,
        [=](double s) {
          return Values{sign * s * F, time};
        }}},
      {"buoyancy_drift", {1.0, [=](double s) { return Values{sign * s * F / T}; }}},
      {"periodic_force",
       {0.6,
        [=](double s) {
          return Values{s * F * std::sin(phase), s * F * std::cos(phase), frequency};
        }}},
      {"fluid_memory",
       {3.0,
        [=](double s) {
          return Values{s * damping, memory_time};
        }}},
      {"coriolis_coupling",
       {0.8, [=](double s) { return Values{sign * s * F / (partner_V * yaw_rate)}; }}},
      {"velocity_coupling", {0.8, [=](double s) { return Values{sign * s * F / partner_V}; }}},
      {"thrust_crosstalk", {0.8, [=](double s) { return Values{sign * s * F / partner_F}; }}},
      {"sensor_misalignment", {0.6, [=](double s) { return Values{sign * s}; }}},
      {"lever_arm", {1.0, [=](double s) { return Values{sign * s * V / partner_V}; }}},
      {"sensor_bias", {0.6, [=](double s) { return Values{sign * s * V}; }}},
      {"sensor_lag", {3.0, [=](double s) { return Values{s}; }}},
      {"sensor_clock_offset", {1.5, [=](double s) { return Values{sign * s}; }}},
      {"pose_scale", {0.4, [=](double s) { return Values{sign * s}; }}},
      {"marker_moved",
       {0.6,
        [=](double s) {
          return Values{sign * s * scales.length, time};
        }}},
  };
  const auto found = shapes.find(name);
  CHECK(found != shapes.end()) << "no sizes for " << name;
  return found->second;
}

double SignatureOf(const UncoupledModel<double>& baseline,
                   const InitialState& initial,
                   const ActiveEffect& effect,
                   KnownRun* run) {
  if (!run->Pretend({baseline, {effect}}, initial)) return std::numeric_limits<double>::infinity();
  KnownNoiseFitOptions options;
  options.max_iterations = 6;
  return std::sqrt(FitWithKnownNoise(*run, {baseline, {}}, initial, options).chi2);
}

double SizeFor(double wanted,
               const UncoupledModel<double>& baseline,
               const InitialState& initial,
               const SizedEffect& sized,
               KnownRun* run,
               ActiveEffect* effect) {
  const auto signature = [&](double size) {
    effect->values = sized.values(size);
    return SignatureOf(baseline, initial, *effect, run);
  };
  double low = std::log(1e-5 * sized.largest), high = std::log(sized.largest);
  for (int i = 0; i < 11; ++i) {
    const double middle = 0.5 * (low + high);
    (signature(std::exp(middle)) < wanted ? low : high) = middle;
  }
  return signature(std::exp(low));  // a size that does not diverge
}

}  // namespace fathom::hidden
