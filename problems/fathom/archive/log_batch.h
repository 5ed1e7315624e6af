// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/batch_coupled.h"
#include "fathom/archive/batch_dof.h"
#include "fathom/archive/batch_session.h"
#include "fathom/archive/dives/archive_settings.h"
#include "fathom/archive/jobs/dive_jobs.h"
#include "fathom/archive/jobs/log_jobs.h"
#include "fathom/archive/jobs/run_in_parallel.h"
#include "fathom/archive/log_contents.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
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

// What the work on whole dives has to know of a log.
struct BatchLog {
  DiveLog log;
  std::string dive, vehicle;
  std::filesystem::path vehicle_file;  // empty: none
  double start = std::numeric_limits<double>::quiet_NaN();

  // Known once the programs have run on it.
  bool is_done = false;
  LogState state = LogState::kOk;
  std::vector<BatchDof> dofs;  // that it can identify, alone or with others
  std::optional<BatchCoupled> coupled;
  bool is_final = true;  // false: a later batch has to run it again
};

struct LogBatch {
  std::vector<BatchLog> logs;
  std::size_t num_run = 0;  // logs that something was run for
  std::map<std::pair<std::string, std::string>, std::string> pages;  // by log and DOF
};

// What the rows of a log are made of, as a digest: its content, place, version and options.
std::string DoneDigest(const HashedLog& log, const LogBatchOptions& options);

// What may begin now, given all logs: asked under the mutex, when the last of them is surveyed and
// at each one that is done from then on.
using Followers = std::function<std::vector<Job>(const std::vector<BatchLog>&)>;

// Runs the programs on every log, so many at a time, and what follows from that. Writes the rows of
// each log into the store as it is done.
LogBatch RunLogs(const std::vector<HashedLog>& logs,
                 const LogBatchOptions& options,
                 int at_a_time,
                 const Followers& followers,
                 BatchSession* session);

}  // namespace fathom
