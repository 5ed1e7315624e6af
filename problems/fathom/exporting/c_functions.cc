// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/c_functions.h"

#include "fathom/exporting/comment_text.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// The macro of an entry, "0.0" where the model has none.
std::string MacroOrZero(const ExportModel& model, const FreeEntry& entry, const std::string& name) {
  return HasNumber(model, entry) ? MacroOf(model, entry, name) : "0.0";
}

// What an effect of the drag adds; empty of any other.
std::string DragTerm(const ExportEffect& effect,
                     const ExportModel& model,
                     const std::string& name) {
  const std::string macro = MacroOfEffect(effect, 0, name);
  const int i = Index(effect.dof);
  if (effect.name == "cubic_damping")
    return fmt::format("{0} * nu[{1}] * nu[{1}] * nu[{1}]", macro, i);
  if (effect.name == "coulomb_friction") return fmt::format("{} * tanh(nu[{}] / 0.005)", macro, i);
  if (effect.name == "damping_asymmetry") {
    return fmt::format("(nu[{1}] < 0.0 ? -{0} * {2} * nu[{1}] * nu[{1}] : 0.0)",
                       macro,
                       i,
                       MacroOrZero(model, QuadraticDampingEntry(effect.dof, effect.dof), name));
  }
  return "";
}

// The parts of the force along a row that dampings, lift and effects give.
std::vector<std::string> DampingTerms(const ExportModel& model, Dof row, const std::string& name) {
  std::vector<std::string> terms;
  for (const MacroTerm& term : TermsOf(model, FreeEntry::Kind::kLinearDamping, row, name)) {
    terms.push_back(fmt::format("{} * nu[{}]", term.macro, Index(term.column)));
  }
  for (const MacroTerm& term : TermsOf(model, FreeEntry::Kind::kQuadraticDamping, row, name)) {
    terms.push_back(fmt::format("{0} * fabs(nu[{1}]) * nu[{1}]", term.macro, Index(term.column)));
  }
  for (const MacroTerm& term : TermsOf(model, FreeEntry::Kind::kLift, row, name)) {
    terms.push_back(fmt::format("{0} * nu[0] * nu[{1}]", term.macro, Index(term.column)));
  }
  for (const ExportEffect& effect : model.effects) {
    const std::string term = DragTerm(effect, model, name);
    if (effect.dof == row && !term.empty()) terms.push_back(term);
  }
  return terms;
}

// The numbers of effects of the drag.
std::string DragMacros(const ExportModel& model, const std::string& name) {
  std::string macros;
  for (const ExportEffect& effect : model.effects) {
    if (!DragTerm(effect, model, name).empty()) macros += MacrosOfEffect(effect, name);
  }
  return macros + (macros.empty() ? "" : "\n");
}

}  // namespace

bool HasNumber(const ExportModel& model, const FreeEntry& entry) {
  return std::any_of(model.numbers.begin(), model.numbers.end(), [&](const ExportNumber& number) {
    return number.entry == entry;
  });
}

std::string InCapitals(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    if (c == '.') c = '_';
  }
  return text;
}

std::string MacroOf(const ExportModel& model, const FreeEntry& entry, const std::string& name) {
  if (entry.actuator.empty()) return InCapitals(fmt::format("{}_{}", name, NameOf(entry)));
  // An actuator may have any name.
  int place = 0;
  for (const ExportNumber& number : model.numbers) {
    if (number.entry.kind == entry.kind) ++place;
    if (number.entry == entry) break;
  }
  const std::string of_one = NameOf(entry);
  return InCapitals(fmt::format("{}_{}_{}", name, of_one.substr(0, of_one.find('.')), place));
}

std::string MacroOfEffect(const ExportEffect& effect, std::size_t k, const std::string& name) {
  return InCapitals(
      fmt::format("{}_{}_{}_{}", name, Name(effect.dof), effect.name, effect.values[k].name));
}

std::string MacrosOfEffect(const ExportEffect& effect, const std::string& name) {
  std::string macros;
  for (std::size_t k = 0; k < effect.values.size(); ++k) {
    macros += fmt::format("#define {} ({}) /* {} */\n",
                          MacroOfEffect(effect, k, name),
                          LiteralOf(effect.values[k].value),
                          CommentOn(effect.values[k], effect.log));
  }
  return macros;
}

std::vector<MacroTerm> TermsOf(const ExportModel& model,
                               FreeEntry::Kind kind,
                               Dof row,
                               const std::string& name) {
  std::vector<MacroTerm> terms;
  if (!IsModelled(model, row)) return terms;  // no equation
  for (const ExportNumber& number : model.numbers) {
    if (number.entry.kind != kind || number.entry.row != row) continue;
    terms.push_back({number.entry.column, MacroOf(model, number.entry, name)});
  }
  return terms;
}

