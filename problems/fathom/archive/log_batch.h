// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/batch_progress.h"
#include "fathom/archive/dives/archive_settings.h"
#include "fathom/archive/jobs/dive_jobs.h"
#include "fathom/archive/jobs/log_jobs.h"
#include "fathom/archive/log_contents.h"
#include "fathom/archive/store/store.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fathom {

struct LogBatchOptions {
  ArchiveSettings settings;
  std::string vehicle_content;  // of the vehicle file in the settings; empty: none
  LogJobOptions jobs;
  ProgramSettings programs;
};

// One DOF of a log, for the joint fit of its dive.
struct DoneDof {
  Dof dof = Dof::kSurge;
  std::string why_left_out;  // empty: it is to be fitted with the others
  double own_nmae = std::numeric_limits<double>::quiet_NaN();  // of its own model by output error
};

// What the work on whole dives has to know of a log.
struct DoneLog {
  DiveLog log;
  std::string dive, vehicle;
  std::filesystem::path vehicle_file;  // empty: none
  double start = std::numeric_limits<double>::quiet_NaN();
  LogState state = LogState::kOk;
  std::vector<DoneDof> dofs;  // that it can identify, alone or with others
  bool is_final = true;       // false: a later batch has to run it again
};

struct LogBatch {
  std::vector<DoneLog> logs;
  std::size_t num_run = 0;  // logs that something was run for
  std::map<std::pair<std::string, std::string>, std::string> pages;  // by log and DOF
};

// What the rows of a log are made of, as a digest: its content, place, version and options.
std::string DoneDigest(const HashedLog& log, const LogBatchOptions& options);

// Runs the programs on every log, so many at a time, and writes the rows of each into the store as
// it is done.
LogBatch RunLogs(const std::vector<HashedLog>& logs,
                 const LogBatchOptions& options,
                 int at_a_time,
                 Store* store,
                 const std::function<void(const BatchProgress&)>& show);

// The store as a book of runs, for several threads.
RunBook BookOf(Store* store, std::mutex* mutex);

}  // namespace fathom
