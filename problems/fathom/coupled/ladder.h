// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/block_fit.h"
#include "fathom/coupled/entry_test.h"

#include <array>
#include <string>
#include <vector>

namespace fathom {

// One structure that was tried.
struct LadderRung {
  std::string name;  // "diagonal", "coriolis", "entries", "symmetric", "full"
  MotionStructure structure;
  CoupledSummary fit;  // of all training data

  // By Index(Dof): free runs of 5 s over data that were not fitted. NaN where a fit failed.
  std::array<double, 6> unseen_nmae;

  // How much nearer its runs over such data are than those of the rung that stood before, a share,
  // and in standard errors.
  double gain = 0.0;
  double gain_in_errors = 0.0;
  bool is_accepted = false;
};

// A number beyond the diagonal model that the data show.
struct NamedEntry {
  FreeEntry entry;
  double value = 0.0;
  double std = 0.0;
  std::vector<FreeEntry> not_told_apart;  // candidates that would do nearly as well
};

struct Ladder {
  std::vector<LadderRung> rungs;
  std::size_t accepted = 0;  // index
  std::vector<NamedEntry> named;
  std::vector<std::string> thrusters_tried;
};

struct LadderOptions {
  CoupledFitOptions fit;

  // Of the single entries that are tried: how likely one that is not there is taken, all
  // candidates together.
  double false_alarm = 0.01;

  std::vector<std::string> thrusters;  // whose gain may be off
};

// Climbs from the diagonal model: C(nu), single entries one after the other as tests ask for them,
// all of the inertia, all of the linear damping. A rung stays if its runs over data that were not
// fitted are nearer: of other logs, or of quarters of a single one; docs/coupled.md.
Ladder ClimbLadder(const CoupledLogs& logs,
                   const std::vector<Dof>& dofs,
                   const LadderOptions& options);

}  // namespace fathom
