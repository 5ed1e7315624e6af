// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/run_record.h"

#include "fathom/base/exit_code.h"

#include <cstring>

#include <fmt/format.h>

namespace fathom {

bool IsUsable(const RunRecord& run) { return run.end == ChildEnd::kExited && run.exit_code == 0; }

bool IsFinal(const RunRecord& run) {
  return run.end == ChildEnd::kExited && run.exit_code != kExitOutOfMemory;
}

std::string WhyNot(const RunRecord& run) {
  switch (run.end) {
    case ChildEnd::kSignalled:
      return fmt::format("crashed by signal {} ({})", run.signal, strsignal(run.signal));
    case ChildEnd::kTimedOut:
      return "killed at its time limit";
    case ChildEnd::kOutOfMemory:
      return "failed at its memory limit";
    case ChildEnd::kNotStarted:
      return fmt::format("did not start: {}", run.message);
    case ChildEnd::kExited:
      break;
  }
  if (run.exit_code == 0) return "";
  return run.message.empty() ? fmt::format("exit code {}", run.exit_code) : run.message;
}

}  // namespace fathom
