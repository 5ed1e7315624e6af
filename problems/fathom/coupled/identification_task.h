// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_fit_options.h"
#include "fathom/coupled/entry_search.h"
#include "fathom/coupled/structure_ladder.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// Logs as a coupled fit takes them, with what their vehicle file tells it.
struct IdentificationTask {
  CoupledLogs logs;
  std::vector<Dof> dofs;
  CoupledFitOptions fit;                // with the body and what is held
  std::optional<std::string> unit_fin;  // whose force is the unit of all others: nothing known is
};

// The first vehicle file that a log names tells the rigid body, the thrusters, fins and shafts.
// Throws InputError if the logs lack what CoupledDataOf() needs or differ in their command's unit.
IdentificationTask IdentificationTaskOf(std::vector<Log> logs,
                                        const std::vector<Dof>& dofs,
                                        const CoupledFitOptions& fit);

// A structure of the task's DOFs, with these entries free too. Throws InputError where the logs
// have nothing for one of them to be of.
MotionStructure StructureIn(const IdentificationTask& task,
                            StandardStructure standard,
                            const std::vector<FreeEntry>& also_free);

// Where a search among structures may look.
EntrySearchOptions SearchIn(const IdentificationTask& task);

// Why no model can be told, where the speed along some DOFs never changes; else empty.
std::string WhyStill(const IdentificationTask& task);

}  // namespace fathom
