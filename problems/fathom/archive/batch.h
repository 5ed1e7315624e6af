// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/batch_progress.h"
#include "fathom/archive/dives/nearly_log.h"
#include "fathom/archive/jobs/log_state.h"
#include "fathom/base/dof.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// One part of many: the logs whose content, taken as a number, leaves this rest.
struct Shard {
  int index = 0;  // from 0 to count - 1
  int count = 1;
};

struct BatchOptions {
  std::filesystem::path archive;  // a folder; nothing is written into it
  std::filesystem::path results;  // an SQLite database, made if it is missing
  std::filesystem::path tools;    // the folder of Fathom's programs
  std::string version;            // of Fathom
  std::string families;           // of fathom_compare, comma-separated; empty: all
  std::string weighting;          // of fathom_compare and fathom_identify; empty: their own
  bool diagnose = true;           // run fathom_diagnose on every log
  // Of a coupled model of each log, in their order. Empty: those that the log moves. None: there is
  // no such model.
  std::optional<std::vector<Dof>> coupled_dofs;
  int jobs = 1;                  // programs at a time
  double time_limit = 600.0;     // of each program [s]
  double memory_limit = 2000.0;  // of each program [MB]
  bool rehash = false;           // hash also the files of unchanged size and time of change
  std::filesystem::path pages;   // a folder for the pages of the diagnoses; empty: none
  std::optional<Shard> shard;    // run only this part, and nothing on whole dives
  std::vector<std::filesystem::path> merge;  // results whose runs are taken over first

  // Every broken rule, a sentence each, by the name of the flag; empty if there is none.
  std::vector<std::string> Problems() const;
};

// What a batch found and did.
struct BatchSummary {
  std::map<LogState, int> states;          // of all logs, or of those of the shard
  std::vector<std::string> dives;          // in their order
  std::map<std::string, int> other_files;  // that are no logs, by kind
  std::vector<NearlyLog> nearly_logs;
  std::size_t num_run = 0;  // logs that something had to be run for
  // Pages of diagnoses that are there, by log and DOF: names within BatchOptions::pages.
  std::map<std::pair<std::string, std::string>, std::string> pages;
};

// What a batch would do: how many logs are new or changed, and how many were done by which other
// version of Fathom.
struct BatchPlan {
  std::size_t num_logs = 0;
  std::size_t num_to_do = 0;
  std::map<std::string, int> done_by_version;  // of what is to be done again
  std::map<std::string, int> other_files;
  std::vector<NearlyLog> nearly_logs;
};

// Reprocesses an archive into its results; docs/archive.md. What was done before, by this version
// with these options on the same bytes, is not done again. A log that fails costs no other one.
//
// Throws InputError for options that break their rules, an archive that cannot be read, and results
// that cannot be written or that another batch is writing.
BatchSummary RunBatch(const BatchOptions& options,
                      const std::function<void(const BatchProgress&)>& show = {});

// Nothing is ever written into an archive: throws InputError if the place that a flag names lies in
// it. An empty place lies nowhere.
void RequireOutsideArchive(std::string_view flag,
                           const std::filesystem::path& place,
                           const std::filesystem::path& archive);

// Looks at the archive, hashes its logs into the results and runs nothing.
BatchPlan PlanBatch(const BatchOptions& options);

}  // namespace fathom
