// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/time_interval.h"
#include "fathom/findings/excitation.h"
#include "fathom/findings/finding.h"
#include "fathom/identification/identification.h"
#include "fathom/log/held_command.h"
#include "fathom/log/log.h"
#include "fathom/signal/signals.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// One file of a log.
struct StreamSummary {
  std::string file;  // "command.csv"
  std::size_t rows = 0;
  double first = 0.0, last = 0.0;  // stamps [s]
  double rate = 0.0;               // by the median step [Hz]
  double longest_gap = 0.0;        // between two rows [s]
};

// What is to be known of one DOF before it is fitted.
struct DofCheckup {
  Dof dof = Dof::kSurge;
  std::string why_not;  // it cannot be identified; empty: it can
  std::vector<Finding> findings;
  bool decays =
      false;  // nothing drives it, and a free decay tells its damping: a finding says what

  // Where it can be identified by its command, of the best source that the log has:
  HeldCommand command;
  std::optional<Signals> signals;
  Excitation excitation;
  std::optional<Identification> model;  // by output error; how well its parameters are known
};

struct CheckUpOptions {
  std::optional<Dof> dof = {};  // only that one, or what a single CSV is of

  // What else a command names to read the log as it was read, for the commands that are proposed:
  // " --held_out=240:300".
  std::string data_flags = {};
};

// What is to be known of a log before any fit; docs/check.md.
struct LogCheckup {
  Log log;               // as it was opened
  CheckUpOptions asked;  // what was asked for
  std::vector<StreamSummary> streams;
  std::vector<Finding> findings;  // of no single DOF
  std::vector<DofCheckup> dofs;   // those that log.yaml names, else those that are commanded
};

// Such a log has no place for keys.
bool IsSingleCsv(const Log& log);

// Where a key of a log folder is written: "log.yaml", or what that is made from.
std::string PlaceOfKeys(const Log& log);

// How a proposed command names the log: "--log=run.csv --held_out=240:300".
std::string LogFlags(const Log& log, const CheckUpOptions& options);

// Looks at a log: all checks of the library `check`, and for each DOF how well a fit by output
// error knows the parameters. It may lack the command or the motion.
LogCheckup CheckUp(Log log, const CheckUpOptions& options);

// The same of a log as OpenLog() opens it, which may throw InputError.
LogCheckup CheckUp(const std::filesystem::path& path, std::optional<Dof> dof);

// All findings, those of the log and of its DOFs.
std::vector<Finding> AllFindings(const LogCheckup& checkup);

// Whether one of them is a warning.
bool HasRed(const LogCheckup& checkup);

}  // namespace fathom
