// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/jobs/run_record.h"
#include "fathom/process/run_child.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fathom {

// How a batch runs Fathom's programs.
struct ProgramSettings {
  std::filesystem::path tools;  // the folder that they stand in
  std::filesystem::path work;   // a folder for the files that pass between them
  std::string version;          // of Fathom
  ChildLimits limits;           // of each

  // The vehicle file of archive.yaml, and the digest of what of it decides; empty: there is none.
  std::filesystem::path vehicle;
  std::string vehicle_content;
};

struct ProgramCall {
  std::string program;                     // "fathom_compare"
  std::vector<std::string> contents = {};  // digests of what it reads
  std::vector<std::string> flags = {};     // that decide what comes out: "--dof=surge"
  std::vector<std::string> places = {};    // what does not: where it reads, "--log=...", and how
  bool takes_vehicle = true;               // of archive.yaml, for logs that name none
  std::string output = {};                 // the flag of its JSON file; empty: it is on stdout
};

// What decides the result: the program, its version, its flags and the bytes it reads.
std::string KeyOf(const ProgramCall& call, const ProgramSettings& settings);

// Runs it, or takes the run from the book. A run that somebody ended from outside, that did not
// start or that reached another limit than today's is made again.
RunRecord RunProgram(const ProgramCall& call, const ProgramSettings& settings, const RunBook& book);

}  // namespace fathom
