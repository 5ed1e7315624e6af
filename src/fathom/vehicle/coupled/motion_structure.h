// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Which numbers of a coupled model are free: what --structure says.
struct MotionStructure {
  std::vector<Dof> dofs;           // in the order of Dof, each once
  std::vector<FreeEntry> entries;  // each once
  bool coriolis = false;           // whether C(nu) acts; it has no numbers of its own
};

// The standard structures, each but the last with all of the one before. Off the diagonal they free
// what a vehicle with a port and a starboard side alike has: surge, heave and pitch couple, and
// sway, roll and yaw; docs/coupled.md. kLopsided is kSymmetric with all other pairs.
enum class StandardStructure {
  kDiagonal,   // inertia and both dampings of each DOF, righting moments of roll and pitch, net
               // buoyancy in heave, an offset in all others
  kCoriolis,   // C(nu)
  kLift,       // of a vehicle with fins, whose hull is slender: forces that grow with u v, u r, u w
               // and u q, and quadratic damping off the diagonal
  kSymmetric,  // inertia off the diagonal
  kFull,       // linear damping off the diagonal, i.j and j.i each with a number of its own
  kLopsided,   // all of the inertia and no such damping: of a vehicle whose two sides differ
};

// "diagonal", "coriolis", "lift", "symmetric", "full", "lopsided".
std::string_view Name(StandardStructure structure);
std::optional<StandardStructure> StandardStructureFromName(std::string_view name);

// A fin, as a structure sees it.
struct StructureFin {
  std::string name;
  bool is_force_known = false;  // else it is free
  bool is_in_race = false;      // what that adds is then free from kLift on
};

// With `fins` from kLift on as said there. `gains`: thrusters and shafts whose thrust is not known,
// free in all of them.
MotionStructure StructureOf(StandardStructure standard,
                            const std::vector<Dof>& dofs,
                            const std::vector<StructureFin>& fins = {},
                            const std::vector<std::string>& gains = {});

// The DOFs in blocks that move independently of each other, each in the order of Dof, the blocks in
// that of their first. Joined are the two DOFs of an entry, those that C(nu) multiplies, all where
// there are fins, and through g(eta) those that the attitude acts on with those that turn the
// vehicle. `measured`: of DOFs that are not modelled, those that move nonetheless. Numbers of
// `held` other than 0 count as entries do.
std::vector<std::vector<Dof>> BlocksOf(const MotionStructure& structure,
                                       const std::vector<Dof>& measured = {},
                                       const CoupledModel& held = {});

}  // namespace fathom
