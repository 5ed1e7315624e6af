// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace fathom {

// What fathom_plan --ordinary is asked for beside the flags of logs.
struct OrdinaryPlanFiles {
  std::string model;   // of one DOF; empty: the logs' own fit by output error
  std::string json;    // to be written; empty: none
  std::string report;  // likewise
};

// Says which stretches of --log tell the parameters, and what to log: docs/plan.md, "Ordinary
// dives". Returns the exit code: 2 where the logs give no model, or no stretch tells all
// parameters. Throws InputError for flags and files that cannot be used.
int RunOrdinaryPlan(const OrdinaryPlanFiles& files);

}  // namespace fathom
