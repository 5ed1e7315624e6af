// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_hint.h"

#include "fathom/base/input_error.h"
#include "fathom/base/shell_word.h"
#include "fathom/planning/drawn_models.h"
#include "fathom/planning/hinted_command.h"
#include "fathom/planning/open_causes.h"
#include "fathom/planning/plan_request.h"
#include "fathom/vehicle/files/model_file.h"

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kNumModelsTried = 64;

// Whether fathom_plan takes the model, without a limits file.
bool IsPlannable(const FittedModel& fitted, const OpenCauses& open) {
  if (!fitted.range) return false;
  try {
    PlanRequest request;
    request.model = fitted;
    request.limits = LimitsOfLog(*fitted.range);
    request.rivals = open.rivals;
    RequirePlannable(request);
    MeasurementOf(request);
    RandomStream random(request.seed, "planning.models");
    DrawModels(fitted, kNumModelsTried, "", random);
    return request.limits.force > 0.0 && request.limits.speed > 0.0;
  } catch (const InputError&) {
    return false;
  }
}

std::string HintedCommand(const std::string& flag,
                          const std::string& file,
                          const FittedModel& fitted,
                          const OpenCauses& open,
                          const std::string& out) {
  if (!IsPlannable(fitted, open)) return "";
  return fmt::format("fathom_plan --{}={} --duration={:g} --out={}",
                     flag,
                     ShellWord(file),
                     HintedDuration(fitted.train.duration),
                     ShellWord(out));
}

}  // namespace

std::string PlanCommandOfModel(const FittedModel& fitted,
                               const std::string& file,
                               const std::string& out) {
  return HintedCommand("model", file, fitted, {}, out);
}

std::string PlanCommandOfVerdict(std::string_view text, const std::string& file) {
  const FittedModel fitted = ParseModel(file, text);
  const OpenCauses open = ReadOpenCauses(file, text, fitted);
  return open.rivals.empty() ? "" : HintedCommand("verdict", file, fitted, open, "plan");
}

}  // namespace fathom
