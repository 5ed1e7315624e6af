// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fathom {

// What fathom_plan is asked for of a model of several DOFs.
struct CoupledPlanFlags {
  std::string model;    // its file, or that of a verdict
  std::string limits;   // the file; it must be given
  std::string dofs;     // to command, comma-separated; empty: those that the limits name
  double duration = 0;  // [s]; NaN: the limits file's
  std::uint64_t seed = 1;
  std::string vehicle;     // the file of one with thrusters; empty: none
  double voltage = 0.0;    // of their supply [V]; NaN: that of their tables, where these hold one
  std::string out;         // a folder; empty: none
  std::string report;      // a page to be written; empty: none
  std::vector<Log> flown;  // of the vehicle, beside what the model was fitted to
};

// Plans, prints and writes: docs/plan.md, "Several degrees of freedom". Returns the exit code: 2
// where no command keeps the limits. Throws InputError for flags and files that cannot be used.
int RunCoupledPlan(const CoupledPlanFlags& flags);

// Throws InputError unless a duration is one that is planned [s]: 5 to 3600.
void RequirePlannableDuration(double duration);

}  // namespace fathom
