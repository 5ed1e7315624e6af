// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/coupled_plan_hint.h"

#include "fathom/base/input_error.h"
#include "fathom/base/shell_word.h"
#include "fathom/coupled_planning/coupled_noise.h"
#include "fathom/coupled_planning/drawn_coupled_models.h"
#include "fathom/coupled_planning/verdict_rivals.h"
#include "fathom/planning/hinted_command.h"
#include "fathom/vehicle/files/coupled_model_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kNumCoupledTried = 64;

// Whether fathom_plan takes the model, with limits of forces alone.
bool IsPlannable(const FittedCoupledModel& fitted) {
  if (fitted.force_unit != "N") return false;
  try {
    CoupledPlanRequest request;
    request.model = fitted;
    CoupledPlan plan;
    SetMeasurement(request, &plan);
    RandomStream random(request.seed, "planning.coupled_models");
    DrawCoupledModels(fitted, kNumCoupledTried, "", random);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

// Of the longest log of a DOF [s].
double DurationOfLog(const FittedCoupledModel& fitted) {
  double longest = 0.0;
  for (const Dof dof : fitted.model.dofs) {
    longest = std::max(longest, fitted.train[static_cast<std::size_t>(Index(dof))].duration);
  }
  return longest;
}

}  // namespace

std::string CoupledPlanCommandOfVerdict(std::string_view text, const std::string& file) {
  const FittedCoupledModel fitted = ParseCoupledModel(file, text);
  if (ReadVerdictRivals(file, text, fitted).pairs.empty() || !IsPlannable(fitted)) return "";
  return fmt::format("fathom_plan --verdict={} --limits=limits.yaml --duration={:g} --out=plan",
                     ShellWord(file),
                     HintedDuration(DurationOfLog(fitted)));
}

}  // namespace fathom
