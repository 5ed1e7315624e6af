// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/c_header.h"

#include "fathom/exporting/c_command.h"
#include "fathom/exporting/c_functions.h"
#include "fathom/exporting/c_pulses.h"
#include "fathom/exporting/c_thrust.h"
#include "fathom/exporting/comment_text.h"
#include "fathom/exporting/format_features.h"
#include "fathom/vehicle/thruster.h"

#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::string Guard(const std::string& name) { return fmt::format("FATHOM_MODEL_{}_H", name); }

std::string Head(const ExportModel& model,
                 const ExportTarget& target,
                 const std::vector<std::string>& remarks) {
  return fmt::format(
      "/* {0}\n"
      " *\n"
      " *   M dnu/dt + C(nu) nu + D(nu) nu + g(eta) + o = tau\n"
      " *\n"
      " * nu   velocities u v w p q r, body frame: x forward, y starboard, z down [m/s], [rad/s]\n"
      " * eta  attitude world_from_body as a quaternion x y z w, and position; world: "
      "north-east-down\n"
      " * tau  forces and moments about the body's origin [N], [N m]\n"
      " *\n"
      " * Symbols are those of Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control.\n"
      " * C99; link with the mathematical library (-lm).\n"
      " */\n"
      "#ifndef {1}\n"
      "#define {1}\n"
      "\n"
      "#include <math.h>\n"
      "\n",
      fmt::join(HeadLines(model, target, remarks), "\n * "),
      Guard(target.name));
}

// "fin rudder, ", whose number a macro cannot name.
std::string OwnerOf(const FreeEntry& entry) {
  if (entry.actuator.empty()) return "";
  const bool is_thrust = entry.kind == FreeEntry::Kind::kThrustGain;
  return fmt::format("{} {}, ", is_thrust ? "thruster" : "fin", CommentText(entry.actuator));
}

std::string Parameters(const ExportModel& model, const std::string& name) {
  std::string text;
  for (const ExportNumber& number : model.numbers) {
    const std::string literal = LiteralOf(number.value);
    text += fmt::format("#define {} {} /* {}{} */\n",
                        MacroOf(model, number.entry, name),
                        number.value < 0.0 ? "(" + literal + ")" : literal,
                        OwnerOf(number.entry),
                        CommentOn(number));
  }
  return text + "\n";
}

// The modelled DOFs by their indices, "0, 1, 5".
std::string Indices(const std::vector<Dof>& dofs) {
  std::vector<int> indices;
  indices.reserve(dofs.size());
  for (const Dof dof : dofs) indices.push_back(Index(dof));
  return fmt::to_string(fmt::join(indices, ", "));
}

std::string State(const std::string& name) {
  return fmt::format(
      "/* Where the vehicle is and how it moves. Begin with attitude = {{0, 0, 0, 1}}: level, to "
      "the "
      "north.\n"
      " */\n"
      "typedef struct {{\n"
      "  double nu[6];       /* u v w p q r [m/s], [rad/s] */\n"
      "  double attitude[4]; /* world_from_body: x y z w, length 1 */\n"
      "  double position[3]; /* north east down [m] */\n"
      "}} {}_state;\n"
      "\n",
      name);
}

