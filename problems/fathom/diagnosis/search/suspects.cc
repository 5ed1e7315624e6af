// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/suspects.h"

#include "fathom/vehicle/extended_model.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {
namespace {

double RmsCommand(const MeasuredSegments& segments) {
  double sum = 0.0, n = 0.0;
  for (const MeasuredSegment& segment : segments.all) {
    const HeldCommand& command = segment.inputs->command;
    for (const double value : command.value) sum += value * value;
    n += static_cast<double>(command.value.size());
  }
  return std::max(1e-9, std::sqrt(sum / std::max(1.0, n)));
}

bool Moves(const MeasuredSegments& segments, Dof dof) {
  return std::count(segments.partners.begin(), segments.partners.end(), dof) > 0;
}

bool IsCommanded(const MeasuredSegments& segments, Dof dof) {
  return std::all_of(segments.all.begin(), segments.all.end(), [&](const MeasuredSegment& segment) {
    const auto& values = segment.inputs->force[Index(dof)].value;
    if (values.empty()) return false;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *most > *least;
  });
}

// Whether an effect on poses leaves a trace. What is wrong with all of them alike, a scale or a
// clock, shows beside velocities only; what changes at a time shows by itself, since no vehicle
// jumps. Poses that are short of motion themselves would pass for another scale.
bool CanShowInPoses(const MeasuredSegments& segments, const EffectInfo& info) {
  if (!segments.has_displacement) return false;
  if (info.is_like_lost_motion && segments.poses_lose_motion) return false;
  return segments.has_velocity ||
         std::any_of(
             info.parameters.begin(), info.parameters.end(), [](const EffectParameter& parameter) {
               return parameter.search == Search::kTimeOfRun;
             });
}

// The logs that an effect is looked for in, one by one: those that are trained on, if it belongs to
// a run and there are several. Otherwise one without a name, which stands for all.
std::vector<std::string> LogsFor(const MeasuredSegments& segments, const EffectInfo& info) {
  if (info.scope != Scope::kRun || segments.logs.size() < 2) return {""};
  std::vector<std::string> logs;
  for (const MeasuredSegment& segment : segments.all) {
    const bool is_new = std::find(logs.begin(), logs.end(), segment.log) == logs.end();
    if (is_new && !segment.is_held_out) logs.push_back(segment.log);
  }
  return logs;
}

// Whether `partner` can be what the effect acts through, and these segments show it.
bool CanTakePart(const MeasuredSegments& segments, const EffectInfo& info, Dof dof, Dof partner) {
  if (!CanBePartner(info, dof, partner)) return false;
  if (info.partner->force && !IsCommanded(segments, partner)) return false;
  if (info.partner->velocity && !Moves(segments, partner)) return false;
  return !info.partner->yaw_rate || dof == Dof::kYaw || Moves(segments, Dof::kYaw);
}

}  // namespace

std::vector<Suspect> SuspectsFor(const MeasuredSegments& segments,
                                 Dof dof,
                                 std::span<const Effect* const> effects) {
  const double reference_force = RmsCommand(segments);
  std::vector<Suspect> suspects;
  for (const Effect* effect : effects) {
    const EffectInfo& info = effect->info();
    if (!CanActAlong(info, dof)) continue;
    if (info.needs_displacement && !segments.has_displacement) continue;
    if (info.needs_pose && !CanShowInPoses(segments, info)) continue;
    const EffectLaw<double>& law = effect->law<double>();
    const bool reads_velocity = law.reading || law.follow_reading;
    if (reads_velocity && !segments.has_velocity) continue;
    for (const std::string& log : LogsFor(segments, info)) {
      if (!info.has_partner()) {
        suspects.push_back({effect, {dof, dof, reference_force, log}});
        continue;
      }
      for (const Dof partner : kAllDofs) {
        if (CanTakePart(segments, info, dof, partner)) {
          suspects.push_back({effect, {dof, partner, reference_force, log}});
        }
      }
    }
  }
  return suspects;
}

std::string LabelOf(const Suspect& suspect) {
  return LabelOf(suspect.effect->info(), suspect.setting);
}

int PlaceIn(const ExtendedModel& model, const Suspect& suspect) {
  for (size_t k = 0; k < model.effects.size(); ++k) {
    const ActiveEffect& active = model.effects[k];
    if (active.effect == suspect.effect && active.setting.partner == suspect.setting.partner &&
        active.setting.log == suspect.setting.log) {
      return static_cast<int>(k);
    }
  }
  return -1;
}

std::string LabelsOf(const std::vector<int>& indices, const std::vector<Suspect>& suspects) {
  std::string labels;
  for (const int index : indices) {
    labels += (labels.empty() ? "" : " with ") + LabelOf(suspects[index]);
  }
  return labels;
}

bool ActOnPosesAlone(const std::vector<int>& indices, const std::vector<Suspect>& suspects) {
  return !indices.empty() && std::all_of(indices.begin(), indices.end(), [&](int index) {
    return suspects[index].effect->info().needs_pose;
  });
}

}  // namespace fathom
