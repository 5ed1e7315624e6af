// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/next_steps.h"

#include "fathom/base/interval95.h"
#include "fathom/diagnosis/report/cause_text.h"
#include "fathom/diagnosis/report/large_residual.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// What to do about each is told of no more alternatives than this: with many of them the
// experiment comes first.
constexpr std::size_t kMostAdvised = 4;

// Of the damping of the model that is to be used, where its interval reaches down to 0.
std::vector<std::string> OpenDamping(const Diagnosis& diagnosis) {
  std::vector<std::string> open;
  const ParameterVector values = ToVector(diagnosis.extended.model.baseline);
  for (const int i : {kQuadraticDamping, kLinearDamping}) {
    const double reach = kStdsOf95 * std::sqrt(diagnosis.extended.covariance(i, i));
    if (!(reach >= values[i])) continue;
    std::string name(kParameterInfo[i].name);
    std::ranges::replace(name, '_', ' ');
    open.push_back(fmt::format("{} (0 to {:.2g} {})",
                               name,
                               values[i] + reach,
                               UnitText(ParameterUnit(i, diagnosis.dof, diagnosis.force_unit))));
  }
  return open;
}

std::string UseOfConsistent(const Diagnosis& diagnosis) {
  const auto missed = LargeResidual(diagnosis);
  if (!missed) {
    return "Use the model within the speeds and commands of these data. They cannot show what they "
           "did not excite; test the model with another kind of experiment.";
  }
  return fmt::format(
      "Do not use the model as it is: simulated from the command alone it misses up to {:.0f} % of "
      "the motion, and nothing that was logged says why. Log what may push the vehicle besides "
      "(water, tether, other axes), or drive harder, so that the motion stands out from it, and "
      "diagnose again.",
      100.0 * *missed);
}

}  // namespace

std::vector<std::string> NextSteps(const Diagnosis& diagnosis) {
  std::vector<std::string> steps;
  const bool is_open = AreUnconfirmed(diagnosis);
  if (is_open) {
    const bool is_one = diagnosis.causes.size() == 1;
    steps.push_back(
        fmt::format("The held-out data do not confirm {}: use the model without {} (that of "
                    "fathom_identify) until another log names {} too.",
                    is_one ? "this cause" : "these causes",
                    is_one ? "it" : "them",
                    is_one ? "it" : "them"));
  }
  for (const Cause& cause : diagnosis.causes) {
    const ActiveEffect& active = EffectOfCause(diagnosis, cause);
    const EffectInfo& info = active.effect->info();
    const std::string label = LabelOf(info, active.setting);
    const std::vector<Alternative> alternatives = AlternativesOf(cause);
    if (alternatives.empty()) {
      steps.push_back(
          fmt::format(fmt::runtime(is_open ? "If another log names {} too: {}" : "{}: {}"),
                      label,
                      AdviceText(diagnosis, cause)));
    } else {
      steps.push_back(fmt::format("First find out whether the cause is {} or {}. {}",
                                  label,
                                  AnyOf(LabelsOf(alternatives)),
                                  ToDecide(cause)));
    }
    if (!alternatives.empty() && alternatives.size() <= kMostAdvised) {
      steps.push_back(fmt::format("If it is {}: {}", label, AdviceText(diagnosis, cause)));
      for (const Alternative& alternative : alternatives) {
        steps.push_back(
            fmt::format("If it is {}: {}", alternative.label, alternative.effect->info().advice));
      }
    }
    if (info.scope == Scope::kRun) {
      steps.push_back(
          fmt::format("{} holds for {} only: fathom_simulate leaves it out on any other log.",
                      label,
                      active.setting.log.empty() ? "this run" : active.setting.log));
    }
  }
  if (diagnosis.is_only_red) {
    steps.push_back("Mend what the red findings name, and diagnose the log again.");
  } else if (diagnosis.is_only_cut) {
    steps.push_back("Let the search go on: fathom_diagnose --effort=4.");
  } else if (diagnosis.verdict == Verdict::kUnexplained) {
    steps.push_back(
        "Check which signal the missing force follows. The cause may be a quantity that was not "
        "logged, an effect outside the catalogue (docs/adding_an_effect.md), or a slow force of "
        "the water.");
  }
  if (diagnosis.verdict == Verdict::kConsistent) {
    steps.push_back(UseOfConsistent(diagnosis));
  }
  if (const std::vector<std::string> open = OpenDamping(diagnosis); !open.empty()) {
    steps.push_back(
        fmt::format("These data leave open the {}. Drive at several steady speeds before the model "
                    "is used at other speeds.",
                    fmt::join(open, " and the ")));
  }
  return steps;
}

}  // namespace fathom
