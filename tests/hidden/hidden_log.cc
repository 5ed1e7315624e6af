// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "hidden_log.h"

#include "fathom/base/input_error.h"
#include "fathom/synthesize/synthesize.h"

#include <algorithm>
#include <cmath>

#include "drawn_setup.h"
#include "effect_size.h"
#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom::hidden {
namespace {

std::uint64_t SeedOf(const std::string& name, std::uint64_t seed) {
  std::uint64_t hash = 14695981039346656037ull ^ seed;  // FNV-1a
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

const std::vector<Dof> kLinear = {Dof::kSurge, Dof::kSway, Dof::kHeave};
const std::vector<Dof> kDriven = {Dof::kSurge, Dof::kSway, Dof::kHeave, Dof::kYaw};

// Who must move for an effect: its DOF, its partner and further ones. Several choices.
struct Roles {
  Dof dof;
  Dof partner;
  std::vector<Dof> others;
};

Roles DrawRoles(const EffectInfo& info, Chance& chance) {
  if (info.name == "coriolis_coupling") {
    return chance.Is(0.5) ? Roles{Dof::kSurge, Dof::kSway, {Dof::kYaw}}
                          : Roles{Dof::kSway, Dof::kSurge, {Dof::kYaw}};
  }
  if (info.name == "lever_arm")
    return {chance.OneOf<Dof>({Dof::kSurge, Dof::kSway}), Dof::kYaw, {}};
  if (info.name == "sensor_misalignment") {
    const Dof dof = chance.OneOf(kLinear);
    Dof partner = chance.OneOf(kLinear);
    while (partner == dof) partner = chance.OneOf(kLinear);
    return {dof, partner, {}};
  }
  const Dof dof = chance.OneOf(kDriven);
  Dof partner = chance.OneOf(kDriven);
  while (partner == dof) partner = chance.OneOf(kDriven);
  return {dof, partner, {}};
}

void Add(Dof dof, std::vector<Dof>* dofs) {
  if (std::find(dofs->begin(), dofs->end(), dof) == dofs->end()) dofs->push_back(dof);
}

// Of the first effect that says who, if any does; partners of others follow it.
Cast DrawCast(const std::vector<const Effect*>& hidden,
              Chance& chance,
              std::vector<ActiveEffect>* effects) {
  Cast cast;
  cast.dof = chance.OneOf(kDriven);
  for (const Effect* effect : hidden) {
    const EffectInfo& info = effect->info();
    cast.needs_pose = cast.needs_pose || info.needs_pose || info.needs_displacement;
    if (!CanActAlong(info, cast.dof)) cast.dof = Dof::kRoll;
  }
  const auto with_partner = std::find_if(
      hidden.begin(), hidden.end(), [](const Effect* e) { return e->info().has_partner(); });
  std::vector<Dof> partners;
  Dof partner = Dof::kYaw;
  if (with_partner != hidden.end()) {
    Roles roles = DrawRoles((*with_partner)->info(), chance);
    const auto turns = [&] {
      return roles.dof != Dof::kHeave && roles.dof != Dof::kYaw &&
             (roles.partner == Dof::kYaw || !roles.others.empty());
    };
    const bool can_avoid = (*with_partner)->info().name != "lever_arm" &&
                           (*with_partner)->info().name != "coriolis_coupling";
    while (cast.needs_pose && can_avoid && turns())
      roles = DrawRoles((*with_partner)->info(), chance);
    cast.dof = roles.dof;
    partner = roles.partner;
    Add(roles.partner, &partners);
    for (const Dof other : roles.others) Add(other, &partners);
  }
  // Others that move although nothing asks for it.
  const int num_idle = chance.Is(0.35) ? 1 + chance.Index(2) : 0;
  for (int i = 0; i < num_idle; ++i) {
    const Dof idle = chance.OneOf(kDriven);
    // A vehicle that yaws while it rolls pitches too.
    const bool would_turn = idle == Dof::kYaw && cast.needs_pose && cast.dof != Dof::kHeave;
    if (idle != cast.dof && !would_turn) Add(idle, &partners);
  }
  std::sort(partners.begin(), partners.end());
  cast.partners = partners;
  for (const Effect* effect : hidden) {
    ActiveEffect active;
    active.effect = effect;
    active.setting.dof = cast.dof;
    active.setting.partner = partner;
    effects->push_back(active);
  }
  return cast;
}

KnownNoise NoiseOf(const Setup& setup, double inertia) {
  const Experiment& experiment = setup.experiment;
  const int dof = Index(setup.cast.dof);
  const VelocitySensor& velocity = *experiment.velocity;
  KnownNoise noise;
  const double std = velocity.noise[dof];
  if (velocity.noise_correlation > 0.0) {
    const double step = 1.0 / velocity.sampling.rate;
    noise.model.velocity.coloured = {std, -step / std::log(velocity.noise_correlation)};
    noise.model.velocity.white_std = 0.02 * std;  // jitter makes the steps uneven
  } else {
    noise.model.velocity.white_std = std;
  }
  if (experiment.pose) {
    noise.model.displacement.white_std =
        IsAngular(setup.cast.dof) ? experiment.pose->angle_noise : experiment.pose->position_noise;
  }
  noise.use_poses = setup.poses_show_the_dof;
  for (const Drive& drive : experiment.drives) {
    if (drive.dof != setup.cast.dof || drive.turbulence.force == 0.0) continue;
    noise.model.disturbance = {drive.turbulence.force / inertia, drive.turbulence.correlation_time};
    noise.model.damping_rate = setup.damping_rate;
  }
  return noise;
}

// A reading that is put together from a partner's carries the partner's noise too.
void AddPartnersNoise(const std::vector<ActiveEffect>& effects,
                      const VelocitySensor& sensor,
                      NoiseModel* noise) {
  double factor2 = 1.0;
  for (const ActiveEffect& active : effects) {
    const double own = sensor.noise[Index(active.setting.dof)];
    const double other = sensor.noise[Index(active.setting.partner)];
    double share = 0.0;
    if (active.effect->info().name == "lever_arm") share = active.values[0];
    if (active.effect->info().name == "sensor_misalignment") share = std::tan(active.values[0]);
    factor2 += share * share * other * other / (own * own);
  }
  noise->velocity.white_std *= std::sqrt(factor2);
  noise->velocity.coloured.std *= std::sqrt(factor2);
}

// Readings that mean nothing, as a DVL gives them over a poor bottom; one in a hundred.
void AddOutliers(Dof dof, double speed, std::uint64_t seed, HiddenLog* hidden) {
  Chance chance(seed, "hidden.outliers");
  Stream& stream = *hidden->log.velocity;
  const auto column = std::find(stream.columns.begin(), stream.columns.end(), VelocityColumn(dof));
  std::vector<double>& values = stream.values[column - stream.columns.begin()];
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!chance.Is(0.01)) continue;
    values[i] += chance.Sign() * chance.Uniform(0.5, 3.0) * speed;
    hidden->truth.noise.outlier_stamps.push_back(stream.time[i]);
  }
}

}  // namespace

