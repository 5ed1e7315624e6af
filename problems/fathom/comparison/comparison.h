// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/identification/identification.h"
#include "fathom/log/log.h"
#include "fathom/signal/signals.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

struct ComparisonOptions {
  std::vector<Dof> dofs = {};         // empty: those that every log names
  std::vector<Family> families = {};  // empty: all that the log allows
  std::vector<Source> sources = {};   // empty: every source that all logs have
  IdentificationOptions identification = {};
};

// One DOF: every family on every source, measured with one yardstick.
struct DofComparison {
  Dof dof = Dof::kSurge;
  Signals scored;  // what all models of this DOF are scored on

  // Which log each of scored's segments is of; empty where there is one. Several logs may have one
  // clock that starts anew.
  std::vector<size_t> log_of_train = {};
  std::vector<size_t> log_of_held_out = {};

  std::vector<Finding> findings;
  std::vector<std::string> remarks;
  std::vector<Identification> rows;

  bool HasHeldOut() const { return !scored.held_out.empty(); }
};

// Families x sources x DOFs on one log or several: the paper's Table II and Fig. 5, with held-out
// figures and intervals. The joint refinement has one row more, the last: its source is the corners
// in detections.csv, whatever pose.csv holds.
struct Comparison {
  std::string log_name;              // of several: "a, b"
  std::vector<std::string> remarks;  // of the logs' reader
  std::vector<DofComparison> dofs;
};

// Fits every family to all logs together, each with an initial state of its own. Intervals are
// widened by what the logs differ by more than by noise, as by IdentifyFromLogs().
//
// Throws InputError if there is no log, if one lacks what is asked for, if they differ in command
// unit, or if they hold out all of their data. Where no family is asked for and the corners do not
// serve the joint refinement, a remark says why.
Comparison Compare(std::span<const Log> logs, const ComparisonOptions& options = {});

// The DOFs that every log names. Throws InputError if there is none.
std::vector<Dof> CommonDofs(std::span<const Log> logs);

}  // namespace fathom
