// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/block_fit.h"
#include "fathom/coupled/entry_search.h"
#include "fathom/coupled/unseen_errors.h"

#include <array>
#include <string>
#include <vector>

namespace fathom {

// One structure that was tried.
struct LadderRung {
  // "diagonal", "coriolis", "lift", "thruster", "fin", "entries", "symmetric", "full"
  std::string name;
  MotionStructure structure;
  CoupledSummary fit;  // of all training data

  // By Index(Dof): free runs of 5 s over data that were not fitted. NaN where a fit failed.
  std::array<double, 6> unseen_nmae;

  // Against the rung that stood before: how much nearer its runs over such data are. 0 of the first
  // rung, and where a fit failed.
  UnseenGain gain;
  bool is_accepted = false;
};

struct Ladder {
  std::vector<LadderRung> rungs;
  std::size_t accepted = 0;       // index
  std::vector<NamedEntry> named;  // beyond the diagonal model and C(nu)

  // Structures that were not fitted: no test asks for their numbers together.
  std::vector<std::string> not_asked_for = {};
};

// Climbs from the diagonal model: C(nu), single entries one after the other as tests ask for them,
// all of the inertia, all of the linear damping. A rung stays if its runs over data that were not
// fitted are nearer: FoldsOf(); docs/coupled.md.
Ladder ClimbLadder(const CoupledLogs& logs,
                   const std::vector<Dof>& dofs,
                   const EntrySearchOptions& options);

}  // namespace fathom