std::string CInertia(const ExportModel& model, const std::string& name) {
  std::string text = fmt::format(
      "/* M: rigid body plus added mass, about the body's origin. */\n"
      "static inline void {}_inertia(double M[6][6]) {{\n"
      "  int i, j;\n"
      "  for (i = 0; i < 6; ++i) {{\n"
      "    for (j = 0; j < 6; ++j) M[i][j] = 0.0;\n"
      "  }}\n",
      name);
  for (const ExportNumber& number : model.numbers) {
    if (number.entry.kind != FreeEntry::Kind::kInertia) continue;
    const int i = Index(number.entry.row), j = Index(number.entry.column);
    const std::string both = i == j ? "" : fmt::format("M[{}][{}] = ", j, i);
    text += fmt::format("  M[{}][{}] = {}{};\n", i, j, both, MacroOf(model, number.entry, name));
  }
  return text + "}\n\n";
}

std::string CCoriolis(const ExportModel& model, const std::string& name) {
  std::string text = fmt::format(
      "/* C(nu) nu = (omega x pi_1, v x pi_1 + omega x pi_2), pi = M nu: nu' C(nu) nu = 0. */\n"
      "static inline void {}_coriolis(const double nu[6], double force[6]) {{\n",
      name);
  if (!model.model.coriolis) {
    return text +
           "  int i;\n"
           "  (void)nu; /* the model has none */\n"
           "  for (i = 0; i < 6; ++i) force[i] = 0.0;\n"
           "}\n\n";
  }
  return text + fmt::format(
                    "  double M[6][6], pi[6];\n"
                    "  int i, j;\n"
                    "  {}_inertia(M);\n"
                    "  for (i = 0; i < 6; ++i) {{\n"
                    "    pi[i] = 0.0;\n"
                    "    for (j = 0; j < 6; ++j) pi[i] += M[i][j] * nu[j];\n"
                    "  }}\n"
                    "  force[0] = nu[4] * pi[2] - nu[5] * pi[1];\n"
                    "  force[1] = nu[5] * pi[0] - nu[3] * pi[2];\n"
                    "  force[2] = nu[3] * pi[1] - nu[4] * pi[0];\n"
                    "  force[3] = nu[1] * pi[2] - nu[2] * pi[1] + nu[4] * pi[5] - nu[5] * pi[4];\n"
                    "  force[4] = nu[2] * pi[0] - nu[0] * pi[2] + nu[5] * pi[3] - nu[3] * pi[5];\n"
                    "  force[5] = nu[0] * pi[1] - nu[1] * pi[0] + nu[3] * pi[4] - nu[4] * pi[3];\n"
                    "}}\n\n",
                    name);
}

std::string CDamping(const ExportModel& model, const std::string& name) {
  std::string text = DragMacros(model, name) +
                     fmt::format(
                         "/* D(nu) nu: along i the sum over j of (D_L,ij + D_Q,ij |nu_j| + L_ij u) "
                         "nu_j, and effects. */\n"
                         "static inline void {}_damping(const double nu[6], double force[6]) {{\n",
                         name);
  bool any = false;
  for (const Dof row : kAllDofs) {
    const std::vector<std::string> terms = DampingTerms(model, row, name);
    any = any || !terms.empty();
    text +=
        fmt::format("  force[{}] = {};\n",
                    Index(row),
                    terms.empty() ? "0.0" : fmt::to_string(fmt::join(terms, " +\n             ")));
  }
  if (!any) text += "  (void)nu;\n";
  return text + "}\n\n";
}

std::string CRestoring(const ExportModel& model, const std::string& name) {
  const std::string buoyancy = MacroOrZero(model, NetBuoyancyEntry(), name);
  return fmt::format(
      "/* g(eta): net buoyancy b along the world's down z, seen in the body, and the righting\n"
      " * moments: (b z, K_p z_y, -K_q z_x, 0). */\n"
      "static inline void {0}_restoring(const double attitude[4], double force[6]) {{\n"
      "  const double x = attitude[0], y = attitude[1], z = attitude[2], w = attitude[3];\n"
      "  const double down[3] = {{2.0 * (x * z - w * y), 2.0 * (y * z + w * x),\n"
      "                          w * w + z * z - x * x - y * y}};\n"
      "  force[0] = {1} * down[0];\n"
      "  force[1] = {1} * down[1];\n"
      "  force[2] = {1} * down[2];\n"
      "  force[3] = {2} * down[1];\n"
      "  force[4] = -{3} * down[0];\n"
      "  force[5] = 0.0;\n"
      "}}\n\n",
      name,
      buoyancy,
      MacroOrZero(model, RightingMomentEntry(Dof::kRoll), name),
      MacroOrZero(model, RightingMomentEntry(Dof::kPitch), name));
}

std::string COffset(const ExportModel& model, const std::string& name) {
  std::string text = fmt::format(
      "/* o: an offset of the thrust, or a trim. */\n"
      "static inline void {}_offset(double force[6]) {{\n",
      name);
  for (const Dof row : kAllDofs) {
    text +=
        fmt::format("  force[{}] = {};\n", Index(row), MacroOrZero(model, OffsetEntry(row), name));
  }
  return text + "}\n\n";
}

}  // namespace fathom