std::string LabelOf(const ActiveEffect& effect) {
  const EffectInfo& info = effect.effect->info();
  return info.has_partner() ? fmt::format("{}({})", info.name, Name(effect.setting.partner))
                            : std::string(info.name);
}

std::string LogPlan::Name() const {
  std::string name;
  for (const Effect* effect : effects) {
    name += fmt::format("{}{}", name.empty() ? "" : "+", effect->info().name);
  }
  return fmt::format("{}.{}", name.empty() ? "nothing" : name, number);
}

HiddenLog DrawHiddenLog(const LogPlan& plan, std::uint64_t master_seed) {
  const std::uint64_t seed = SeedOf(plan.Name(), master_seed);
  HiddenLog hidden;
  hidden.plan = plan;
  Chance casting(seed, "hidden.cast");
  std::vector<ActiveEffect> effects;
  const Cast cast = DrawCast(plan.effects, casting, &effects);
  const Setup setup = DrawSetup(cast, seed);
  Truth& truth = hidden.truth;
  hidden.dof = cast.dof;
  truth.setup = setup.text;
  truth.model.baseline = *setup.vehicle.models[Index(cast.dof)];
  truth.noise = NoiseOf(setup, truth.model.baseline.inertia);
  const Experiment& experiment = setup.experiment;
  truth.train_from = experiment.start_time;
  truth.held_out_to = experiment.start_time + experiment.duration;
  truth.train_to =
      experiment.held_out.empty() ? truth.held_out_to : experiment.held_out.front().from;

  // How large: on the log in which nothing is hidden.
  hidden.log = Synthesize(setup.vehicle, experiment, seed);
  const EffectInputs inputs = UnsmoothedInputsOf(hidden.log, cast.dof);
  const RunScales scales = ScalesOfRun(inputs, cast.dof, truth.train_to);
  if (!effects.empty()) {
    KnownRun run(hidden.log, cast.dof, truth.train_from, truth.train_to, truth.noise);
    Chance sizes(seed, "hidden.sizes");
    for (ActiveEffect& effect : effects) {
      effect.setting.reference_force = scales.force[Index(cast.dof)];
      const double wanted = sizes.LogUniform(6.0, 60.0);
      const SizedEffect sized = DrawShape(effect, truth.model.baseline, scales, sizes);
      truth.signature.push_back(
          SizeFor(wanted, truth.model.baseline, run.FirstGuess(), sized, &run, &effect));
    }
    try {
      hidden.log = Synthesize(setup.vehicle, experiment, effects, seed);
    } catch (const InputError& error) {
      LOG(FATAL) << plan.Name() << ": " << error.what();
    }
    AddPartnersNoise(effects, *experiment.velocity, &truth.noise.model);
  }
  truth.model.effects = effects;
  hidden.log.name = "hidden";
  if (setup.has_outliers) AddOutliers(cast.dof, scales.speed[Index(cast.dof)], seed, &hidden);
  return hidden;
}

}  // namespace fathom::hidden
