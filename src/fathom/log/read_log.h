// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/time_interval.h"
#include "fathom/log/log.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace fathom {

struct ReadLogOptions {
  // The DOF of a single CSV `t,tau,v`; for a folder it may stay empty.
  std::optional<Dof> dof = {};

  // Read this file as the velocity stream instead of the log's velocity.csv.
  std::filesystem::path velocity = {};

  // Held out in place of what log.yaml says, as HoldOut() has it; empty: what that says.
  std::vector<TimeInterval> held_out = {};

  // Factors of columns of the velocity stream, in place of what log.yaml says of the same column.
  std::vector<Correction> corrections = {};
  std::string corrections_by = "--correct";  // what asks for them, in messages

  // True: a folder with none of velocity.csv, pose.csv, detections.csv will do, for predictions and
  // for images.
  bool may_lack_motion = false;

  // True: a folder without command.csv will do, or a single CSV `t,v`, where only the motion is
  // asked for.
  bool may_lack_command = false;
};

// Reads a log folder, or a single CSV with columns t, tau, v.
//
// Throws InputError, naming file, line and column, for whatever breaks the format; nothing is
// skipped or repaired.
Log ReadLog(const std::filesystem::path& path, const ReadLogOptions& options = {});

}  // namespace fathom
