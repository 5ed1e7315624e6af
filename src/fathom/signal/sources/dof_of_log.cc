// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/sources/dof_of_log.h"

#include "fathom/base/input_error.h"
#include "fathom/signal/sources/log_column.h"

#include <fmt/format.h>

namespace fathom {

Dof DofOfAll(std::span<const Log> logs, std::optional<Dof> given) {
  if (given) return *given;
  for (const Log& log : logs) {
    if (log.dofs.size() != 1) {
      throw InputError(fmt::format("--dof: is missing, and {} names {} DOFs; say which.",
                                   FileOf(log, "log.yaml"),
                                   log.dofs.size()));
    }
    if (log.dofs != logs.front().dofs) {
      throw InputError(fmt::format("--dof: is missing, and {} names {}, but {} {}; say which.",
                                   FileOf(logs.front(), "log.yaml"),
                                   Name(logs.front().dofs.front()),
                                   FileOf(log, "log.yaml"),
                                   Name(log.dofs.front())));
    }
  }
  return logs.front().dofs.front();
}

}  // namespace fathom
