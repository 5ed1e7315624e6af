// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/c_thrust.h"

#include "fathom/exporting/c_functions.h"
#include "fathom/exporting/comment_text.h"
#include "fathom/exporting/format_features.h"

#include <fmt/format.h>

namespace fathom {
namespace {

// Held in C, and of the thrust.
bool IsHeldHere(const ExportEffect& effect) {
  const ExportFeature feature = FeatureOf(effect);
  return feature != ExportFeature::kDragEffects &&
         Held(ExportFormat::kC, feature).how != HeldFeature::How::kLeftOut;
}

// f behind the thrusters, from f before them.
std::string Statement(const ExportEffect& effect, const std::string& name) {
  const std::string macro = MacroOfEffect(effect, 0, name);
  if (effect.name == "thrust_dead_zone") {
    return fmt::format("  f = f > {0} ? f - {0} : f < -{0} ? f + {0} : 0.0;\n", macro);
  }
  if (effect.name == "thrust_saturation") {
    return fmt::format("  f = f > {0} ? {0} : f < -{0} ? -{0} : f;\n", macro);
  }
  if (effect.name == "thrust_asymmetry") {
    return fmt::format("  f = f < 0.0 ? f * (1.0 - {}) : f;\n", macro);
  }
  if (effect.name == "thruster_lag") {
    return fmt::format(
        "  f = {}_lag(f, {}, h, &thrusters->force[{}]);\n", name, macro, Index(effect.dof));
  }
  return "";  // a delay, which the caller makes
}

std::string Lag(const std::string& name) {
  return fmt::format(
      "/* T df/dt = target - f from *force, over h [s]: its mean, *force at the end. */\n"
      "static inline double {0}_lag(double target, double T, double h, double *force) {{\n"
      "  const double miss = *force - target;\n"
      "  double kept;\n"
      "  if (T < 1e-3 * h) {{\n"
      "    *force = target;\n"
      "    return target + miss * T / h;\n"
      "  }}\n"
      "  kept = exp(-h / T);\n"
      "  *force = target + miss * kept;\n"
      "  return target + miss * (1.0 - kept) * T / h;\n"
      "}}\n"
      "\n",
      name);
}

}  // namespace

std::string CThrust(const ExportModel& model, const std::string& name) {
  std::string macros, statements;
  for (const Dof dof : kAllDofs) {
    std::string of_dof;
    for (const ExportEffect& effect : model.effects) {
      if (effect.dof != dof || !IsHeldHere(effect)) continue;
      macros += MacrosOfEffect(effect, name);
      of_dof += Statement(effect, name);
    }
    if (of_dof.empty()) continue;
    statements += fmt::format("  f = command[{0}];\n{1}  tau[{0}] = f;\n", Index(dof), of_dof);
  }
  const bool lags = statements.find("_lag(") != std::string::npos || !model.model.fin_lag.empty();
  return macros + (macros.empty() ? "" : "\n") +
         fmt::format(
             "/* What the thrusters give. Begin with {{{{0}}}}. */\n"
             "typedef struct {{\n"
             "  double force[6]; /* [N], [N m] */\n"
             "}} {}_thrusters;\n"
             "\n",
             name) +
         (lags ? Lag(name) : "") +
         fmt::format(
             "/* tau, the mean over the next h [s], of a command that is held so long: for "
             "{0}_step(). "
             "*/\n"
             "static inline void {0}_thrust(const double command[6], double h, {0}_thrusters "
             "*thrusters,\n"
             "                              double tau[6]) {{\n"
             "{1}"
             "  int i;\n"
             "  (void)h;\n"
             "  (void)thrusters;\n"
             "  for (i = 0; i < 6; ++i) tau[i] = command[i];\n"
             "{2}"
             "}}\n\n",
             name,
             statements.empty() ? "" : "  double f;\n",
             statements);
}

}  // namespace fathom
