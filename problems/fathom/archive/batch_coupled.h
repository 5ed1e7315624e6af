// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// The usable coupled model of a log, for the joint fit of its dive.
struct BatchCoupled {
  std::string dofs;                          // "surge,sway,yaw"
  bool coriolis = false;                     // whether C(nu) acts in it
  std::vector<std::string> beyond_diagonal;  // entries that a diagonal model does not have
};

// Of a verdict file (fathom_diagnose --dofs); nothing of what is none.
std::optional<BatchCoupled> CoupledInVerdict(const std::string& verdict);

}  // namespace fathom