std::string WrenchAndAcceleration(const ExportModel& model,
                                  const CCommand& command,
                                  const std::string& name) {
  const bool is_of_velocity = !command.text.empty();
  return fmt::format(
      "/* The wrench of the water and the weight at a state: -(C(nu) nu + D(nu) nu + g(eta) + o)\n"
      " * [N], [N m]. */\n"
      "static inline void {0}_wrench(const {0}_state *state, double wrench[6]) {{\n"
      "  double coriolis[6], damping[6], restoring[6], offset[6];\n"
      "  int i;\n"
      "  {0}_coriolis(state->nu, coriolis);\n"
      "  {0}_damping(state->nu, damping);\n"
      "  {0}_restoring(state->attitude, restoring);\n"
      "  {0}_offset(offset);\n"
      "  for (i = 0; i < 6; ++i) {{\n"
      "    wrench[i] = -(coriolis[i] + damping[i] + restoring[i] + offset[i]);\n"
      "  }}\n"
      "}}\n"
      "\n"
      "/* dnu/dt under {4}, by Cholesky's factors of the modelled part of M. The others are 0. */\n"
      "static inline void {0}_acceleration(const {0}_state *state, {3},\n"
      "                                    double nu_dot[6]) {{\n"
      "  static const int dof[{1}] = {{{2}}};\n"
      "  double M[6][6], L[{1}][{1}], y[{1}], wrench[6]{5};\n"
      "  int i, j, k;\n"
      "{6}"
      "  {0}_inertia(M);\n"
      "  {0}_wrench(state, wrench);\n"
      "  for (i = 0; i < 6; ++i) nu_dot[i] = 0.0;\n"
      "  for (i = 0; i < {1}; ++i) {{\n"
      "    for (j = 0; j <= i; ++j) {{\n"
      "      L[i][j] = M[dof[i]][dof[j]];\n"
      "      for (k = 0; k < j; ++k) L[i][j] -= L[i][k] * L[j][k];\n"
      "      L[i][j] = i == j ? sqrt(L[i][i]) : L[i][j] / L[j][j];\n"
      "    }}\n"
      "  }}\n"
      "  for (i = 0; i < {1}; ++i) {{\n"
      "    y[i] = tau[dof[i]] + wrench[dof[i]];\n"
      "    for (k = 0; k < i; ++k) y[i] -= L[i][k] * y[k];\n"
      "    y[i] /= L[i][i];\n"
      "  }}\n"
      "  for (i = {1} - 1; i >= 0; --i) {{\n"
      "    for (k = i + 1; k < {1}; ++k) y[i] -= L[k][i] * y[k];\n"
      "    y[i] /= L[i][i];\n"
      "    nu_dot[dof[i]] = y[i];\n"
      "  }}\n"
      "}}\n"
      "\n",
      name,
      model.model.dofs.size(),
      Indices(model.model.dofs),
      command.parameter,
      is_of_velocity ? "a command" : "tau",
      is_of_velocity ? ", tau[6]" : "",
      is_of_velocity ? fmt::format("  {}_command_forces(state->nu, command, tau);\n", name) : "");
}

std::string RateAndStep(const CCommand& command, const std::string& name) {
  return fmt::format(
      "/* The rate of a state under {3}. */\n"
      "static inline void {0}_rate(const {0}_state *state, {2},\n"
      "                            {0}_state *rate) {{\n"
      "  const double *v = state->nu, *omega = state->nu + 3, *q = state->attitude;\n"
      "  double t[3];\n"
      "  {0}_acceleration(state, {1}, rate->nu);\n"
      "  rate->attitude[0] = 0.5 * (q[3] * omega[0] + q[1] * omega[2] - q[2] * omega[1]);\n"
      "  rate->attitude[1] = 0.5 * (q[3] * omega[1] + q[2] * omega[0] - q[0] * omega[2]);\n"
      "  rate->attitude[2] = 0.5 * (q[3] * omega[2] + q[0] * omega[1] - q[1] * omega[0]);\n"
      "  rate->attitude[3] = -0.5 * (q[0] * omega[0] + q[1] * omega[1] + q[2] * omega[2]);\n"
      "  t[0] = 2.0 * (q[1] * v[2] - q[2] * v[1]);\n"
      "  t[1] = 2.0 * (q[2] * v[0] - q[0] * v[2]);\n"
      "  t[2] = 2.0 * (q[0] * v[1] - q[1] * v[0]);\n"
      "  rate->position[0] = v[0] + q[3] * t[0] + q[1] * t[2] - q[2] * t[1];\n"
      "  rate->position[1] = v[1] + q[3] * t[1] + q[2] * t[0] - q[0] * t[2];\n"
      "  rate->position[2] = v[2] + q[3] * t[2] + q[0] * t[1] - q[1] * t[0];\n"
      "}}\n"
      "\n"
      "/* state = from + h rate. */\n"
      "static inline void {0}_advance(const {0}_state *from, const {0}_state *rate, double h,\n"
      "                               {0}_state *state) {{\n"
      "  int i;\n"
      "  for (i = 0; i < 6; ++i) state->nu[i] = from->nu[i] + h * rate->nu[i];\n"
      "  for (i = 0; i < 4; ++i) state->attitude[i] = from->attitude[i] + h * rate->attitude[i];\n"
      "  for (i = 0; i < 3; ++i) state->position[i] = from->position[i] + h * rate->position[i];\n"
      "}}\n"
      "\n"
      "/* Moves a state on by h [s] under a {1} that holds: the classical Runge-Kutta scheme. Take "
      "h a\n"
      " * quarter of the quickest time constant at most, and 0.05 s where you do not know it. DOFs "
      "that\n"
      " * are not modelled keep the velocity that you set. */\n"
      "static inline void {0}_step({0}_state *state, {2}, double h) {{\n"
      "  {0}_state rate[4], stage, sum;\n"
      "  double length;\n"
      "  int i;\n"
      "  {0}_rate(state, {1}, &rate[0]);\n"
      "  {0}_advance(state, &rate[0], 0.5 * h, &stage);\n"
      "  {0}_rate(&stage, {1}, &rate[1]);\n"
      "  {0}_advance(state, &rate[1], 0.5 * h, &stage);\n"
      "  {0}_rate(&stage, {1}, &rate[2]);\n"
      "  {0}_advance(state, &rate[2], h, &stage);\n"
      "  {0}_rate(&stage, {1}, &rate[3]);\n"
      "  {0}_advance(&rate[0], &rate[1], 2.0, &sum);\n"
      "  {0}_advance(&sum, &rate[2], 2.0, &sum);\n"
      "  {0}_advance(&sum, &rate[3], 1.0, &sum);\n"
      "  {0}_advance(state, &sum, h / 6.0, state);\n"
      "  length = 0.0;\n"
      "  for (i = 0; i < 4; ++i) length += state->attitude[i] * state->attitude[i];\n"
      "  length = sqrt(length);\n"
      "  for (i = 0; i < 4; ++i) state->attitude[i] /= length;\n"
      "}}\n"
      "\n",
      name,
      command.argument,
      command.parameter,
      command.text.empty() ? "tau" : "a command");
}

