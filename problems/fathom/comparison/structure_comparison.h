// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/structure_row.h"
#include "fathom/coupled/coupled_identification.h"
#include "fathom/identification/family.h"
#include "fathom/identification/identification.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

struct StructureComparisonOptions {
  std::vector<Dof> dofs;  // in the order of Dof, each once, one at least

  // Absent: all whose free numbers differ for these DOFs; kLift of logs with fins alone.
  std::optional<std::vector<StandardStructure>> structures = {};
  bool has_auto = true;  // also the structure that ClimbLadder() chooses

  // Of the models of one DOF that stand beside them; of kSignalFamilies.
  std::vector<Family> families = {kSignalFamilies.begin(), kSignalFamilies.end()};
  IdentificationOptions identification = {};

  CoupledFitOptions fit = {};
};

// Structures of a coupled model on one log or several, beside models of one DOF each: all scored
// alike, on the same samples; docs/comparison.md.
struct StructureComparison {
  std::string log_name;  // of several: "a, b"
  std::vector<Dof> dofs;
  double window = std::numeric_limits<double>::quiet_NaN();  // [s]
  std::vector<CoupledData> data;                             // the logs as the fits took them
  std::vector<std::string> remarks;

  std::vector<StructureRow> rows;  // first the models of one DOF each
  std::optional<Ladder> ladder;    // that auto climbed

  // The models of one DOF each to beat: of each DOF that whose unseen errors are the least. Null if
  // a DOF has none.
  const StructureRow* Best() const;

  // What auto chose; without auto, of the usable structures the one whose unseen errors are the
  // least. Null if there is none.
  const StructureRow* Taken() const;
};

// Throws InputError as IdentifyCoupled() does. A fit that does not work does not throw, nor do
// models of one DOF that these logs do not serve: see the rows.
StructureComparison CompareStructures(std::span<const Log> logs,
                                      const StructureComparisonOptions& options);

}  // namespace fathom
