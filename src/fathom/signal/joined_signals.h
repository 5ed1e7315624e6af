// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/signal/signals.h"
#include "fathom/signal/sources/source.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fathom {

// The signals of several logs as one, to be fitted together: a segment of each or more.
struct JoinedSignals {
  Signals all;
  std::vector<std::size_t> log_of_train;  // the index of each segment's log
  std::vector<std::size_t> log_of_held_out;
};

// Along `dof` (absent: the only one that each log names) from `source` (absent: the best that each
// log has).
//
// Throws InputError as SignalsOf() does, or if the logs differ in DOF, source or command unit.
JoinedSignals JoinSignals(std::span<const Log> logs,
                          std::optional<Dof> dof,
                          std::optional<Source> source);

}  // namespace fathom
