// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/structure_row.h"
#include "fathom/coupled/unseen_errors.h"
#include "fathom/identification/family.h"
#include "fathom/identification/identification.h"
#include "fathom/log/log.h"

#include <span>
#include <vector>

namespace fathom {

// A row with the unseen errors behind it.
struct ScoredRow {
  StructureRow row;
  UnseenErrors unseen;
};

struct UncoupledRowsOptions {
  std::vector<Dof> dofs;         // in the order of Dof, each once
  std::vector<Family> families;  // of kSignalFamilies
  IdentificationOptions identification = {};
  double window = 20.0;  // of the free runs over training and held-out data [s]
};

// Models of one DOF each, docs/models.md (1), scored as coupled models: a row for each family, and
// of several one more, the best of each DOF. `data` are the logs as coupled fits take them. For the
// unseen errors each model is fitted anew to the training part of each of FoldsOf(data). A row
// lacks the figures of DOFs whose logs do not serve such a model, and is then not usable.
std::vector<ScoredRow> UncoupledRows(std::span<const Log> logs,
                                     std::span<const CoupledData> data,
                                     const UncoupledRowsOptions& options);

}  // namespace fathom
