// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/process/run_child.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// One program on one log or dive, and what came out: what the store keeps, and all else is made of.
struct RunRecord {
  std::string key;        // DigestOf() everything that decides what comes out
  std::string program;    // "fathom_compare"
  std::string arguments;  // as on the command line
  std::string version;    // of Fathom
  std::string limits;     // of time and memory
  ChildEnd end = ChildEnd::kNotStarted;
  int exit_code = -1;
  int signal = 0;
  double seconds = 0.0;
  double peak_mb = 0.0;
  std::string output;   // the JSON file that it wrote, verbatim; empty if it wrote none
  std::string message;  // the last line of its stderr
};

// Whether the program gave a usable result.
bool IsUsable(const RunRecord& run);

// Whether it would end like this whenever it is run: it exited, and not for want of memory. No
// signal came in its way and no limit of today.
bool IsFinal(const RunRecord& run);

// Why not usable, in few words: "crashed (SIGSEGV)", "killed after 600 s", or what the program
// said.
std::string WhyNot(const RunRecord& run);

// Runs that are known already. Both are called from several threads.
struct RunBook {
  std::function<std::optional<RunRecord>(const std::string& key)> find;
  std::function<void(const RunRecord&)> keep;
};

}  // namespace fathom
