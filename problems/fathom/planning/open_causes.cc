// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/open_causes.h"

#include "fathom/simulate/noise_floor.h"
#include "fathom/vehicle/files/effect_entries.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// Of an alternative, which stands under `candidates` too; nothing if it has no numbers there.
std::optional<ActiveEffect> EffectOfCandidate(const JsonValue& candidate, Dof dof) {
  ActiveEffect active = ReadSetEffect(candidate, dof);
  const JsonValue parameters = candidate.Member("parameters");
  for (const EffectParameter& parameter : active.effect->info().parameters) {
    const std::string key(parameter.name);
    if (!parameters.Has(key)) return std::nullopt;
    const double value = parameters.Member(key).Member("value").Number();
    active.values.push_back(std::clamp(value, parameter.lower, parameter.upper));
  }
  return active;
}

// Why an experiment along its DOF alone cannot be planned for it; empty if it can.
std::string WhyNotPlanned(const EffectInfo& info) {
  if (info.has_partner()) return "it needs another DOF to move";
  if (info.needs_pose) return "it shows in poses alone";
  if (info.scope == Scope::kRun && info.depends_on_time) {
    return "it belongs to one run: any new run tells";
  }
  return "";
}

// The place of the effect that a cause names among the model's.
int IndexOf(const ExtendedModel& model, const std::string& effect_name) {
  const auto found =
      std::find_if(model.effects.begin(), model.effects.end(), [&](const ActiveEffect& active) {
        return active.effect->info().name == effect_name;
      });
  return static_cast<int>(found - model.effects.begin());
}

void AddAlternatives(const JsonValue& cause,
                     const std::vector<JsonValue>& candidates,
                     const FittedModel& fitted,
                     OpenCauses* open) {
  const ExtendedModel leader = fitted.Extended();
  const int replaced = IndexOf(leader, cause.Member("effect").Text());
  if (replaced == std::ssize(leader.effects)) return;
  for (const std::string& label : cause.Member("alternatives").Texts()) {
    std::optional<ActiveEffect> effect;
    for (const JsonValue& candidate : candidates) {
      if (candidate.Member("label").Text() != label) continue;
      effect = EffectOfCandidate(candidate, fitted.dof);
    }
    std::string why = effect ? WhyNotPlanned(effect->effect->info()) : "it was not fitted";
    ExtendedModel rival = WithoutEffect(leader, replaced);
    if (effect) rival = WithEffect(rival, *effect);
    if (const std::string problem = ProblemWith(rival.effects); why.empty() && !problem.empty()) {
      why = "the model then " + problem;
    }
    if (!why.empty()) {
      open->left_out.push_back(fmt::format("{} is left out: {}.", label, why));
      continue;
    }
    open->rivals.push_back({label, std::move(rival)});
  }
}

}  // namespace

std::vector<JsonValue> AmbiguousCauses(const JsonValue& file) {
  const auto verdict = file.MemberIfThere("verdict");
  if (!verdict || verdict->Text() != "ambiguous") return {};
  return file.Member("causes").List();
}

OpenCauses ReadOpenCauses(const std::string& name,
                          std::string_view text,
                          const FittedModel& fitted) {
  OpenCauses open;
  const JsonValue file = JsonValue::Parse(name, text);
  const std::vector<JsonValue> causes = AmbiguousCauses(file);
  if (causes.empty()) return open;
  const double scatter = file.NumberIfThere("noise_nmae") * fitted.train.mae / fitted.train.nmae;
  open.noise = fitted.train.mae > kMuchMoreThanScatter * scatter ? fitted.train.mae : scatter;
  const std::vector<JsonValue> candidates = file.Member("candidates").List();
  std::string leader;
  for (const JsonValue& cause : causes) {
    leader += (leader.empty() ? "" : " + ") + cause.Member("effect").Text();
    AddAlternatives(cause, candidates, fitted, &open);
  }
  if (!open.rivals.empty()) open.rivals.insert(open.rivals.begin(), {leader, fitted.Extended()});
  return open;
}

}  // namespace fathom
