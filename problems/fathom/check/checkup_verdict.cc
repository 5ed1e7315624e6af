// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/checkup_verdict.h"

#include "fathom/base/listed.h"
#include "fathom/check/known_parameters.h"
#include "fathom/findings/explain_first.h"
#include "fathom/planning/plan_hint.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::vector<std::string> NamesOf(const std::vector<DofCheckup>& dofs) {
  std::vector<std::string> names;
  for (const DofCheckup& dof : dofs) names.emplace_back(Name(dof.dof));
  return names;
}

// Those that nothing drives, and whose damping a free decay tells.
std::vector<std::string> DecayingDofs(const LogCheckup& checkup) {
  std::vector<std::string> decaying;
  for (const DofCheckup& dof : checkup.dofs) {
    if (dof.decays) decaying.emplace_back(Name(dof.dof));
  }
  return decaying;
}

// Those with a finding of this code.
std::vector<std::string> DofsWith(const std::string& code, const LogCheckup& checkup) {
  std::vector<std::string> dofs;
  for (const DofCheckup& dof : checkup.dofs) {
    if (Has(dof.findings, code)) dofs.emplace_back(Name(dof.dof));
  }
  return dofs;
}

// "quadratic_damping". But the buoyancy, of which a small value is known well enough.
std::vector<std::string> UnknownOf(const LogCheckup& checkup, const DofCheckup& dof) {
  std::vector<std::string> unknown;
  if (!dof.model || !dof.model->is_usable) return unknown;
  for (const int i : {kInertia, kQuadraticDamping, kLinearDamping}) {
    if (HowWellKnown(checkup, dof, i) != "not") continue;
    unknown.emplace_back(kParameterInfo[static_cast<std::size_t>(i)].name);
  }
  return unknown;
}

// The same of all DOFs; with the DOF where there are several.
std::vector<std::string> UnknownParameters(const LogCheckup& checkup, bool of_several_dofs) {
  std::vector<std::string> unknown;
  for (const DofCheckup& dof : checkup.dofs) {
    for (const std::string& name : UnknownOf(checkup, dof)) {
      unknown.push_back(of_several_dofs ? fmt::format("{} of {}", name, Name(dof.dof)) : name);
    }
  }
  return unknown;
}

bool HasSurfaces(const LogCheckup& checkup) { return checkup.log.fins || checkup.log.shafts; }

// Where fins or shafts drive the log, which act in a model of several DOFs alone, or where other
// axes act on one.
std::string CoupledStep(const LogCheckup& checkup, const std::vector<std::string>& dofs) {
  return fmt::format("fathom_identify {} --dofs={} --model=coupled.json",
                     LogFlags(checkup.log, checkup.asked),
                     fmt::join(dofs, ","));
}

// Whether a model of each axis alone is biased, and one of them all is not.
bool TakesCoupledModel(const LogCheckup& checkup) {
  return UsableDofs(checkup).size() > 1 && !DofsWith("other_axes", checkup).empty();
}

}  // namespace

std::vector<std::string> UsableDofs(const LogCheckup& checkup) {
  std::vector<std::string> usable;
  for (const DofCheckup& dof : checkup.dofs) {
    if (dof.model && dof.model->is_usable) usable.emplace_back(Name(dof.dof));
  }
  return usable;
}

std::string Verdict(const LogCheckup& checkup) {
  if (std::string first = ExplainFirst(AllFindings(checkup)); !first.empty()) return first;
  const std::vector<std::string> usable = UsableDofs(checkup);
  if (const std::vector<std::string> decays = DecayingDofs(checkup);
      usable.empty() && !decays.empty()) {
    return fmt::format("Nothing drives this log. Its free decay tells the damping of {}{}.",
                       Listed(decays),
                       DofsWith("free_decay", checkup).empty() ? "" : " by the inertia");
  }
  if (usable.empty() && HasSurfaces(checkup)) {
    return "No model of one DOF comes of this log: its fins or shafts act in one of several.";
  }
  if (usable.empty()) return "Nothing in this log can be identified.";
  const std::vector<std::string> poor = DofsWith("poor_fit", checkup);
  const std::vector<std::string> driven = DofsWith("other_axes", checkup);
  std::vector<std::string> good;
  std::ranges::copy_if(usable, std::back_inserter(good), [&](const std::string& dof) {
    return std::ranges::count(poor, dof) + std::ranges::count(driven, dof) == 0;
  });
  const std::string of_driven =
      driven.empty() ? ""
                     : fmt::format(" Other axes act on {}: a model of one axis alone is biased.",
                                   Listed(driven));
  const std::vector<std::string> unknown = UnknownParameters(checkup, usable.size() > 1);
  if (good.empty() && poor.empty()) {
    return fmt::format(
        "{} can be identified from this log{}.{}",
        Listed(usable),
        unknown.empty() ? "" : fmt::format(", which leaves {} unknown", Listed(unknown)),
        of_driven);
  }
  if (good.empty()) {
    return fmt::format(
        "A model of {} from this log fits poorly.{}{}",
        Listed(poor),
        unknown.empty() ? "" : fmt::format(" The log leaves {} unknown.", Listed(unknown)),
        of_driven);
  }
  return fmt::format(
      "Nothing speaks against a model of {} from this log{}.{}{}",
      Listed(good),
      unknown.empty() ? "" : fmt::format(", but it leaves {} unknown", Listed(unknown)),
      poor.empty() ? "" : fmt::format(" A model of {} fits poorly.", Listed(poor)),
      of_driven);
}

std::string NextStep(const LogCheckup& checkup) {
  const std::string log = LogFlags(checkup.log, checkup.asked);
  const std::optional<Dof> dof = checkup.asked.dof;
  if (HasRed(checkup)) {
    return fmt::format("mend what is red, then fathom_check {}{}",
                       log,
                       dof ? fmt::format(" --dof={}", Name(*dof)) : "");
  }
  // It reads images, which no other flag is about.
  if (Has(checkup.findings, "not_tracked")) return "fathom_track " + LogFlags(checkup.log, {});
  const std::vector<std::string> usable = UsableDofs(checkup);
  if (const std::vector<std::string> decays = DecayingDofs(checkup);
      usable.empty() && !decays.empty()) {
    return fmt::format("fathom_identify {} --dof={}", log, decays[0]);
  }
  if (usable.empty() && HasSurfaces(checkup)) return CoupledStep(checkup, NamesOf(checkup.dofs));
  if (usable.empty()) return "drive what this log lacks, or fit it together with other logs";
  if (TakesCoupledModel(checkup)) return CoupledStep(checkup, usable);
  const std::string step =
      fmt::format("fathom_identify {} --dof={} --model={}.json", log, usable[0], usable[0]);
  if (usable.size() == 1) return step;
  return fmt::format("{}; likewise {}", step, Listed({usable.begin() + 1, usable.end()}));
}

std::vector<std::string> PlanSteps(const LogCheckup& checkup) {
  std::vector<std::string> steps;
  if (HasRed(checkup) || Has(checkup.findings, "not_tracked")) return steps;
  if (TakesCoupledModel(checkup)) return steps;  // there is no model of one DOF then
  std::vector<const DofCheckup*> open;
  for (const DofCheckup& dof : checkup.dofs) {
    if (!UnknownOf(checkup, dof).empty()) open.push_back(&dof);
  }
  for (const DofCheckup* const dof : open) {
    const std::string_view name = Name(dof->dof);
    std::string step = PlanCommandOfModel(dof->model->fitted,
                                          fmt::format("{}.json", name),
                                          open.size() == 1 ? "plan" : fmt::format("plan_{}", name));
    if (!step.empty()) steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace fathom
