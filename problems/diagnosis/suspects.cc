// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/suspects.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {
namespace {

double RmsCommand(const Records& records) {
  double sum = 0.0, n = 0.0;
  for (const Record& record : records.all) {
    const HeldCommand& command = record.inputs->command;
    for (const double value : command.value) sum += value * value;
    n += static_cast<double>(command.value.size());
  }
  return std::max(1e-9, std::sqrt(sum / std::max(1.0, n)));
}

bool Moves(const Records& records, Dof dof) {
  return std::count(records.partners.begin(), records.partners.end(), dof) > 0;
}

bool IsCommanded(const Records& records, Dof dof) {
  return std::all_of(records.all.begin(), records.all.end(), [&](const Record& record) {
    const auto& values = record.inputs->force[Index(dof)].value;
    if (values.empty()) return false;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *most > *least;
  });
}

bool IsHorizontal(Dof dof) { return dof == Dof::kSurge || dof == Dof::kSway; }

// Whether an effect on poses leaves a trace. What is wrong with all of them alike, a scale or a
// clock, shows beside velocities only; what changes at a time shows by itself, since no vehicle
// jumps.
bool CanShowInPoses(const Records& records, const EffectInfo& info) {
  if (!records.has_displacement) return false;
  return records.has_velocity ||
         std::any_of(
             info.parameters.begin(), info.parameters.end(), [](const EffectParameter& parameter) {
               return parameter.search == Search::kTimeOfRun;
             });
}

// Whether `partner` can be what the effect acts through, and these records show it.
bool CanPartner(const Records& records, Dof dof, Dof partner, std::string_view effect) {
  if (partner == dof) return false;
  if (effect == "thrust_crosstalk") return IsCommanded(records, partner);
  if (!Moves(records, partner)) return false;
  if (effect == "coriolis_coupling") {
    return IsHorizontal(dof) && IsHorizontal(partner) && Moves(records, Dof::kYaw);
  }
  if (effect == "sensor_misalignment") return IsAngular(dof) == IsAngular(partner);
  if (effect == "lever_arm") {
    if (IsHorizontal(dof)) return partner == Dof::kYaw;
    return dof == Dof::kHeave && (partner == Dof::kRoll || partner == Dof::kPitch);
  }
  return true;
}

}  // namespace

std::vector<Suspect> SuspectsFor(const Records& records,
                                 Dof dof,
                                 std::span<const Effect* const> effects) {
  const double reference_force = RmsCommand(records);
  std::vector<Suspect> suspects;
  for (const Effect* effect : effects) {
    const EffectInfo& info = effect->info();
    if (info.needs_pose && !CanShowInPoses(records, info)) continue;
    const bool reads_velocity = effect->laws().has.reading || effect->laws().has.follow_reading;
    if (reads_velocity && !records.has_velocity) continue;
    if (!info.has_partner) {
      suspects.push_back({effect, {dof, dof, reference_force}});
      continue;
    }
    for (const Dof partner : kAllDofs) {
      if (CanPartner(records, dof, partner, info.name)) {
        suspects.push_back({effect, {dof, partner, reference_force}});
      }
    }
  }
  return suspects;
}

std::string LabelOf(const Suspect& suspect) {
  const EffectInfo& info = suspect.effect->info();
  return info.has_partner ? fmt::format("{}({})", info.name, Name(suspect.setting.partner))
                          : std::string(info.name);
}

std::string LabelsOf(const std::vector<int>& indices, const std::vector<Suspect>& suspects) {
  std::string labels;
  for (const int index : indices) {
    labels += (labels.empty() ? "" : " with ") + LabelOf(suspects[index]);
  }
  return labels;
}

}  // namespace fathom
