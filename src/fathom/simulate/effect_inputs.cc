// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/effect_inputs.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/signal/pose_velocity.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/vehicle/extended_model.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace fathom {
namespace {

// Of every DOF, where the local polynomials of the poses tell it.
std::vector<SampledSignal> VelocitiesFromPoses(const Stream& stream) {
  const Poses poses = PosesOf(stream);
  SavitzkyGolayOptions options;
  options.window = std::max(1.0, 10.5 * MedianStep(stream.time));  // 11 samples, and 1 s, at least
  const BodyVelocity body = VelocityOf(poses, options);
  std::vector<SampledSignal> signals(kAllDofs.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!body.velocity[i].allFinite()) continue;
    for (const Dof dof : kAllDofs) {
      if (!TellsMotion(stream, dof)) continue;
      signals[Index(dof)].time.push_back(poses.time[i]);
      signals[Index(dof)].value.push_back(body.velocity[i][Index(dof)]);
    }
  }
  return signals;
}

}  // namespace

SampledSignal PartnerVelocity(const std::vector<double>& time,
                              const std::vector<double>& measured) {
  constexpr std::size_t kFewest = 20;
  if (measured.size() < kFewest) return {time, measured};
  const double step = MedianStep(time);
  SavitzkyGolayOptions options;
  options.window = ChooseWindow(time, measured, options.order, 5.5 * step, 80.5 * step);
  SampledSignal smooth = {time, SavitzkyGolay(time, measured, 0, options)};
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (!std::isfinite(smooth.value[i])) smooth.value[i] = measured[i];
  }
  return smooth;
}

EffectInputs MeasuredInputsOf(const Log& log, Dof dof) {
  EffectInputs inputs;
  inputs.dof = dof;
  inputs.command = CommandOf(log, dof);
  for (const Dof other : kAllDofs) {
    if (log.command) {
      if (const auto* force = log.command->Find(ForceColumn(other))) {
        inputs.force[Index(other)] = {log.command->time, *force};
      }
    }
    if (log.velocity) {
      if (const auto* velocity = log.velocity->Find(VelocityColumn(other))) {
        inputs.velocity[Index(other)] = PartnerVelocity(log.velocity->time, *velocity);
      }
    }
  }
  return inputs;
}

EffectInputs EffectInputsOf(const Log& log, Dof dof) {
  EffectInputs inputs = MeasuredInputsOf(log, dof);
  if (!log.pose) return inputs;
  const std::vector<SampledSignal> from_poses = VelocitiesFromPoses(*log.pose);
  for (const Dof other : kAllDofs) {
    SampledSignal& velocity = inputs.velocity[Index(other)];
    if (velocity.time.empty()) velocity = from_poses[Index(other)];
  }
  return inputs;
}

EffectInputs CommandOnly(const Segment& segment) {
  EffectInputs inputs;
  inputs.command = segment.command;
  return inputs;
}

void RequirePartners(const ExtendedModel& model, const EffectInputs& inputs, const Log& log) {
  for (const ActiveEffect& active : model.effects) {
    if (!active.effect->info().partner) continue;
    const PartnerInfo& reads = *active.effect->info().partner;
    const std::string label = LabelOf(active.effect->info(), active.setting);
    const auto require_velocity = [&](Dof dof) {
      if (!inputs.velocity[Index(dof)].time.empty()) return;
      throw InputError(
          fmt::format("{}: the model's {} needs the measured {} velocity, expected column '{}' in "
                      "velocity.csv, or a pose.csv.",
                      log.path.string(),
                      label,
                      Name(dof),
                      VelocityColumn(dof)));
    };
    if (reads.velocity) require_velocity(active.setting.partner);
    if (reads.yaw_rate && active.setting.dof != Dof::kYaw) require_velocity(Dof::kYaw);
    if (reads.force && inputs.force[Index(active.setting.partner)].time.empty()) {
      throw InputError(
          fmt::format("{}: the model's {} needs the command of {}, expected column '{}' in "
                      "command.csv.",
                      log.path.string(),
                      label,
                      Name(active.setting.partner),
                      ForceColumn(active.setting.partner)));
    }
  }
}

}  // namespace fathom
