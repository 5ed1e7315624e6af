// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/dives/archive_settings.h"
#include "fathom/archive/dives/walk_archive.h"
#include "fathom/archive/jobs/log_state.h"
#include "fathom/archive/jobs/run_program.h"
#include "fathom/open_log/survey.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// What is done with each log.
struct LogJobOptions {
  std::string families;    // of fathom_compare, comma-separated; empty: all that it has
  std::string weighting;   // of fathom_compare and fathom_identify; empty: their own
  bool diagnose = true;    // run fathom_diagnose too
  std::optional<Dof> dof;  // of single CSV logs
  // Of one coupled model of each log (fathom_diagnose --dofs). Empty: those that the log moves.
  // None: there is no such model.
  std::optional<std::vector<Dof>> coupled_dofs;
  std::filesystem::path pages;  // a folder for the pages of the diagnoses; empty: none
  std::filesystem::path made;   // a folder for the logs that are made of images and recordings
};

// The runs on one DOF of a log.
struct DofRuns {
  Dof dof = Dof::kSurge;
  RunRecord compare;
  std::optional<RunRecord> diagnose;
};

// The run on several DOFs of a log together.
struct CoupledRun {
  std::string dofs;  // JoinedNames()
  RunRecord diagnose;
  std::vector<UndrivenDof> left_out;  // where the batch chose the DOFs
};

struct LogOutcome {
  std::filesystem::path place;  // of the log, or of what was made of it
  std::string path;             // from the archive on, as text
  std::string content;          // of the log
  std::string place_content;    // of what lies at `place`
  std::string made_by;          // the program that made what lies there; empty: it was found
  LogState state = LogState::kOk;
  std::string message;           // why it is not ok
  std::optional<Survey> survey;  // where one could be made
  std::vector<DofRuns> dofs;
  std::optional<CoupledRun> coupled;
  double seconds = 0.0;  // of all programs together
  double peak_mb = 0.0;  // of the largest
};

// "surge,sway,yaw".
std::string JoinedNames(const std::vector<Dof>& dofs);

// The name of the page of a diagnosis within LogJobOptions::pages:
// "dive_1_run_3_surge_1f0e9c2a.html". `dofs`: a name, or JoinedNames().
std::string PageNameOf(const std::string& path, std::string_view dofs);

// Of a log that was found, before anything is done with it.
LogOutcome OutcomeOfFound(const FoundLog& log, const std::string& content);

// Goes over to the log that a program makes, or has made, of it.
void TakeMadeLog(const std::string& program, const LogJobOptions& options, LogOutcome* outcome);

// Makes a log of a recording (fathom_import) or of images (fathom_track), and surveys it. Where the
// state is kOk, RunPrograms() can go on.
LogOutcome PrepareLog(const FoundLog& log,
                      const std::string& content,
                      const LogJobOptions& options,
                      const ProgramSettings& settings,
                      const RunBook& book);

// Runs fathom_compare and fathom_diagnose on a log that is prepared, for each DOF that it can
// identify, one after the other; then, where the options ask for it, one fathom_diagnose --dofs.
LogOutcome RunPrograms(LogOutcome prepared,
                       const LogJobOptions& options,
                       const ProgramSettings& settings,
                       const RunBook& book);

}  // namespace fathom
