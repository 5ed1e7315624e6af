// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace fathom {

// What a child may take. Infinite: no limit.
struct ChildLimits {
  double wall_time = std::numeric_limits<double>::infinity();  // [s]
  double cpu_time = std::numeric_limits<double>::infinity();   // [s], rounded up to whole ones
  double memory = std::numeric_limits<double>::infinity();     // of address space [bytes]
};

struct ChildCommand {
  std::string program;                 // a path, or a name that is looked for in PATH
  std::vector<std::string> arguments;  // without the program's name
  ChildLimits limits = {};

  // Of each of stdout and stderr, the last so many bytes are kept.
  std::size_t most_output = std::size_t{64} << 20;

  // Called with its process id, for who wants to send it a signal.
  std::function<void(int)> on_start = {};
};

enum class ChildEnd {
  kExited,
  kSignalled,    // a signal ended it that this function did not send
  kTimedOut,     // it was killed at its limit of wall time or CPU time
  kOutOfMemory,  // it failed, and had come near its limit of memory
  kNotStarted,   // there is no such program, or it is none
};

struct ChildResult {
  ChildEnd end = ChildEnd::kNotStarted;
  int exit_code = -1;  // where it exited; 128 plus the signal's number where a signal ended it
  int signal = 0;      // where one ended it
  std::string out;     // what it wrote to stdout
  std::string err;     // what it wrote to stderr, or why it did not start
  double seconds = 0.0;
  double cpu_seconds = 0.0;
  double peak_memory = 0.0;  // resident, at most [bytes]
};

// Runs a program to its end, without a shell, in a process group of its own that is killed as a
// whole in the end. stdin is empty. May be called from several threads at once. If the calling
// process dies, also by SIGKILL, the child dies with it.
//
// Built with the address sanitizer, which reserves terabytes, no limit of memory is set.
ChildResult RunChild(const ChildCommand& command);

}  // namespace fathom
