// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace fathom {

// What a tool says about itself with --help.
struct ToolInfo {
  std::string name;     // "fathom_identify"
  std::string summary;  // one sentence
  std::string usage;    // the flags it is called with: "--log=LOG --dof=DOF [--model=FILE]"
  std::string example;  // one command line, or several, that work on the bundled data
  std::string details;  // optional: what the outputs and exit codes mean, further lines

  // Text flags that may be given several times: RepeatedValues() takes their values apart.
  std::vector<std::string> repeatable_flags = {};

  // The text flag that an argument without a name is the value of; empty: there is none.
  std::string positional_flag = {};

  // What the exit codes mean.
  std::string exit_codes = "0: a usable result; 1: input or flags cannot be used; 2: no usable fit";
};

// The frame of every tool: reads the flags that gflags knows from the tools' own files, calls
// `run` and returns its exit code.
//
//   int main(int argc, char** argv) { return fathom::RunTool(argc, argv, kInfo, Run); }
//
// Flags are --name=value, --name value, and for a bool --name or --noname. --help, --version and
// --flags (for completion: a line "--name=", or "--name" of a bool, for each flag) print to stdout
// and return 0. Returns 1, with "<name>: <what is wrong>" on stderr, for an unknown, wrongly
// repeated or malformed flag, an argument that has no name (but for positional_flag) and what
// ReportProblems() says. Warnings go to stderr.
int RunTool(int argc, char** argv, const ToolInfo& info, const std::function<int()>& run);

// How the running tool was called: its name and its arguments, those in quotes that a shell would
// take apart. Empty before RunTool().
const std::string& CommandLine();

// Calls `run` and returns its exit code. Returns 1, with "<name>: <what is wrong>" on stderr, for
// any exception out of it (InputError is the expected one) and a stdout that cannot be written; 4
// where the memory does not suffice.
int ReportProblems(const std::string& name, const std::function<int()>& run);

// The value of a flag that has to be given. Throws InputError if it is empty: "--log: is missing,
// expected <expected>."
const std::string& RequireFlag(const std::string& name,
                               const std::string& value,
                               const std::string& expected);

}  // namespace fathom