// B(kappa) T; empty without thrusters.
std::string ForcesOfThrusters(const ExportModel& model, const ExportTarget& target) {
  if (!target.vehicle || target.vehicle->thrusters.empty()) return "";
  const std::vector<Thruster>& thrusters = target.vehicle->thrusters;
  const auto allocation = AllocationMatrix(thrusters);
  std::vector<std::string> names;
  names.reserve(thrusters.size());
  for (const Thruster& thruster : thrusters) names.push_back(CommentText(thruster.name));
  std::string text = fmt::format(
      "enum {{ {0}_num_thrusters = {2} }};\n"
      "\n"
      "/* tau of the thrusts [N] of {1}: B(kappa) T. */\n"
      "static inline void {0}_forces(const double thrust[{2}], double tau[6]) {{\n",
      target.name,
      fmt::join(names, ", "),
      thrusters.size());
  for (int row = 0; row < 6; ++row) {
    std::string sum;
    for (std::size_t k = 0; k < thrusters.size(); ++k) {
      const double push = allocation(row, static_cast<Eigen::Index>(k));
      if (push == 0.0) continue;
      const bool has_gain = model.model.thrust_gain.contains(thrusters[k].name);
      sum += fmt::format(
          "{}{} * thrust[{}]{}",
          sum.empty() ? "" : " +\n           ",
          LiteralOf(push),
          k,
          has_gain ? " * " + MacroOf(model, ThrustGainEntry(thrusters[k].name), target.name) : "");
    }
    text += fmt::format("  tau[{}] = {};\n", row, sum.empty() ? "0.0" : sum);
  }
  return text + "}\n\n";
}

}  // namespace

ExportedFile CHeader(const ExportModel& model, const ExportTarget& target) {
  ExportedFile file;
  file.remarks = RemarksOn(ExportFormat::kC, model, target);
  const std::string& name = target.name;
  const CCommand command = CommandInC(model, target);
  file.text = Head(model, target, file.remarks) + Parameters(model, name) + State(name) +
              CInertia(model, name) + CCoriolis(model, name) + CDamping(model, name) +
              CRestoring(model, name) + COffset(model, name) + command.text +
              WrenchAndAcceleration(model, command, name) + RateAndStep(command, name) +
              CThrust(model, name) + CFinAngles(model, target) + ForcesOfThrusters(model, target) +
              CThrustOfPulse(target) + "#endif\n";
  return file;
}

}  // namespace fathom
