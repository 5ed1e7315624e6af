// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/next_steps.h"

#include "fathom/diagnosis/report/cause_text.h"
#include "fathom/vehicle/model_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// What to do about each is told of no more alternatives than this: with many of them the
// experiment comes first.
constexpr std::size_t kMostAdvised = 4;

}  // namespace

std::vector<std::string> NextSteps(const Diagnosis& diagnosis) {
  std::vector<std::string> steps;
  if (!diagnosis.causes.empty() && diagnosis.held_out_gain_low <= 0.0) {
    steps.push_back(
        "The data held out do not confirm what is named here: see whether another log names it "
        "too before you act on it.");
  }
  for (const Cause& cause : diagnosis.causes) {
    const ActiveEffect& active = EffectOfCause(diagnosis, cause);
    const EffectInfo& info = active.effect->info();
    const std::string label = LabelOf(info, active.setting);
    const std::vector<Alternative> alternatives = AlternativesOf(cause);
    if (alternatives.empty()) {
      steps.push_back(fmt::format("{}: {}", label, info.advice));
    } else {
      steps.push_back(fmt::format("Find out first whether it is {} or {}. {}",
                                  label,
                                  AnyOf(LabelsOf(alternatives)),
                                  ToDecide(cause)));
    }
    if (!alternatives.empty() && alternatives.size() <= kMostAdvised) {
      steps.push_back(fmt::format("If it is {}: {}", label, info.advice));
      for (const Alternative& alternative : alternatives) {
        steps.push_back(
            fmt::format("If it is {}: {}", alternative.label, alternative.effect->info().advice));
      }
    }
    if (info.scope == Scope::kRun) {
      steps.push_back(fmt::format(
          "{} belongs to {}: fathom_simulate leaves it out on any other log.",
          label,
          active.setting.log.empty() ? "this run" : fmt::format("{} alone", active.setting.log)));
    }
  }
  if (diagnosis.verdict == Verdict::kUnexplained) {
    steps.push_back(
        "Look at what the missing force follows: something that was not logged, a mechanism of "
        "your "
        "own (docs/adding_an_effect.md), or slow forces of the water itself.");
  }
  if (diagnosis.verdict == Verdict::kConsistent) {
    steps.push_back(
        "Use the model within the speeds and commands of this data. What they did not excite they "
        "cannot show: an experiment of another kind is the test.");
  }
  return steps;
}

}  // namespace fathom
