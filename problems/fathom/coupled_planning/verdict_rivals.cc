// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/verdict_rivals.h"

#include "fathom/base/input_error.h"
#include "fathom/planning/open_causes.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/files/json_value.h"

#include <algorithm>

#include <fmt/format.h>

namespace fathom {
namespace {

FreeEntry EntryOf(const JsonValue& at, const std::string& text) {
  try {
    return ParseFreeEntry(text);
  } catch (const InputError& error) {
    at.Fail(fmt::format("names no entry: {}", error.what()));
  }
}

FreeEntry NamedIn(const JsonValue& cause, const FittedCoupledModel& fitted) {
  const JsonValue at = cause.Member("entry");
  const FreeEntry named = EntryOf(at, at.Text());
  if (std::ranges::find(fitted.entries, named) != fitted.entries.end()) return named;
  at.Fail(fmt::format("is '{}', expected a number that the model identified", NameOf(named)));
}

// Why a wrench does not tell of it; empty if it does.
std::string WhyNotTold(const FreeEntry& entry, const std::vector<Dof>& dofs) {
  if (IsOfRun(entry)) return "it belongs to one log: any new one tells";
  if (!entry.actuator.empty() || entry.kind == FreeEntry::Kind::kThrusterEffect) {
    return "a wrench tells nothing of single thrusters and fins";
  }
  const auto is_modelled = [&](Dof dof) { return std::ranges::find(dofs, dof) != dofs.end(); };
  if (IsOfActuator(entry) || (is_modelled(entry.row) && is_modelled(entry.column))) return "";
  return "its DOF is not modelled";
}

}  // namespace

VerdictRivals ReadVerdictRivals(const std::string& name,
                                std::string_view text,
                                const FittedCoupledModel& fitted) {
  VerdictRivals rivals;
  const JsonValue file = JsonValue::Parse(name, text);
  for (const JsonValue& cause : AmbiguousCauses(file)) {
    const FreeEntry named = NamedIn(cause, fitted);
    const JsonValue alternatives = cause.Member("alternatives");
    for (const std::string& alternative : alternatives.Texts()) {
      const FreeEntry rival = EntryOf(alternatives, alternative);
      std::string why = WhyNotTold(named, fitted.model.dofs);
      if (why.empty()) why = WhyNotTold(rival, fitted.model.dofs);
      if (why.empty()) {
        rivals.pairs.push_back({named, ValueIn(fitted.model, named), rival});
      } else {
        rivals.left_out.push_back(
            fmt::format("{} against {} is left out: {}.", NameOf(named), alternative, why));
      }
    }
  }
  return rivals;
}

}  // namespace fathom
