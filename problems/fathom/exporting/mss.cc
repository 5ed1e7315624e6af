// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/mss.h"

#include "fathom/exporting/comment_text.h"
#include "fathom/exporting/format_features.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// "M(2,6) = 3.5; M(6,2) = 3.5;", indices from 1.
std::string Assignment(const ExportNumber& number) {
  const int row = Index(number.entry.row) + 1, column = Index(number.entry.column) + 1;
  const std::string value = LiteralOf(number.value);
  switch (number.entry.kind) {
    case FreeEntry::Kind::kInertia:
      return row == column ? fmt::format("M({},{}) = {};", row, row, value)
                           : fmt::format("M({0},{1}) = {2}; M({1},{0}) = {2};", row, column, value);
    case FreeEntry::Kind::kLinearDamping:
      return fmt::format("D_L({},{}) = {};", row, column, value);
    case FreeEntry::Kind::kQuadraticDamping:
      return fmt::format("D_Q({},{}) = {};", row, column, value);
    case FreeEntry::Kind::kLift:
      return fmt::format("L({},{}) = {};", row, column, value);
    case FreeEntry::Kind::kRightingMoment:
      return fmt::format("{} = {};", number.entry.row == Dof::kRoll ? "K_p" : "K_q", value);
    case FreeEntry::Kind::kNetBuoyancy:
      return fmt::format("b = {};", value);
    case FreeEntry::Kind::kOffset:
      return fmt::format("o({}) = {};", row, value);
    case FreeEntry::Kind::kThrustGain:
    case FreeEntry::Kind::kThrustAngle:
    case FreeEntry::Kind::kTimeOffset:
    case FreeEntry::Kind::kThrusterLag:
    case FreeEntry::Kind::kFinForce:
    case FreeEntry::Kind::kFinRace:
    case FreeEntry::Kind::kFinNeutral:
    case FreeEntry::Kind::kFinStuck:
    case FreeEntry::Kind::kFinLag:
    case FreeEntry::Kind::kFinRateLimit:
    case FreeEntry::Kind::kFinStall:
    case FreeEntry::Kind::kEffect:
    case FreeEntry::Kind::kThrusterEffect:
    case FreeEntry::Kind::kCurrent:
    case FreeEntry::Kind::kRunOffset:
      return "";
  }
  return "";
}

std::string Assignments(const ExportModel& model) {
  std::string text;
  for (const ExportNumber& number : model.numbers) {
    const std::string assignment = Assignment(number);
    if (!assignment.empty()) text += fmt::format("{}  % {}\n", assignment, CommentOn(number));
  }
  return text;
}

// The modelled DOFs from 1, "1 2 6".
std::string RowNumbers(const std::vector<Dof>& dofs) {
  std::vector<int> rows;
  rows.reserve(dofs.size());
  for (const Dof dof : dofs) rows.push_back(Index(dof) + 1);
  return fmt::to_string(fmt::join(rows, " "));
}

}  // namespace

ExportedFile MssFunction(const ExportModel& model, const ExportTarget& target) {
  ExportedFile file;
  file.remarks = RemarksOn(ExportFormat::kMss, model, target);
  file.text = fmt::format(
      "function xdot = {0}(x, ui)\n"
      "% {1}\n"
      "%\n"
      "%   M dnu/dt + C(nu) nu + D(nu) nu + g(eta) + o = tau\n"
      "%\n"
      "% x    [u v w p q r, north east down, phi theta psi]' [m/s], [rad/s], [m], [rad];\n"
      "%      body frame: x forward, y starboard, z down\n"
      "% ui   [X Y Z K M N]', the forces and moments tau about the body's origin [N], [N m]\n"
      "% xdot the rate of x; DOFs that are not modelled keep their velocity\n"
      "%\n"
      "% Symbols are those of Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control.\n"
      "\n"
      "M = zeros(6); D_L = zeros(6); D_Q = zeros(6); L = zeros(6); o = zeros(6,1);\n"
      "b = 0; K_p = 0; K_q = 0;\n"
      "{2}"
      "modelled = [{3}];\n"
      "\n"
      "x = x(:); tau = ui(:);\n"
      "nu = x(1:6);\n"
      "phi = x(10); theta = x(11); psi = x(12);\n"
      "\n"
      "% C(nu), of M: nu' C(nu) nu = 0.\n"
      "{4}"
      "D = D_L + D_Q * diag(abs(nu)) + L * nu(1);\n"
      "\n"
      "% The world's down, seen in the body.\n"
      "down = [-sin(theta); cos(theta)*sin(phi); cos(theta)*cos(phi)];\n"
      "g = [b*down; K_p*down(2); -K_q*down(1); 0];\n"
      "\n"
      "force = tau - C*nu - D*nu - g - o;\n"
      "nudot = zeros(6,1);\n"
      "nudot(modelled) = M(modelled,modelled) \\ force(modelled);\n"
      "\n"
      "% deta/dt = J(eta) nu.\n"
      "Rz = [cos(psi) -sin(psi) 0; sin(psi) cos(psi) 0; 0 0 1];\n"
      "Ry = [cos(theta) 0 sin(theta); 0 1 0; -sin(theta) 0 cos(theta)];\n"
      "Rx = [1 0 0; 0 cos(phi) -sin(phi); 0 sin(phi) cos(phi)];\n"
      "T = [1 sin(phi)*tan(theta) cos(phi)*tan(theta)\n"
      "     0 cos(phi) -sin(phi)\n"
      "     0 sin(phi)/cos(theta) cos(phi)/cos(theta)];\n"
      "xdot = [nudot; Rz*Ry*Rx*nu(1:3); T*nu(4:6)];\n"
      "end\n"
      "\n"
      "function S = cross_matrix(a)\n"
      "% S(a) b = a x b.\n"
      "S = [0 -a(3) a(2); a(3) 0 -a(1); -a(2) a(1) 0];\n"
      "end\n",
      target.name,
      fmt::join(HeadLines(model, target, file.remarks), "\n% "),
      Assignments(model),
      RowNumbers(model.model.dofs),
      model.model.coriolis ? "momentum = M*nu;\n"
                             "C = [zeros(3) -cross_matrix(momentum(1:3))\n"
                             "     -cross_matrix(momentum(1:3)) -cross_matrix(momentum(4:6))];\n"
                           : "C = zeros(6);  % the model has none\n");
  return file;
}

}  // namespace fathom
