// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/diagnosis.h"

#include <set>
#include <string>
#include <vector>

namespace fathom {

// The effects that a diagnosis names, each with all that it says it cannot be told from.
struct NamedGroup {
  std::string cause;
  std::set<std::string> members;  // the cause and its alternatives
  std::string experiment;
};

inline std::string LabelOf(const ActiveEffect& active) {
  std::string label(active.effect->info().name);
  if (active.effect->info().has_partner()) {
    label += "(" + std::string(Name(active.setting.partner)) + ")";
  }
  return label;
}

inline std::vector<NamedGroup> GroupsOf(const Diagnosis& diagnosis) {
  std::vector<NamedGroup> groups;
  for (const Cause& cause : diagnosis.causes) {
    NamedGroup group;
    group.cause = LabelOf(diagnosis.extended.model.effects.at(cause.effect_index));
    for (const Alternative& other : cause.alternatives) group.members.insert(other.label);
    group.members.insert(group.cause);
    group.experiment = cause.experiment.text;
    groups.push_back(group);
  }
  return groups;
}

// "explained: thruster_lag [time_offset sensor_lag]"
inline std::string TextOf(const Diagnosis& diagnosis) {
  std::string text = std::string(Name(diagnosis.verdict)) + ":";
  for (const NamedGroup& group : GroupsOf(diagnosis)) {
    text += " " + group.cause;
    if (group.members.size() == 1) continue;
    text += " [";
    for (const std::string& member : group.members) {
      if (member != group.cause) text += " " + member;
    }
    text += " ]";
  }
  return text;
}

}  // namespace fathom
